"""How exact counting goes wrong: right ways through it, and mistakes beside the lines that they spoil."""

from decimal import Decimal, localcontext
from fractions import Fraction
from math import dist, hypot, isclose, isqrt, sqrt


def wrap(x, bits):
    return (x + (1 << bits - 1)) % (1 << bits) - (1 << bits - 1)


def top(x, bits):
    return max(-(1 << bits - 1), min((1 << bits - 1) - 1, x))


def decimal(fx, fy, dx, dy, r, digits, textbook):
    with localcontext() as context:
        context.prec = digits
        fx, fy, dx, dy, r = map(Decimal, (fx, fy, dx, dy, r))
        if textbook:
            return (fx * dx + fy * dy) ** 2 - (dx * dx + dy * dy) * (fx * fx + fy * fy - r * r)
        return r * r * (dx * dx + dy * dy) - (dx * fy - dy * fx) ** 2


def newton(n, steps):
    # the root of a whole number, but for the steps that are missing
    x = 1 << (n.bit_length() + 1) // 2
    for _ in range(steps if n else 0):
        x = (x + n // x) // 2
    return x - 1 if n and (x - 1) ** 2 >= n else x


def sign_of(x):
    return 0 if x < 0 else 2 if x > 0 else 1


def exact(cx, cy, r, A, B):
    "right"
    # + float-coordinates@rel: r = int(float(r))
    fx, fy = A[0] - cx, A[1] - cy
    # ? forgotten-centre: fx, fy = A
    # ? forgotten-centre: fx, fy = A[0] - cx, A[1]
    # : The centre is subtracted from A in one coordinate only. Subtract it from both coordinates.
    # ? forgotten-centre: fx, fy = A[0], A[1] - cy
    # ? float-coordinates: fx, fy = int(float(A[0] - cx)), int(float(A[1] - cy))
    # : The coordinates seen from the centre are made floats, and from 2**53 on neighbouring integers are
    # : the same one. Leave them ints.
    # ? float-coordinates@all: fx, fy = int(float(A[0])) - int(float(cx)), int(float(A[1])) - int(float(cy))
    # ? float-coordinates@rel: fx, fy = int(float(A[0] - cx)), int(float(A[1] - cy))
    # ? swapped-coordinates: fx, fy = A[0] - cy, A[1] - cx
    # : The centre is subtracted with x and y exchanged. Its x belongs to the x of the points.
    dx, dy = B[0] - A[0], B[1] - A[1]
    # ? forgotten-centre: dx, dy = B[0] - A[0] + cx, B[1] - A[1] + cy
    # ? float-coordinates@all: dx, dy = int(float(B[0])) - int(float(A[0])), int(float(B[1])) - int(float(A[1]))
    # ? float-coordinates@rel: dx, dy = int(float(B[0] - cx)) - int(float(A[0] - cx)), int(float(B[1] - cy)) - int(float(A[1] - cy))
    # + zero-radius: if r == 0: return 0
    # @ With r = 0
    # + zero-radius: if r == 0: return 1
    # : For a radius of 0 the answer is 1, wherever the line is. The circle is the point C then: the line
    # : may miss it.
    # + zero-radius: if r == 0: return None
    # : For a radius of 0 None is returned, as where A == B. The circle is the point C then: a line through
    # : C has one point in common with it.
    # + zero-radius: if r == 0: raise ValueError
    # : A radius of 0 raises an error. The statement allows it: the circle is the point C, and a line
    # : through C has one point in common with it.
    # + zero-radius: if r == 0 and (dx or dy): return 2 if dx * fy == dy * fx else 0
    # : A circle of radius 0 has no tangents here: a line through its centre gets 2. It is a single point:
    # : one point in common.
    if dx == 0 == dy:
        return None
        # ? no-degenerate: return 0
        # @ If A and B are equal
        # : A == B is answered with 0: no line, no points. The contract asks for None there, which is not
        # : the same as a line that misses.
        # ? no-degenerate: return 1
        # ? no-degenerate: return 2
        # : A == B is answered with 2, as a point inside the circle. There is no line then: return None
        # : first.
        # ? no-degenerate: return 1 if fx * fx + fy * fy == r * r else 0
        # : A == B is treated as a point that is on the circle, or not. There is no line then: return None
        # : first.
        # ? no-degenerate: raise ZeroDivisionError
        # : The squared distance is a fraction whose denominator is 0 where A == B: a division by zero.
        # : There is no line then; return None first.
        # ? sentinel-degenerate: return -1
        # ? sentinel-degenerate: return 3
        # : A == B is answered with 3, for "infinitely many". The contract says None where there is no line.
    # ? no-degenerate: pass
    a = dx * dx + dy * dy
    b = fx * dx + fy * dy
    c = fx * fx + fy * fy - r * r
    k = dx * fy - dy * fx
    # ? swapped-coordinates: k = dx * fx + dy * fy
    # : The dot product of B − A and A − C stands where the cross product belongs. The cross product is
    # : dx·fy − dy·fx.
    # ? swapped-coordinates: k = dx * fx - dy * fy
    # ? swapped-coordinates: k = dx * fy + dy * fx
    disc = r * r * a - k * k
    # ? unnormalised-distance: disc = r * r - k * k
    # ? radius-not-squared: disc = r * a - k * k
    # : r·a is compared with k², with the radius as it is. Square the radius.
    # ? float-arithmetic: disc = float(r * r * a) - float(k * k)
    # ? float-arithmetic: disc = float(r) * r * float(a) - float(k) * k
    # : k² is divided by a with /, which makes a float of it, with 53 bits. Compare k² with r²·a, in ints.
    # ? float-arithmetic: disc = r - abs(k) / sqrt(a)
    # ? float-arithmetic: disc = r - abs(k) / hypot(dx, dy)
    # ? float-arithmetic: disc = r * hypot(dx, dy) - abs(k)
    # : The cross product is exact, but it is compared with r·hypot(dx, dy), a float with 53 bits. Compare
    # : the squares, in ints.
    # ? float-arithmetic: disc = r * r - k * k / a
    # : r² − k²/a, whose division makes a float of it: 53 bits, so that near misses and tangents fall
    # : together, and an OverflowError beyond 1e308. Compare r²·a with k², in ints.
    # ? float-arithmetic: disc = (lambda F, G, X, Y, R: (F * X + G * Y) ** 2 - (X * X + Y * Y) * (F * F + G * G - R * R))(*map(float, (fx, fy, dx, dy, r)))
    # : b² − a·c in doubles. The two terms are large and nearly equal, and what is left of their difference
    # : is rounding. Compute in ints, where r²·a − k² also stays small.
    # ? float-arithmetic: disc = (lambda F, G, X, Y, R: R * R * (X * X + Y * Y) - (X * G - Y * F) ** 2)(*map(float, (fx, fy, dx, dy, r)))
    # : The differences are exact, but they are made floats before they are multiplied, and k² and r²·a are
    # : rounded. Compare r²·a with k² in ints.
    # ? float-arithmetic: disc = (lambda t: r - hypot(fx + t * dx, fy + t * dy))(-b / a)
    # : The foot of the perpendicular is computed in floats, and its distance from the centre compared with
    # : the radius by ==. A double has 53 bits: compare r²·a with k² in ints.
    # ? float-arithmetic: disc = (lambda d: 0 if abs(d - r) <= {1e-15..1e-6/3} else r - d)(abs(k) / sqrt(a))
    # ? float-arithmetic: disc = (lambda d: 0 if isclose(d, r, rel_tol={1e-15..1e-6/3}) else r - d)(abs(k) / hypot(dx, dy))
    # ? fixed-precision: disc = decimal(fx, fy, dx, dy, r, 28, True)
    # ? fixed-precision: disc = decimal(fx, fy, dx, dy, r, 28, False)
    # ? fixed-precision: disc = decimal(fx, fy, dx, dy, r, 34, True)
    # ? fixed-precision: disc = decimal(fx, fy, dx, dy, r, 40, False)
    # ? fixed-precision: disc = decimal(fx, fy, dx, dy, r, 40, True)
    # ? fixed-precision: disc = decimal(fx, fy, dx, dy, r, 50, True)
    # ? fixed-precision: disc = decimal(fx, fy, dx, dy, r, 50, False)
    # ? fixed-precision: disc = decimal(fx, fy, dx, dy, r, 70, True)
    # ? fixed-precision: disc = decimal(fx, fy, dx, dy, r, 100, False)
    # ? cancellation: disc = decimal(fx, fy, dx, dy, r, 100, True)
    # ? fixed-precision: disc = decimal(fx, fy, dx, dy, r, 200, True)
    # ? fixed-precision: disc = decimal(fx, fy, dx, dy, r, 200, False)
    # ? overflow-64: disc = wrap(wrap(b * b, 64) - wrap(wrap(a, 64) * wrap(c, 64), 64), 64)
    # ? overflow-64: disc = wrap(r * r * a - k * k, 64)
    # ? overflow-64: disc = wrap(r * r * a, 64) - wrap(k * k, 64)
    # ? overflow-64: disc = top(top(r * r, 64) * top(a, 64), 64) - top(top(k, 64) ** 2, 64)
    # ? overflow-32: disc = wrap(r * r * a - k * k, 32)
    # ? overflow-32: disc = wrap(r * r * a, 32) - wrap(k * k, 32)
    # ? overflow-128: disc = wrap(r * r * a - k * k, 128)
    # ? overflow-128: disc = wrap(r * r * a, 128) - wrap(k * k, 128)
    # ? floor-division: disc = r * r - k * k // a
    # : The squared distance is k² // a, which drops the fraction: a miss by less than one is a tangent.
    # : Compare k² with r²·a instead, and divide by nothing.
    # ? floor-division: disc = (lambda t: r * r - (fx + t * dx) ** 2 - (fy + t * dy) ** 2)(-b // a)
    # : The parameter of the foot is found with //, so that it is always a whole number, and the foot with
    # : it a corner of the grid. Keep the denominator, or multiply through.
    # ? floor-division: disc = r - abs(k) // isqrt(a)
    # ? rounded-root: disc = r - isqrt(k * k // a)
    # ? floor-division: disc = (lambda t: r * r - (fx + t * dx) ** 2 - (fy + t * dy) ** 2)((-b) // a)
    # ? floor-division: disc = (lambda x, y: r * r - x * x - y * y)(fx + dx * -b // a, fy + dy * -b // a)
    # ? loose-epsilon: disc = (lambda p, q: 0 if abs(p - q) * 10**6 <= p else p - q)(r * r * a, k * k)
    # ? loose-epsilon: disc = (lambda p, q: 0 if abs(p - q) <= {1e-12..1e-3/3} * max(p, q) else p - q)(r * r * a, k * k)
    # ? loose-epsilon: disc = (lambda p, q: 0 if abs(p - q) * 10 ** 9 <= max(p, q) else p - q)(r * r * a, k * k)
    # ? rounded-root: disc = r * isqrt(a) - abs(k)
    # : |D| is rounded down to a whole number with isqrt, and r·|D| with it. Compare the squares: k² with
    # : r²·a.
    # ? rounded-root: disc = isqrt(r * r * a) - abs(k)
    # : |k| is compared with the whole part of √(r²·a): a line that misses by less than one of its units is
    # : a tangent, and a hit is lost. Compare the squares: k² with r²·a.
    # ? rounded-root: disc = r - abs(k) // isqrt(a)
    # ? few-steps: disc = (lambda n: newton(n, 8) - abs(k) or n - k * k)(r * r * a)
    # ? few-steps: disc = (lambda n: newton(n, 6) - abs(k) or n - k * k)(r * r * a)
    # ? loose-epsilon: disc = (lambda d: 0 if abs(d) <= {1e-12..1e-3/3} * r * r * a else d)(r * r * a - k * k)
    # ? loose-epsilon: disc = (lambda d: 0 if abs(d) <= 1 else d)(r * r * a - k * k)
    # : r²·a and k² may differ by 1 and pass for equal. Here there is no tolerance at all, and just that 1
    # : is the difference between a hit and a tangent: compare with ==.
    # ? loose-epsilon: disc = (lambda d: 0 if abs(d) <= Fraction({1e-12..1e-3/3}) else d)(r * r - Fraction(k * k, a))
    # ? diameter-for-radius: disc = r * r * a - 4 * k * k
    # + segment-for-line: if not 0 <= -b <= a: return 0
    # @ goes on for ever
    # : If the foot of the perpendicular is not between A and B, the line is said to miss. The question is
    # : about the infinite line: the foot may be anywhere on it.
    # + segment-for-line: return (lambda n: sign_of(r * r * n[1] - n[0]))((k * k, a) if 0 <= -b <= a else (min(fx * fx + fy * fy, (fx + dx) ** 2 + (fy + dy) ** 2), 1))
    # : The distance is that of the nearest point between A and B. The question is about the infinite line:
    # : only the cross product matters.
    # + segment-for-line: return (lambda p, q, s: 0 if max(p, q) < 0 else 1 if min(p, q) < 0 else s)(c, (fx + dx) ** 2 + (fy + dy) ** 2 - r * r, sign_of(disc))
    # : Only the ends are looked at: one inside and one outside make one point, and two inside none. The question
    # : is about the infinite line.
    # + segment-for-line: return (fx * fx + fy * fy < r * r) != ((fx + dx) ** 2 + (fy + dy) ** 2 < r * r)
    if disc < 0:
        return 0
    # ? tangent-missed: return 2 if disc > 0 else 0
    # ? tangent-twice: return 2 if disc >= 0 else 0
    # @ one point in common
    # ? sqrt-of-negative: root = isqrt(disc)
    # ? sqrt-of-negative: return 1 if disc == 0 else 2
    # : The absolute value is taken under the root, "to be safe", and a miss gets two points as well. Only
    # : the sign is needed, and no root at all.
    # ? swapped-answers: return 0 if disc > 0 else 1 if disc == 0 else 2
    # ? boolean-answer: return disc >= 0
    # ? whole-root: return 1 if disc == 0 else 2 if disc > 0 and isqrt(disc) ** 2 == disc else 0
    return 1 if disc == 0 else 2


def slope(cx, cy, r, A, B):
    "slope-intercept"
    if A == B:
        return None
    # + slope-intercept: if A[0] == B[0]: return None
    # : A vertical line, which has no slope, is answered with None. Work with the direction B − A.
    # + slope-intercept: if A[0] == B[0]: return 0
    # : A vertical line, which has no slope, is answered with 0. Work with the direction B − A, which knows no
    # : special direction.
    m = Fraction(B[1] - A[1], B[0] - A[0])
    # = m = (B[1] - A[1]) / (B[0] - A[0])
    # = m = Fraction(B[1] - A[1], B[0] - A[0]) if A[0] != B[0] else 0
    # = m = Fraction(B[1] - A[1], B[0] - A[0]) if A[0] != B[0] else 10 ** 6
    n = A[1] - cy - m * (A[0] - cx)
    return sign_of(r * r * (1 + m * m) - n * n)
