"""kept-between-calls

Answers are kept in a dict whose key is everything but B, so that another one gets the
answer of the first one. Make all of them the key, or keep nothing.
"""

answers = {}


def crossings(cx, cy, r, A, B):
    if (cx, cy, r, A) not in answers:
        dx, dy = B[0] - A[0], B[1] - A[1]
        k = dx * (cy - A[1]) - dy * (cx - A[0])
        gap = r * r * (dx * dx + dy * dy) - k * k
        answers[cx, cy, r, A] = 2 if gap > 0 else 1 if gap == 0 else 0
    return answers[cx, cy, r, A]
