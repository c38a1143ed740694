"""kept-between-calls

Answers are kept in a dict whose key is P alone, so that another Q gets the answer of the first one. Make both
points the key, or keep nothing.
"""

answers = {}


def distance_squared(P, Q):
    if P not in answers:
        answers[P] = (P[0] - Q[0]) ** 2 + (P[1] - Q[1]) ** 2
    return answers[P]
