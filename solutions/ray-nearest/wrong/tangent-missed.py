"""tangent-missed

Only a positive discriminant counts, so a tangent line is a miss.
Treat the tangency as a case of its own: t of the foot of the perpendicular.
"""

from math import copysign, hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    px, py = O[0] - cx, O[1] - cy
    eps = 1e-10 * max(r, abs(px), abs(py))
    d = abs(D[0] * py - D[1] * px) / n
    if d >= r - eps:
        return None
    m = -(D[0] * px + D[1] * py) / n
    outer = m + copysign(sqrt((r - d) * (r + d)), m)
    for s in sorted([outer, (px * px + py * py - r * r) / outer]):
        if s >= -eps:
            return 0 if s <= eps else s / n
    return None
