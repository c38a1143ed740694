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
            # : b = 0 and c ≠ 0 is answered with None. No t is a root then: an empty list.
        # ? no-degenerate: pass
        # : a = b = 0 is not asked for, and leads to a division by 0.
        return [-c / (2 * b)]
        # ? linear-unhalved: return [-c / b]
        # @ the equation is linear
        # : The linear equation is taken for b·t + c = 0. It is 2·b·t + c = 0.
        # ? division-by-zero: return []
        # : a = 0 is answered with no root. The equation is linear then: −c/(2·b).
    # ? division-by-zero: pass
    # ? division-by-zero: if a == 0: return None if b == c == 0 else []
    # : a = 0 is answered with no root. The equation is linear then: −c/(2·b).
    # + absolute-epsilon: if abs(a) < {1e-12..1e-6/3}: return [] if b == 0 else [-c / (2 * b)]
    # : A small a is taken for 0. Only 0 is 0: at 2⁻⁶⁰⁰ it is a number like any other.
    delta = Fraction(b) ** 2 - Fraction(a) * Fraction(c)
    # ? unhalved@four: delta = Fraction(b) ** 2 - 4 * Fraction(a) * Fraction(c)
    # @ Mind the 2
    # : The discriminant is b² − 4·a·c, which belongs to a·t² + b·t + c. Here the middle coefficient is 2·b.
    # ? unhalved@all: delta = Fraction(b) ** 2 - 4 * Fraction(a) * Fraction(c)
    # ? rounded-discriminant: delta = Fraction(float(b) * float(b) - float(a) * float(c))
    # ? rounded-discriminant: delta = Fraction(float(Fraction(b) ** 2) - float(Fraction(a) * Fraction(c)))
    # ? overflow: delta = limited(b, b) - limited(a, c)
    # + absolute-epsilon: delta = Fraction(0) if abs(delta) < {1e-15..1e-9/3} else delta
    # + loose-epsilon: delta = Fraction(0) if abs(delta) <= Fraction({1e-15..1e-6/3}) * Fraction(b) ** 2 else delta
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
    # ? double-root-twice: pass
    # : The general way is taken where Δ = 0, and the one root comes twice, or 0 is divided by 0.
    s = root(delta)
    q = -(b + s) if b >= 0 else s - b
    # ? sign-wrong-way: q = s - b if b >= 0 else -(b + s)
    # ? sign-wrong-way: q = -(b + s)
    # : q is −b − √Δ whatever the sign of b: for b < 0 that subtracts. Take the sign of b.
    # ? sign-wrong-way: q = s - b
    # : q is −b + √Δ whatever the sign of b: for b > 0 that subtracts. Take the sign of b.
    # ? sign-of-zero: q = -(b + ((b > 0) - (b < 0)) * s)
    # ? sign-of-zero: q = -(b + b / abs(b) * s)
    # : The sign of b is found as b/|b|, which divides by 0 where b is 0.
    # ? sign-of-zero: q = -(b + s) if b > 0 else s - b if b < 0 else 0.0
    # + unhalved@all: q = q / 2
    first, second = q / a, c / q
    # ? naive-roots: first, second = (-b - s) / a, (-b + s) / a
    # ? naive-roots: first, second = q / a, -2 * b / a - q / a
    # : The second root is found from the sum of both, −2·b/a, by a subtraction. Use their product: c/q.
    # ? floor-division: first, second = q // a, c // q
    # ? wrong-sign: first, second = -q / a, -c / q
    # : The roots come out with the other sign: they are (−b ± √Δ)/a.
    # ? first-root-only: return [q / a]
    # : Only one root is returned where there are two.
    # ? unhalved: first, second = q / (2 * a), c / (2 * q)
    # : The roots are divided by 2·a, which belongs to a·t² + b·t + c. Here the middle coefficient is 2·b.
    # + zero-root-lost: if c == 0: return [q / a]
    # + zero-root-lost: if c == 0: return [0.0]
    # : With c = 0 only the root 0 is returned; the other one is −2·b/a.
    # + zero-root-lost: return sorted(x for x in (first, second) if x != 0)
    # : A root that is 0 is thrown away, as if it were none.
    # + rounded-output: first, second = round(first, 9), round(second, 9)
    # + rounded-output: first, second = float("%.12g" % first), float("%.12g" % second)
    return sorted([first, second])
    # ? unsorted: return [first, second]
    # @ in ascending order
    # ? unsorted: return [second, first]
    # ? unsorted: return sorted([first, second], key=abs)
    # : The roots are sorted by magnitude. −3 comes before 1.
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
