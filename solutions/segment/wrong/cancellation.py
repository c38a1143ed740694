"""cancellation

The discriminant (f·D)² - a·c subtracts two numbers that are nearly equal when the circle is small and far from A.
Use r²a - k² with k = D × f: the same number, without the cancellation.
"""

from math import sqrt


def circle_segment(cx, cy, r, A, B):
    fx, fy = float(A[0] - cx), float(A[1] - cy)
    dx, dy = float(B[0] - A[0]), float(B[1] - A[1])
    near = 1e-10 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    a = dx * dx + dy * dy
    if a == 0:
        return [A] if abs(sqrt(fx * fx + fy * fy) - r) <= near else []
    b = fx * dx + fy * dy
    c = fx * fx + fy * fy - r * r
    disc = b * b - a * c
    # |d - r| <= near, as a statement on r² - d² = disc / a
    if disc / a < -near * (2 * r + near):
        return []
    if disc / a <= near * (2 * r - near):
        ts = [-b / a]
    else:
        root = sqrt(max(disc, 0.0))
        ts = [(-b - root) / a, (-b + root) / a]
    slack = near / sqrt(a)
    return [(A[0] + t * dx, A[1] + t * dy) for t in ts if -slack <= t <= 1 + slack]
