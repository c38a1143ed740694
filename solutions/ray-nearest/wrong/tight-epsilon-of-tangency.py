"""tight-epsilon

The distance and the radius must agree within the machine epsilon of the extent, less than what the
statement calls touching. Stay between the two bands of the promise: 1e-10.
"""

import sys
from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    extent = max(r, abs(fx), abs(fy))
    touch, zero = sys.float_info.epsilon * extent, 1e-10 * extent
    d = abs(D[0] * fy - D[1] * fx) / n
    foot = -(fx * D[0] + fy * D[1]) / n
    if d > r + touch:
        return None
    if d >= r - touch:
        roots = [foot]
    else:
        half = sqrt((r - d) * (r + d))
        far = foot + half if foot > 0 else foot - half
        roots = sorted([far, (fx * fx + fy * fy - r * r) / far])
    for s in roots:
        if s >= -zero:
            return 0 if s <= zero else s / n
    return None
