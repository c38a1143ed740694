"""radius-not-squared

The equation is |P - C|² = r instead of r².
Square the radius.
"""

from math import sqrt


def ray_nearest(cx, cy, r, O, D):
    dx, dy = D
    fx, fy = O[0] - cx, O[1] - cy
    a = dx * dx + dy * dy
    if a == 0:
        return None
    b = fx * dx + fy * dy
    disc = b * b - a * (fx * fx + fy * fy - r)
    if disc < 0:
        return None
    for t in ((-b - sqrt(disc)) / a, (-b + sqrt(disc)) / a):
        if t >= -1e-12:
            return max(t, 0)
    return None
