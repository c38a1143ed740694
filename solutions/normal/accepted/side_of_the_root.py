"""side of the root

Of the two roots the lesser enters and the greater leaves: that is the sign, and no product with D is needed.
"""

from math import copysign, hypot, sqrt


def hit_normal(cx, cy, r, O, D):
    dx, dy = D
    fx, fy = O[0] - cx, O[1] - cy
    a = dx * dx + dy * dy
    if not (a and r):
        return None
    e = max(r, abs(fx), abs(fy))
    b, c = fx * dx + fy * dy, (hypot(fx, fy) - r) * (hypot(fx, fy) + r)
    k, size = dx * fy - dy * fx, sqrt(a)
    gap = abs(k) / size - r
    if gap > 1e-10 * e:
        return None
    if gap >= -1e-10 * e:
        sides = [(-b / a, 1)]
    else:
        q = -b - copysign(sqrt((r * size - abs(k)) * (r * size + abs(k))), b)
        low, high = sorted((q / a, c / q))
        sides = [(low, 1), (high, -1)]
    for t, side in sides:
        if t * size > -1e-10 * e:
            return side * (fx + t * dx) / r, side * (fy + t * dy) / r
    return None
