"""cancellation

b² - a·c in decimals of 100 digits. Far along the line both terms are giants that agree in nearly all of
them, and the circle is in what is rounded off. Compute in ints, where r²·a - k² also stays small.
"""

from decimal import Context, localcontext


def exact_count(cx, cy, r, A, B):
    if A[0] == B[0] and A[1] == B[1]:
        return None
    with localcontext(Context(prec=100)) as context:
        number = context.create_decimal
        fx, fy = number(A[0] - cx), number(A[1] - cy)
        dx, dy = number(B[0] - A[0]), number(B[1] - A[1])
        a = dx * dx + dy * dy
        b = fx * dx + fy * dy
        c = fx * fx + fy * fy - number(r) ** 2
        delta = b * b - a * c
    return 1 + (delta > 0) - (delta < 0)
