"""How exact counting goes wrong: right ways through it, and mistakes beside the lines that they spoil."""

from decimal import Decimal, localcontext
from fractions import Fraction
from math import hypot, isclose, isqrt, sqrt


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
    # + zero-radius: if r == 0: raise ValueError
    # : A radius of 0 raises an error. The statement allows it: the circle is the point C, and a line
    # : through C has one point in common with it.
    if dx == 0 == dy:
        return None
        # ? no-degenerate: return 0
        # @ If A and B are equal
        # : A = B is answered with a number. There is no line then: the contract asks for None, which is not
        # : the same as a line that misses.
        # ? no-degenerate: return 1
        # ? sentinel-degenerate: return -1
        # ? sentinel-degenerate: return 3
        # : A = B is answered with 3, for "infinitely many". The contract says None where there is no line.
    a = dx * dx + dy * dy
    b = fx * dx + fy * dy
    c = fx * fx + fy * fy - r * r
    k = dx * fy - dy * fx
    # ? swapped-coordinates: k = dx * fx + dy * fy
    # : The dot product of B − A and A − C stands where the cross product belongs. The cross product is
    # : dx·fy − dy·fx.
    disc = r * r * a - k * k
    # ? unnormalised-distance: disc = r * r - k * k
    # ? radius-not-squared: disc = r * a - k * k
    # : For example, r·a is compared with k², with the radius as it is. Square the radius.
    # ? float-arithmetic: disc = (lambda F, G, X, Y, R: R * R * (X * X + Y * Y) - (X * G - Y * F) ** 2)(*map(float, (fx, fy, dx, dy, r)))
    # : The differences are exact, but they are made floats before they are multiplied, and k² and r²·a are
    # : rounded. Compare r²·a with k² in ints.
    # ? float-arithmetic: disc = (lambda d: 0 if isclose(d, r, rel_tol=1e-12) else r - d)(abs(k) / hypot(dx, dy))
    # ? fixed-precision: disc = decimal(fx, fy, dx, dy, r, 28, True)
    # ? fixed-precision: disc = decimal(fx, fy, dx, dy, r, 50, False)
    # : Decimals as they come, with 28 digits: from coordinates of about ten million on, the fourth powers
    # : have more. With numbers of any size no fixed precision is enough; ints have none.
    # ? cancellation: disc = decimal(fx, fy, dx, dy, r, 100, True)
    # ? overflow-64: disc = wrap(wrap(b * b, 64) - wrap(wrap(a, 64) * wrap(c, 64), 64), 64)
    # ? overflow-64: disc = top(top(r * r, 64) * top(a, 64), 64) - top(top(k, 64) ** 2, 64)
    # ? overflow-32: disc = wrap(r * r * a - k * k, 32)
    # ? overflow-128: disc = wrap(r * r * a - k * k, 128)
    # ? floor-division: disc = r * r - k * k // a
    # : For example, the squared distance is k² // a, which drops the fraction: a miss by less than one is a
    # : tangent. Compare k² with r²·a instead, and divide by nothing.
    # ? floor-division: disc = (lambda t: r * r - (fx + t * dx) ** 2 - (fy + t * dy) ** 2)(-b // a)
    # : For example, the parameter of the foot is found with //, so that it is always a whole number, and
    # : the foot with it a corner of the grid. Keep the denominator, or multiply through.
    # ? loose-epsilon: disc = (lambda p, q: 0 if abs(p - q) <= 1e-3 * max(p, q) else p - q)(r * r * a, k * k)
    # ? rounded-root: disc = r * isqrt(a) - abs(k)
    # : |D| is rounded down to a whole number with isqrt, and r·|D| with it. Compare the squares: k² with
    # : r²·a.
    # ? rounded-root: disc = r - abs(k) // isqrt(a)
    # ? few-steps: disc = (lambda n: newton(n, 6) - abs(k) or n - k * k)(r * r * a)
    # ? loose-epsilon: disc = (lambda d: 0 if abs(d) <= 1 else d)(r * r * a - k * k)
    # : r²·a and k² may differ by 1 and pass for equal. Here there is no tolerance at all, and just that 1
    # : is the difference between a hit and a tangent: compare with ==.
    # ? diameter-for-radius: disc = r * r * a - 4 * k * k
    # + segment-for-line: if not 0 <= -b <= a: return 0
    # @ goes on for ever
    # : If the foot of the perpendicular is not between A and B, the line is said to miss. The question is
    # : about the infinite line: the foot may be anywhere on it.
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
