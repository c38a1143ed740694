"""sign-of-the-cross-product-form

r²·a - k² with a = |B - A|² and the cross product k: one subtraction of integers, whose sign is the
answer.
"""


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    delta = r * r * (dx * dx + dy * dy) - k * k
    return 1 + (delta > 0) - (delta < 0)
