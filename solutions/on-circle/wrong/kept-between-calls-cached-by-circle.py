"""kept-between-calls

Answers are kept under the circle alone, so that another point gets the answer of the first one. Make all arguments
the key, or keep nothing.
"""

from math import hypot


def on_circle(cx, cy, r, P, known={}):
    key = cx, cy, r
    if key in known:
        return known[key]
    away = hypot(P[0] - cx, P[1] - cy)
    known[key] = 0 if abs(away - r) <= 1e-10 * max(away, r) else 1 if away > r else -1
    return known[key]
