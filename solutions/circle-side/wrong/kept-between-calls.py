"""kept-between-calls

Answers are kept in a dict whose key is P and the centre, so that another r gets the answer of the first one. Make all
four the key, or keep nothing.
"""

answers = {}


def circle_side(cx, cy, r, P):
    if (cx, cy, P) not in answers:
        gap = (P[0] - cx) ** 2 + (P[1] - cy) ** 2 - r * r
        answers[cx, cy, P] = (gap > 0) - (gap < 0)
    return answers[cx, cy, P]
