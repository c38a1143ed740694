"""discriminant-of-the-quadratic

|A + t·(B - A) - C|² = r² is a quadratic equation in t with integer coefficients; its discriminant
counts the roots.
"""


def exact_count(cx, cy, r, A, B):
    ax, ay, bx, by = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    a = (bx - ax) ** 2 + (by - ay) ** 2
    if a == 0:
        return None
    half_b = ax * (bx - ax) + ay * (by - ay)
    c = ax**2 + ay**2 - r**2
    quarter_discriminant = half_b**2 - a * c
    if quarter_discriminant < 0:
        return 0
    return 2 if quarter_discriminant else 1
