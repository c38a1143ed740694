"""kept-between-calls

Answers are kept in a dict whose key is the point and the centre, so that another radius gets the answer of the
first one. Make all arguments the key, or keep nothing.
"""

from math import hypot

answers = {}


def on_circle(cx, cy, r, P):
    if (cx, cy, P) not in answers:
        fx, fy = P[0] - cx, P[1] - cy
        gap = hypot(fx, fy) - r
        near = 1e-10 * max(r, abs(fx), abs(fy))
        answers[cx, cy, P] = 0 if abs(gap) <= near else 1 if gap > 0 else -1
    return answers[cx, cy, P]
