"""exact-rational

A float is a fraction, so the whole question can be asked of fractions, bands included, with squares
instead of roots: d ≤ x is the same as k² ≤ x²·a for x ≥ 0.
"""

from fractions import Fraction

BAND = Fraction(1, 10**10)


def line_count(cx, cy, r, A, B):
    cx, cy, r, ax, ay, bx, by = (Fraction(v) for v in (cx, cy, r, *A, *B))
    ax, ay, bx, by = ax - cx, ay - cy, bx - cx, by - cy
    dx, dy = bx - ax, by - ay
    a = dx * dx + dy * dy
    if a == 0:
        return None
    k2 = (dx * ay - dy * ax) ** 2
    band = BAND * max(r, abs(ax), abs(ay), abs(bx), abs(by))
    if k2 > (r + band) ** 2 * a:
        return 0
    if r > band and k2 < (r - band) ** 2 * a:
        return 2
    return 1
