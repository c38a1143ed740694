"""pythagoras

The two legs stand at a right angle, so the sum of their squares is the square of the distance.
"""

from math import sqrt


def two_points(P, Q):
    dx, dy = Q[0] - P[0], Q[1] - P[1]
    return sqrt(dx * dx + dy * dy)
