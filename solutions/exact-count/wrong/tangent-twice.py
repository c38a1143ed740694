"""tangent-twice

The two roots are counted without asking whether they are the same one. They are when the
discriminant is 0: answer 1.
"""


def exact_count(cx, cy, r, A, B):
    px, py, qx, qy = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    if px == qx and py == qy:
        return None
    length_squared = (qx - px) ** 2 + (qy - py) ** 2
    if (px * qy - py * qx) ** 2 > r**2 * length_squared:
        return 0
    return 2
