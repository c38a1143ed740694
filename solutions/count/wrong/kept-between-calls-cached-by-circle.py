"""kept-between-calls

Answers are kept in a dict whose key is the circle alone, so that another line gets the answer of the first
one. Make all arguments the key, or keep nothing.
"""

from math import hypot

answers = {}


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    if (cx, cy, r) in answers:
        return answers[cx, cy, r]
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(d - r) <= 1e-10 * e:
        answers[cx, cy, r] = 1
    else:
        answers[cx, cy, r] = 2 if d < r else 0
    return answers[cx, cy, r]
