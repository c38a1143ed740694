"""null-on-circle

For D = (0, 0) with the origin on the circle 0 is returned, as if there were a ray of one point.
The statement calls it no ray: the answer is None wherever the origin is.
"""

from math import copysign, hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    if abs(hypot(fx, fy) - r) <= near:
        return 0
    n = hypot(*D)
    if n == 0:
        return None
    d = abs(D[0] * fy - D[1] * fx) / n
    m = -(fx * D[0] + fy * D[1]) / n
    if d > r + near:
        return None
    if d >= r - near:
        return m / n if m >= 0 else None
    outer = m + copysign(sqrt((r - d) * (r + d)), m)
    ahead = [s for s in (outer, (fx * fx + fy * fy - r * r) / outer) if s > 0]
    return min(ahead) / n if ahead else None
