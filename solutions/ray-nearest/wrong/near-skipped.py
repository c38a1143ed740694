"""near-skipped

Common points within 1e-6 of the size ahead of the origin are skipped, so that a ray does not meet
the circle that it has just left. But here the origin on the circle is t = 0, and a point just ahead
of it is where the ray meets the circle. Give the nearest point that is not behind the origin.
"""

from math import copysign, hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    size = max(r, abs(fx), abs(fy))
    slack = 1e-10 * size
    d = abs(D[0] * fy - D[1] * fx) / n
    m = -(fx * D[0] + fy * D[1]) / n
    if d > r + slack:
        return None
    if d >= r - slack:
        roots = [m]
    else:
        outer = m + copysign(sqrt((r - d) * (r + d)), m)
        roots = sorted([outer, (fx * fx + fy * fy - r * r) / outer])
    for s in roots:
        if abs(s) <= slack:
            return 0
        if s > 1e-6 * size:
            return s / n
    return None
