"""diagonals

In u = x + y and v = x - y the figure is turned by 45° and drawn larger by the root of 2, so that the squares
of the two differences add up to twice the answer. That sum is always even.
"""


def distance_squared(P, Q):
    u = (Q[0] + Q[1]) - (P[0] + P[1])
    v = (Q[0] - Q[1]) - (P[0] - P[1])
    return (u * u + v * v) // 2
