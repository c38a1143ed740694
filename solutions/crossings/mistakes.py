"""How counting crossings goes wrong: right ways to it, and mistakes beside the lines that they spoil."""

from fractions import Fraction
from math import hypot, isqrt, sqrt


def sign_of(x):
    return 0 if x < 0 else 2 if x > 0 else 1


def product(cx, cy, r, A, B):
    "right"
    dx, dy = B[0] - A[0], B[1] - A[1]
    # = dx, dy = A[0] - B[0], A[1] - B[1]
    # ? sum-for-difference: dx, dy = B[0] + A[0], B[1] + A[1]
    # ? swapped-coordinates: dx, dy = B[1] - A[1], B[0] - A[0]
    # @ pairs `(x, y)`
    fx, fy = A[0] - cx, A[1] - cy
    # = fx, fy = cx - A[0], cy - A[1]
    # = fx, fy = B[0] - cx, B[1] - cy
    # ? forgotten-centre: fx, fy = A
    # ? forgotten-centre: fx, fy = A[0] - cx, A[1]
    # : The centre is subtracted from A in x only. Subtract it in y as well.
    # + segment-for-line: if not 0 <= -(fx * dx + fy * dy) <= dx * dx + dy * dy: return 0
    # @ goes on for ever
    # + ends-counted: return (fx * fx + fy * fy <= r * r) + ((fx + dx) ** 2 + (fy + dy) ** 2 <= r * r)
    # @ Only its edge counts
    k = dx * fy - dy * fx
    # ? dot-for-cross: k = dx * fx + dy * fy
    # ? swapped-coordinates: k = dx * fy + dy * fx
    # : The two products are added. The cross product is their difference.
    a = dx * dx + dy * dy
    # = a = dx**2 + dy**2
    # ? minus-for-plus: a = dx * dx - dy * dy
    # ? forgotten-square: a = abs(dx) + abs(dy)
    # : The ways along x and along y are added without being squared. |B - A|² is dx² + dy².
    gap = r * r * a - k * k
    # = gap = r * sqrt(a) - abs(k)
    # = gap = r * r - Fraction(k * k, a)
    # ? undivided: gap = r * r - k * k
    # ? undivided: gap = r * a - abs(k)
    # : |k| is divided by |B - A|² instead of |B - A|. Compare k² with r²·|B - A|².
    # ? forgotten-square: gap = r * r * a - abs(k)
    # : r² stands beside |k|, which is not squared. Square both.
    # ? caret-for-power: gap = (r ^ 2) * a - (k ^ 2)
    # ? caret-for-power: gap = (r ^ 2) * a - k * k
    # ? floor-division: gap = r * r - k * k // a
    # ? rounded-root: gap = r - abs(k) // isqrt(a)
    # ? rounded-root: gap = r * isqrt(a) - abs(k)
    # : |B - A| is rounded down to a whole number. Compare k² with r²·|B - A|².
    # ? float-arithmetic: gap = (lambda t: r - hypot(fx + t * dx, fy + t * dy))(-(fx * dx + fy * dy) / a)
    # ? float-arithmetic: gap = (lambda t: r * r - (fx + t * dx) ** 2 - (fy + t * dy) ** 2)(-(fx * dx + fy * dy) / a)
    # ? nearly-on-is-on: gap = (lambda d: 0 if abs(d - r) <= 1e-2 else r - d)(abs(k) / hypot(dx, dy))
    # ? nearly-on-is-on: gap = (lambda d: 0 if abs(d - r * r) <= 1e-3 else r * r - d)(k * k / a)
    # ? rounded-distance: gap = r - round(abs(k) / hypot(dx, dy), 1)
    # ? rounded-distance: gap = r - round(abs(k) / hypot(dx, dy), 4)
    # ? end-for-line: gap = r * r - fx * fx - fy * fy
    # ? absolute-value: gap = abs(r * r * a - k * k)
    # ? swapped-answers: gap = k * k - r * r * a
    if gap < 0:
        return 0
        # ? number-for-sign@sign: return gap
        # ? boolean-answer@sign: return False
        # ? tangent-missed@disc: return 0
        # @ if it touches it
    if gap == 0:
        return 1
        # ? tangent-twice: return 2
        # ? number-for-sign@sign: return gap
        # ? boolean-answer@sign: return True
    return 2
    # ? boolean-answer@sign: return True
    # ? number-for-sign@sign: return gap
    # ? tangent-missed@disc: return 1
    # : Every line that is near enough gets 1. A line that cuts the circle goes in and out again: 2.


def equation(cx, cy, r, A, B):
    "right"
    fx, fy = A[0] - cx, A[1] - cy
    # ? sum-for-difference: fx, fy = A[0] + cx, A[1] + cy
    # : The centre is added where it has to be subtracted. Take A - C.
    dx, dy = B[0] - A[0], B[1] - A[1]
    # ? point-for-direction: dx, dy = B
    a = dx * dx + dy * dy
    b = 2 * (fx * dx + fy * dy)
    # ? unhalved: b = fx * dx + fy * dy
    # ? point-for-direction: b = 2 * (A[0] * dx + A[1] * dy)
    # : b is made of A, not of A - C. Subtract the centre there too.
    c = fx * fx + fy * fy - r * r
    # ? wrong-sign: c = fx * fx + fy * fy + r * r
    # ? wrong-sign: c = r * r - fx * fx - fy * fy
    # : c has the wrong sign: it is |A - C|² - r².
    # ? forgotten-square: c = fx * fx + fy * fy - r
    delta = b * b - 4 * a * c
    # ? unhalved: delta = b * b - 2 * a * c
    # : There is a 2 where a 4 is meant: the discriminant of a·t² + b·t + c is b² - 4·a·c.
    if delta < 0:
        return 0
    return 1 if delta == 0 else 2
    # ? tangent-missed: return 2 if delta > 0 else 0


def slope(cx, cy, r, A, B):
    "slope-intercept"
    m = Fraction(B[1] - A[1], B[0] - A[0])
    # = m = (B[1] - A[1]) / (B[0] - A[0])
    # = m = Fraction(B[1] - A[1], B[0] - A[0]) if A[0] != B[0] else 0
    # = m = Fraction(B[1] - A[1], B[0] - A[0]) if A[0] != B[0] else 10**6
    n = A[1] - cy - m * (A[0] - cx)
    return sign_of(r * r * (1 + m * m) - n * n)
