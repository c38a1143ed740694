"""exact-for-ints

Ints are compared exactly, and only floats within the band. The statement's band is the same for both types: P is on
the circle if it is 1e-12 of the extent away, in ints as well.
"""

from math import hypot, sqrt


def tangent_points(cx, cy, r, P):
    if r == 0:
        return [(cx, cy)]
    fx, fy = P[0] - cx, P[1] - cy
    square, d = fx * fx + fy * fy, hypot(fx, fy)
    on = square == r * r if isinstance(square + r, int) else abs(d - r) <= 1e-10 * max(d, r)
    if on:
        return [P]
    if square < r * r:
        return []
    a, b = (r / d) ** 2, r / d * (sqrt(square - r * r) / d)
    return [(cx + a * fx + s * b * fy, cy + a * fy - s * b * fx) for s in (1, -1)]
