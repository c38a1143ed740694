"""absolute-epsilon

The tangency is measured by the figure, but what is within 1e-9 of the origin is t = 0, whatever its size.
Give the origin the same slack as the tangency: 1e-10 of the extent.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    if D[0] == D[1] == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    if abs(hypot(fx, fy) - r) < 1e-9:
        return 0
    n = hypot(D[0], D[1])
    near = 1e-10 * max(r, abs(fx), abs(fy))
    d = abs(D[0] * fy - D[1] * fx) / n
    m = -(fx * D[0] + fy * D[1]) / n
    if d > r + near:
        return None
    if d >= r - near:
        roots = [m]
    else:
        h = sqrt((r - d) * (r + d))
        c = fx * fx + fy * fy - r * r
        roots = [c / (m + h), m + h] if m > 0 else [m - h, c / (m - h)]
    for s in roots:
        if s > 0:
            return s / n
    return None
