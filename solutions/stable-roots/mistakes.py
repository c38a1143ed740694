"""How roots lose their digits: right ways to them, and mistakes beside the lines that they spoil."""

from fractions import Fraction
from math import inf, ldexp, sqrt
from struct import pack, unpack


def root(x):
    # the root of a Fraction, which may be beyond the doubles
    half = (x.numerator.bit_length() - x.denominator.bit_length()) // 2
    return ldexp(sqrt(x / 4**half if half >= 0 else x * 4**-half), half)


def short(x):
    return unpack("f", pack("f", x))[0]


def limited(x, y):
    # a product as doubles hold it where it leaves their range, and exactly elsewhere
    p = float(x) * float(y)
    return Fraction(x) * Fraction(y) if 1e-300 < abs(p) < inf else Fraction(p)


def stable(a, b, c):
    "right"
    # + single-precision: a, b, c = short(a), short(b), short(c)
    # + wrong-sign: b = -b
    # : The roots come out with the other sign: they are (−b ± √Δ)/a.
    if a == 0:
        if b == 0:
            return None if c == 0 else []
            # ? no-degenerate: return None
            # @ every t is a root
            # : Where a and b are 0, c ≠ 0 is answered with None. No t is a root then: an empty list.
        # ? no-degenerate: pass
        # : a = b = 0 is not asked for, and leads to a division by 0.
        return [-c / (2 * b)]
        # ? linear-unhalved: return [-c / b]
        # @ the equation is linear
        # : The linear equation is taken for b·t + c = 0. It is 2·b·t + c = 0.
        # ? division-by-zero: return []
        # : a = 0 is answered with no root. The equation is linear then: −c/(2·b).
    # ? division-by-zero: pass
    # + absolute-epsilon: if abs(a) < 1e-9: return [] if b == 0 else [-c / (2 * b)]
    # : A small a is taken for 0. Only 0 is 0: at 2⁻⁶⁰⁰ it is a number like any other.
    delta = Fraction(b) ** 2 - Fraction(a) * Fraction(c)
    # ? unhalved@four: delta = Fraction(b) ** 2 - 4 * Fraction(a) * Fraction(c)
    # @ Mind the 2
    # : For example, the discriminant is b² − 4·a·c, which belongs to a·t² + b·t + c. Here the middle
    # : coefficient is 2·b.
    # ? rounded-discriminant: delta = Fraction(float(b) * float(b) - float(a) * float(c))
    # ? overflow: delta = limited(b, b) - limited(a, c)
    # + absolute-epsilon: delta = Fraction(0) if abs(delta) < 1e-12 else delta
    # + loose-epsilon: delta = Fraction(0) if abs(delta) <= Fraction(1e-9) * Fraction(b) ** 2 else delta
    if delta < 0:
        return []
        # ? absent-root: return None
        # : No real root is answered with None. That is for 0 = 0: return an empty list.
        # ? sqrt-of-negative: delta = -delta
        # : The discriminant's absolute value is taken, and an equation without real roots gets two.
    # ? sqrt-of-negative: pass
    # : The root of a negative discriminant is asked for, which raises an error. Return [] first.
    if delta == 0:
        return [-b / a]
        # ? double-root-twice: return [-b / a, -b / a]
        # @ A double root is given once
        # ? double-root-missed: return []
    s = root(delta)
    q = -(b + s) if b >= 0 else s - b
    # ? sign-wrong-way: q = s - b if b >= 0 else -(b + s)
    # ? sign-wrong-way: q = -(b + s)
    # : q is −b − √Δ whatever the sign of b: for b < 0 that subtracts. Take the sign of b.
    # ? sign-of-zero: q = -(b + ((b > 0) - (b < 0)) * s)
    first, second = q / a, c / q
    # ? naive-roots: first, second = (-b - s) / a, (-b + s) / a
    # ? floor-division: first, second = q // a, c // q
    # ? first-root-only: return [q / a]
    # : Only one root is returned where there are two.
    # ? unhalved: first, second = q / (2 * a), c / (2 * q)
    # : A factor of 2 is in the wrong place. Here the middle coefficient is 2·b, not b.
    # + zero-root-lost: if c == 0: return [q / a]
    # + zero-root-lost: if c == 0: return [0.0]
    # : With c = 0 only the root 0 is returned; the other one is −2·b/a.
    # + rounded-output: first, second = round(first, 9), round(second, 9)
    return sorted([first, second])
    # ? unsorted: return [first, second]
    # @ in ascending order
    # ? unsorted: return sorted([first, second], reverse=True)
    # : The roots come in descending order.


def school(a, b, c):
    "naive-roots"
    if a == 0:
        return (None if c == 0 else []) if b == 0 else [-c / (2 * b)]
    delta = Fraction(b) ** 2 - Fraction(a) * Fraction(c)
    # = delta = b * b - a * c
    if delta < 0:
        return []
    s = root(delta)
    # = s = sqrt(delta)
    return sorted({(-b - s) / a, (-b + s) / a})
