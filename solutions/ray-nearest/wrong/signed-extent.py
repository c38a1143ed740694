"""signed-extent

The coordinates of O seen from C go into the extent with their signs, so that an origin far to the left or below
counts for nothing. Take their absolute values.
"""

import math


def ray_nearest(cx, cy, r, O, D):
    length = math.hypot(*D)
    if length == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, fx, fy)
    height = abs(D[0] * fy - D[1] * fx) / length
    foot = -(D[0] * fx + D[1] * fy) / length
    if height > r + near:
        return None
    if height >= r - near:
        candidates = [foot]
    else:
        half = math.sqrt((r - height) * (r + height))
        outer = foot + math.copysign(half, foot)
        candidates = sorted([outer, (fx * fx + fy * fy - r * r) / outer])
    for s in candidates:
        if abs(s) <= near:
            return 0.0
        if s > 0:
            return s / length
    return None
