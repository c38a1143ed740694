"""exact

Fractions, and no tolerance: d < r·(1 − h) is a comparison of squares.
"""

from fractions import Fraction


def steady_hits(circles, O, D, h):
    dx, dy, h = map(Fraction, (*D, h))
    a = dx * dx + dy * dy
    answer = []
    for circle in circles:
        x, y, r = map(Fraction, circle)
        square = (dx * (Fraction(O[1]) - y) - dy * (Fraction(O[0]) - x)) ** 2
        if not answer:
            answer.append(int(square < r * r * a))
        elif answer[-1]:
            answer.append(int(square <= (r * (1 + h)) ** 2 * a))
        else:
            answer.append(int(square < (r * (1 - h)) ** 2 * a))
    return answer
