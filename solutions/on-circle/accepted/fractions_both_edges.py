"""fractions, both edges of the band

Exactly, and by the statement's word: P is on the circle if |f|² is between the squares of r − snap·e and
r + snap·e.
"""

from fractions import Fraction

SNAP = Fraction(1, 10**12)


def on_circle(cx, cy, r, P):
    r, fx, fy = Fraction(r), Fraction(P[0]) - Fraction(cx), Fraction(P[1]) - Fraction(cy)
    width = SNAP * max(r, abs(fx), abs(fy))
    square = fx * fx + fy * fy
    if square > (r + width) ** 2:
        return 1
    return -1 if r > width and square < (r - width) ** 2 else 0
