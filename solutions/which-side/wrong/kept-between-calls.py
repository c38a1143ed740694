"""kept-between-calls

Answers are kept in a dict whose key is the line alone, so that another P gets the answer of the first one. Make all
three points the key, or keep nothing.
"""

answers = {}


def which_side(A, B, P):
    if (A, B) not in answers:
        cross = (B[0] - A[0]) * (P[1] - A[1]) - (B[1] - A[1]) * (P[0] - A[0])
        answers[A, B] = (cross > 0) - (cross < 0)
    return answers[A, B]
