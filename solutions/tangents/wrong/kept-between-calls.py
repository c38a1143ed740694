"""kept-between-calls

Answers are kept under the circle alone, so that another point gets the answer of the first one. Make all arguments
the key, or keep nothing.
"""

from math import hypot, sqrt


def tangent_points(cx, cy, r, P, known={}):
    key = cx, cy, r
    if key not in known:
        known[key] = touching(cx, cy, r, P)
    return known[key]


def touching(cx, cy, r, P):
    fx, fy = P[0] - cx, P[1] - cy
    d = hypot(fx, fy)
    if r == 0:
        return [(cx, cy)]
    if abs(d - r) <= 1e-10 * max(d, r):
        return [P]
    if d < r:
        return []
    a, b = (r / d) ** 2, r / d * (sqrt((d - r) * (d + r)) / d)
    return [(cx + a * fx + s * b * fy, cy + a * fy - s * b * fx) for s in (1, -1)]
