"""filter-by-distance-and-fractions

The filter compares r·|D| with |k|, two lengths times |D| rather than their squares; behind it, Fractions.
"""

from fractions import Fraction
from math import sqrt


def delta_sign(cx, cy, r, ax, ay, bx, by):
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    p, q = dx * fy, dy * fx
    reach, k = r * sqrt(dx * dx + dy * dy), abs(p - q)
    slack = 2e-15 * (reach + abs(p) + abs(q))
    if reach - k > slack:
        return 1
    if k - reach > slack:
        return -1
    cx, cy, r, ax, ay, bx, by = map(Fraction, (cx, cy, r, ax, ay, bx, by))
    dx, dy = bx - ax, by - ay
    delta = r * r * (dx * dx + dy * dy) - (dx * (ay - cy) - dy * (ax - cx)) ** 2
    return (delta > 0) - (delta < 0)
