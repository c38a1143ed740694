"""discriminant-of-the-quadratic

|A + t·(B - A) - C|² = r² is a quadratic equation in t with integer coefficients; its discriminant
counts the roots.

Why it is exact: nothing but sums and products of integers, which Python holds to the last digit.
No root has to be known to be counted, so no square root is taken and nothing is divided.

Written as |A + t·D - C|² = r² with an even middle term 2·half_b·t, the discriminant is
4·(half_b² - a·c), and a quarter of it has the same sign. For A == B a is 0 and the equation is none
any more, which is why that is asked for first. The cross product does it in fewer multiplications:
by Lagrange's identity half_b² - a·c = r²·a - k².
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
# mine
