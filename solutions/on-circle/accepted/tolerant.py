"""distance, with a tolerance

The distance of P from the centre against the radius, within 1e-9 of the figure's size. Everything is seen from the
centre, so that a small circle far from the origin keeps its digits.
"""

from math import hypot


def on_circle(cx, cy, r, P):
    fx, fy = P[0] - cx, P[1] - cy
    size = max(r, abs(fx), abs(fy))
    gap = hypot(fx, fy) - r
    if abs(gap) <= 1e-9 * size:
        return 0
    return 1 if gap > 0 else -1
