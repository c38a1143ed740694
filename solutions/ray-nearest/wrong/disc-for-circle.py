"""disc-for-circle

The circle is taken for a disc: from inside the answer is 0.
The circle is the curve: from inside the ray meets it where it leaves.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    if hypot(fx, fy) <= r + near:
        return 0
    d = abs(D[0] * fy - D[1] * fx) / n
    m = -(fx * D[0] + fy * D[1]) / n
    if d > r + near or m < 0:
        return None
    h = sqrt((r - d) * (r + d)) if d < r - near else 0
    return (fx * fx + fy * fy - r * r) / (m + h) / n
