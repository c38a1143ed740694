"""kept-between-calls

Answers are kept in a dict whose key is the line alone, so that another point gets the answer of the first one.
Make all three points the key, or keep nothing.
"""

from math import hypot

answers = {}


def distance(A, B, P):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    if (A, B) not in answers:
        answers[A, B] = abs(dx * (A[1] - P[1]) - dy * (A[0] - P[0])) / hypot(dx, dy)
    return answers[A, B]
