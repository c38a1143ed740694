"""loose-origin

Anything within 1e-5 of the extent from the origin is called t = 0, also where it clearly is not.
Use a slack well below the promise's wider band: 1e-10 of the extent.
"""

from math import copysign, hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    extent = max(r, abs(fx), abs(fy))
    d = abs(D[0] * fy - D[1] * fx) / n
    m = -(fx * D[0] + fy * D[1]) / n
    if d > r + 1e-10 * extent:
        return None
    if d >= r - 1e-10 * extent:
        roots = [m]
    else:
        outer = m + copysign(sqrt((r - d) * (r + d)), m)
        roots = sorted([outer, (fx * fx + fy * fy - r * r) / outer])
    for s in roots:
        if s >= -1e-5 * extent:
            return 0 if s <= 1e-5 * extent else s / n
    return None
