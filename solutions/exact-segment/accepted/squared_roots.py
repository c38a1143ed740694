"""roots-compared-by-squaring

Both roots are written as (-b ± √Δ)/a and compared with 0 and 1: ±√Δ against an integer, which squaring
decides exactly.
"""


def sign_of_sum(p, q, d):
    """The sign of p + q·√d for q = ±1 and d >= 0, in integers."""
    if d == 0 or p == 0:
        return (p > 0) - (p < 0) if d == 0 else q
    if (p > 0) == (q > 0):
        return q
    larger = (p * p > d) - (p * p < d)
    return larger * (1 if p > 0 else -1)


def exact_segment(cx, cy, r, A, B):
    fx, fy, dx, dy = A[0] - cx, A[1] - cy, B[0] - A[0], B[1] - A[1]
    a, b, c = dx * dx + dy * dy, fx * dx + fy * dy, fx * fx + fy * fy - r * r
    if a == 0:
        return 1 if c == 0 else 0
    delta = b * b - a * c
    if delta < 0:
        return 0
    count = 0
    for side in (-1, 1) if delta else (1,):
        count += sign_of_sum(-b, side, delta) >= 0 and sign_of_sum(-b - a, side, delta) <= 0
    return count
