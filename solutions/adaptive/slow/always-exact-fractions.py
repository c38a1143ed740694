"""always-exact

Every line is decided in Fractions, also those that a double decides. That is right, and takes seventy times as long
as a filter. Compare |Δ| with a bound of its roundings first.
"""

from fractions import Fraction


def delta_sign(*numbers):
    cx, cy, r, ax, ay, bx, by = map(Fraction, numbers)
    dx, dy = bx - ax, by - ay
    delta = r * r * (dx * dx + dy * dy) - (dx * (ay - cy) - dy * (ax - cx)) ** 2
    return (delta > 0) - (delta < 0)
