"""kept-between-calls

Answers are kept in a dict whose key is the diameter alone, so that another P gets the answer of the first one. Make all
three points the key, or keep nothing.
"""

answers = {}


def diameter_side(A, B, P):
    if (A, B) not in answers:
        dot = (A[0] - P[0]) * (B[0] - P[0]) + (A[1] - P[1]) * (B[1] - P[1])
        answers[A, B] = (dot > 0) - (dot < 0)
    return answers[A, B]
