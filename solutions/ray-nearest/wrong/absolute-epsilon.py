"""absolute-epsilon

Tangency and t = 0 are compared with 1e-9, whatever the size of the figure.
Make the epsilon a small part of the extent: 1e-10 times the largest of r and the coordinates of O seen from C.
"""

import math

EPS = 1e-9


def ray_nearest(cx, cy, r, O, D):
    n = math.hypot(*D)
    if n == 0:
        return None
    ux, uy = D[0] / n, D[1] / n
    fx, fy = O[0] - cx, O[1] - cy
    d = abs(ux * fy - uy * fx)
    m = -(fx * ux + fy * uy)
    if d > r + EPS:
        return None
    if d >= r - EPS:
        roots = [m]
    else:
        h = math.sqrt(r * r - d * d)
        c = fx * fx + fy * fy - r * r
        roots = [c / (m + h), m + h] if m > 0 else [m - h, c / (m - h)]
    for s in roots:
        if s >= -EPS:
            return max(s, 0.0) / n
    return None
