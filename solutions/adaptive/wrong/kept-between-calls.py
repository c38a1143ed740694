"""kept-between-calls

k is remembered by the line alone: the next centre gets that of the one before. Remember nothing, or by all
arguments.
"""

from fractions import Fraction

known = {}


def delta_sign(*numbers):
    cx, cy, r, ax, ay, bx, by = numbers
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    k = known.setdefault((ax, ay, bx, by), dx * fy - dy * fx)
    delta = r * r * (dx * dx + dy * dy) - k * k
    if abs(delta) > 1e-6 * (k * k + r * r * (dx * dx + dy * dy)):
        return 1 if delta > 0 else -1
    cx, cy, r, ax, ay, bx, by = map(Fraction, numbers)
    dx, dy = bx - ax, by - ay
    delta = r * r * (dx * dx + dy * dy) - (dx * (ay - cy) - dy * (ax - cx)) ** 2
    return (delta > 0) - (delta < 0)
