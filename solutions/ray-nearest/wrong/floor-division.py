"""floor-division

`//` stands where `/` is meant, and t snaps to a whole number.
Divide with `/`, which is exact enough for ints as well.
"""

from math import sqrt


def ray_nearest(cx, cy, r, O, D):
    dx, dy = D
    fx, fy = O[0] - cx, O[1] - cy
    a = dx * dx + dy * dy
    if a == 0:
        return None
    b = fx * dx + fy * dy
    disc = r * r * a - (dx * fy - dy * fx) ** 2
    if disc < 0:
        return None
    root = sqrt(disc)
    first, second = (-b - root) // a, (-b + root) // a
    if first >= 0:
        return first
    return second if second >= 0 else None
