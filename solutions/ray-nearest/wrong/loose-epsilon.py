"""loose-epsilon

The epsilon grows with the figure, but 1e-5 of it is so wide that near misses become tangents.
Stay well below the promise's wider band: 1e-10 of the extent.
"""

from math import copysign, hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    speed = hypot(*D)
    if not speed:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    extent = max(r, abs(fx), abs(fy))
    wide, near = 1e-5 * extent, 1e-10 * extent
    off = abs(D[0] * fy - D[1] * fx) / speed
    mid = -(D[0] * fx + D[1] * fy) / speed
    if off > r + wide:
        return None
    if off > r - wide:
        stops = [mid]
    else:
        far = mid + copysign(sqrt((r - off) * (r + off)), mid)
        stops = sorted([far, (fx * fx + fy * fy - r * r) / far])
    for s in stops:
        if abs(s) <= near:
            return 0
        if s > 0:
            return s / speed
    return None
