"""exact-integers-rounded-outward

All seven numbers over one power of two are integers, and so is Δ over its fourth power. The quotient is
rounded to a double, and where that is not the quotient, its neighbours enclose it.
"""

from fractions import Fraction
from math import inf, nextafter


def delta_enclosure(cx, cy, r, ax, ay, bx, by):
    ratios = [x.as_integer_ratio() for x in (cx, cy, r, ax, ay, bx, by)]
    unit = max(bottom for _, bottom in ratios)
    cx, cy, r, ax, ay, bx, by = (top * (unit // bottom) for top, bottom in ratios)
    dx, dy = bx - ax, by - ay
    k = dx * (ay - cy) - dy * (ax - cx)
    delta = Fraction(r * r * (dx * dx + dy * dy) - k * k, unit**4)
    near = float(delta)
    return (near, near) if near == delta else (nextafter(near, -inf), nextafter(near, inf))
