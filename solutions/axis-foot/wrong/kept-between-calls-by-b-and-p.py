"""kept-between-calls

Answers are kept in a dict whose key is B and P, so that another A gets the answer of the first one. Make all three
points the key, or keep nothing.
"""

answers = {}


def axis_foot(A, B, P):
    if (B, P) not in answers:
        answers[B, P] = (P[0], A[1]) if A[1] == B[1] else (A[0], P[1])
    return answers[B, P]
