"""rational-foot-and-half-chord

The foot's parameter is a Fraction, and so is the square of the half chord measured in t. A root is on the
segment if that square is at most the square of the foot's way to the end.
"""

from fractions import Fraction


def exact_segment(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    square = dx * dx + dy * dy
    if square == 0:
        return int((A[0] - cx) ** 2 + (A[1] - cy) ** 2 == r * r)
    t = Fraction((cx - A[0]) * dx + (cy - A[1]) * dy, square)
    x, y = A[0] + t * dx, A[1] + t * dy
    half = (r * r - (x - cx) ** 2 - (y - cy) ** 2) / square  # squared, in t
    if half < 0:
        return 0

    def within(sign):
        """Whether 0 <= t + sign·√half <= 1."""
        low, high = (t, 1 - t) if sign < 0 else (1 - t, t)  # √half <= low and −√half <= high
        return low >= 0 and half <= low * low and (high >= 0 or half >= high * high)

    return int(within(-1)) + int(half > 0 and within(1))
