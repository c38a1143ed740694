"""exact

Rational numbers throughout; the one square root is taken to 60 digits by the integer root.
"""

from fractions import Fraction
from math import isqrt

SNAP = Fraction(1, 10**12)


def square_root(value):
    """The root of a rational number from below, to about 60 digits."""
    shift = 400
    return Fraction(isqrt((value.numerator << 2 * shift) // value.denominator), 1 << shift)


def within(square, radius, slack):
    """Whether the root of `square` is within `slack` of `radius`, exactly."""
    low, high = radius - slack, radius + slack
    return square <= high * high and (low <= 0 or square >= low * low)


def circle_segment(cx, cy, r, A, B):
    cx, cy, r = Fraction(cx), Fraction(cy), Fraction(r)
    ax, ay = Fraction(A[0]) - cx, Fraction(A[1]) - cy
    bx, by = Fraction(B[0]) - cx, Fraction(B[1]) - cy
    slack = SNAP * max(r, abs(ax), abs(ay), abs(bx), abs(by))

    if (ax, ay) == (bx, by):
        return [tuple(A)] if within(ax * ax + ay * ay, r, slack) else []

    dx, dy = bx - ax, by - ay
    a = dx * dx + dy * dy
    b = ax * dx + ay * dy
    k = dx * ay - dy * ax
    if within(k * k / a, r, slack):
        parameters = [-b / a]
    elif k * k > r * r * a:
        return []
    else:
        root = square_root(r * r * a - k * k)
        parameters = [(-b - root) / a, (-b + root) / a]

    spill = slack * slack / a  # (slack / |D|)², so that no second root is needed

    def on_segment(t):
        over = max(-t, t - 1, 0)
        return over * over <= spill

    return [(float(cx + ax + t * dx), float(cy + ay + t * dy)) for t in parameters if on_segment(t)]
