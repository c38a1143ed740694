"""global-frame

c is expanded into |O|² - 2·O·C + |C|² - r², and far from the origin nothing is left of it.
Subtract C from O first, and compute with the difference.
"""

from math import sqrt


def ray_nearest(cx, cy, r, O, D):
    (ox, oy), (dx, dy) = O, D
    a = dx * dx + dy * dy
    if a == 0:
        return None
    b = (ox * dx + oy * dy) - (cx * dx + cy * dy)
    c = ox * ox + oy * oy - 2 * (ox * cx + oy * cy) + cx * cx + cy * cy - r * r
    near = 1e-10 * max(r, abs(ox - cx), abs(oy - cy))
    disc = b * b - a * c
    limit = 2 * r * near * a
    if disc < -limit:
        return None
    root = sqrt(disc) if disc > limit else 0.0
    for t in ((-b - root) / a, (-b + root) / a):
        if t * sqrt(a) >= -near:
            return 0 if t * sqrt(a) <= near else t
    return None
