"""forgotten-centre

The cross product of A and B measures the distance from the origin. Subtract the centre from both
points first.
"""


def exact_count(cx, cy, r, A, B):
    a = (B[0] - A[0]) ** 2 + (B[1] - A[1]) ** 2
    if a == 0:
        return None
    k = A[0] * B[1] - A[1] * B[0]
    delta = r * r * a - k * k
    return 1 + (delta > 0) - (delta < 0)
