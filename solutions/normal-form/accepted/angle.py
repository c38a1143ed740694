"""angle

The direction has an angle φ; what is on its left lies at φ + 90°, where the cosine is −sin φ and the sine cos φ.
"""

from math import atan2, cos, sin


def normal_form(A, B):
    if tuple(A) == tuple(B):
        return None
    angle = atan2(B[1] - A[1], B[0] - A[0])
    a, b = -sin(angle), cos(angle)
    return a, b, -(a * B[0] + b * B[1])
