"""How counting on a segment goes wrong: right ways through it, and mistakes beside the lines that they spoil."""

from decimal import Decimal, localcontext
from fractions import Fraction
from math import hypot, isqrt, sqrt


def wrap(x, bits):
    return (x + (1 << bits - 1)) % (1 << bits) - (1 << bits - 1)


def by_roots(a, b, delta, low, high):
    # the roots (−b ± √Δ)/a from low to high, in doubles
    if delta < 0:
        return 0
    root = sqrt(delta)
    first, second = (-b - root) / a, (-b + root) / a
    return (low <= first <= high) + (second != first and low <= second <= high)


def by_decimals(a, b, delta, digits):
    with localcontext() as context:
        context.prec = digits
        a, b, delta = Decimal(a), Decimal(b), Decimal(delta)
        if delta < 0:
            return 0
        root = delta.sqrt()
        first, second = (-b - root) / a, (-b + root) / a
        return (0 <= first <= 1) + (root != 0 and 0 <= second <= 1)


def signs(cx, cy, r, A, B):
    "right"
    # + float-coordinates: cx, cy, r, A, B = int(float(cx)), int(float(cy)), int(float(r)), tuple(map(int, map(float, A))), tuple(map(int, map(float, B)))
    fx, fy = A[0] - cx, A[1] - cy
    # ? forgotten-centre: fx, fy = A
    gx, gy = B[0] - cx, B[1] - cy
    # ? forgotten-centre: gx, gy = B
    dx, dy = gx - fx, gy - fy
    a = dx * dx + dy * dy
    b = fx * dx + fy * dy
    start = fx * fx + fy * fy - r * r
    # ? overflow-64@all: start = wrap(fx * fx + fy * fy - r * r, 64)
    # ? float-arithmetic@ends: start = hypot(fx, fy) - r
    # : For example, |A − C| is found with hypot, a double of 53 bits, and compared with r. Compare the
    # : squares, in ints.
    # ? loose-epsilon@tiny: start = 0 if abs(fx * fx + fy * fy - r * r) <= 1 else fx * fx + fy * fy - r * r
    # : |A − C|² and r² may differ by 1 and pass for equal. There is no tolerance here: compare with ==.
    # ? radius-not-squared: start = fx * fx + fy * fy - r
    # : For example, |A − C|² is compared with r. Compare it with r².
    # ? rounded-root@ends: start = isqrt(fx * fx + fy * fy) - r
    # : |A − C| is rounded down to a whole number, and an end just outside the circle is on it. Compare the
    # : squares.
    end = gx * gx + gy * gy - r * r
    # ? overflow-64@all: end = wrap(gx * gx + gy * gy - r * r, 64)
    # ? float-arithmetic@ends: end = hypot(gx, gy) - r
    # ? loose-epsilon@tiny: end = 0 if abs(gx * gx + gy * gy - r * r) <= 1 else gx * gx + gy * gy - r * r
    # ? rounded-root@ends: end = isqrt(gx * gx + gy * gy) - r
    # + zero-radius: if r == 0: return 0
    # + zero-radius: if r == 0: return int(dx * fy == dy * fx and 0 <= -b <= a)
    # : A radius of 0 is looked at before A = B, and there every point is on the line through itself. Look
    # : at A = B first.
    if a == 0:
        return int(start == 0)
        # ? no-degenerate: return 0
        # @ the segment is that point
        # : A = B is answered with 0. The segment is that point then: it is on the circle or not.
        # ? no-degenerate: return 1
        # : A = B is answered with 1, whether the point is on the circle or not. Ask.
    k = dx * fy - dy * fx
    # ? swapped-coordinates: k = dx * fx - dy * fy
    # : x and y are exchanged in the cross product: it is dx·fy − dy·fx.
    delta = r * r * a - k * k
    # ? unnormalised-distance: delta = r * r - k * k
    # ? float-arithmetic: delta = r - abs(k) / hypot(dx, dy)
    # : For example, the distance of the line is a quotient of doubles, compared with r. Compare r²·a with
    # : k², in ints.
    # ? loose-epsilon: delta = 0 if abs(r * r * a - k * k) <= 1e-6 * r * r * a else r * r * a - k * k
    # ? floor-division: delta = r * r - k * k // a
    # : For example, the squared distance is k² // a, which drops the fraction: a miss by less than one is a
    # : touch. Compare r²·a with k².
    # ? rounded-root: delta = isqrt(r * r * a) - abs(k)
    # : √(r²·a) is rounded down to a whole number. Compare the squares.
    # ? overflow-64@all: delta = wrap(r * r * a - k * k, 64)
    # ? overflow-64: delta = wrap(r * r * a - k * k, 64)
    # ? overflow-32: delta = wrap(r * r * a - k * k, 32)
    # ? fixed-precision: delta = Decimal(r * r) * Decimal(a) - Decimal(k) * Decimal(k)
    # + float-roots: return by_roots(a, b, delta, -1e-15, 1 + 1e-15)
    # : The roots are doubles, and the ends have a slack: an end just off the circle counts as on it, and at
    # : large sizes the roots are wrong by more. Compare integers: 0 ≤ −b ≤ a, and the signs of |A − C|² − r².
    # + fixed-precision: return by_decimals(a, b, delta, 50)
    # : The roots are decimals of 50 digits, and the numbers have more. Signs of integers need no digits.
    # + line-count: return 0 if delta < 0 else 1 if delta == 0 else 2
    # + both-ends-out: if min(start, end) > 0: return 0
    # + disc-for-circle: return int(start <= 0) + int(end <= 0)
    # : Ends in the disc are counted. The circle is the curve: an end inside is no point of it.
    # + disc-for-circle: return 1 if min(start, end) <= 0 else 2 if delta > 0 and 0 <= -b <= a else int(delta == 0 and 0 <= -b <= a)
    # : A segment with an end in the disc gets one point. With both ends inside there is none.
    # + diameter-for-radius: delta = r * r * a - 4 * k * k
    # : The discriminant halves the radius, as if it were a diameter. It is the radius.
    if delta < 0:
        return 0
    between = 0 <= -b <= a
    # ? clamped-foot: between = True
    # ? open-interval: between = 0 < -b < a
    # @ an end on the circle counts
    # : The foot must be strictly between the ends, and a touch at an end is lost. The ends belong to the
    # : segment: 0 ≤ −b ≤ a.
    # ? reversed-vector: between = 0 <= b <= a
    # : The foot is at −b/a: the sign is lost. Compare 0 ≤ −b ≤ a.
    # ? half-line: between = 0 <= -b
    if delta == 0:
        return int(between)
        # ? tangent-twice: return 2 if between else 0
        # @ A touch is one point
        # ? tangent-missed: return 0
        # ? clamped-foot: return 1
    if start < 0 or end < 0:
        return int(start >= 0) + int(end >= 0)
        # ? inside-counts: return 1
        # @ not the disc
        # ? inside-counts: return int(start <= 0) + int(end <= 0)
        # : The ends inside are counted, not those outside. The segment leaves the circle on the side of the end
        # : that is not inside.
    if between:
        return 2
        # ? first-root-only: return 1
        # : A segment through the circle gets one point. It enters and it leaves: two.
    return int(start == 0) + int(end == 0)
    # ? open-interval: return 0


def distances(cx, cy, r, A, B):
    "right"
    # the segment is cut at the foot, and each half changes sides or not
    fx, fy, gx, gy = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    start, end = fx * fx + fy * fy - r * r, gx * gx + gy * gy - r * r
    dx, dy = gx - fx, gy - fy
    a, b = dx * dx + dy * dy, fx * dx + fy * dy
    if a == 0:
        return int(start == 0)
    if b >= 0 or -b >= a:
        return int(start <= 0 <= end or end <= 0 <= start)
        # ? open-interval: return int(start < 0 < end or end < 0 < start)
        # ? float-arithmetic: return int(hypot(fx, fy) <= r <= hypot(gx, gy) or hypot(gx, gy) <= r <= hypot(fx, fy))
    foot = Fraction((dx * fy - dy * fx) ** 2, a) - r * r
    if foot >= 0:
        return int(foot == 0)
        # ? tangent-twice: return 2 if foot == 0 else 0
        # ? tangent-missed: return 0
    return int(start >= 0) + int(end >= 0)
    # ? open-interval: return int(start > 0) + int(end > 0)
    # ? inside-counts: return 2
    # : Wherever the foot is inside, the answer is 2, also for ends inside the circle. Count the ends that are
    # : not inside.


def slope(cx, cy, r, A, B):
    "slope-intercept"
    if A == B:
        return int((A[0] - cx) ** 2 + (A[1] - cy) ** 2 == r * r)
    # + slope-intercept: if A[0] == B[0]: return 0
    # : A vertical segment, which has no slope, is answered with 0. Work with the direction B − A.
    m = Fraction(B[1] - A[1], B[0] - A[0])
    # = m = Fraction(B[1] - A[1], B[0] - A[0]) if A[0] != B[0] else 10 ** 6
    n = A[1] - cy - m * (A[0] - cx)
    a, b, c = 1 + m * m, m * n, n * n - r * r
    delta = b * b - a * c
    if delta < 0:
        return 0
    low, high = min(A[0], B[0]) - cx, max(A[0], B[0]) - cx

    def within(side):
        below, above = -b - a * low, a * high + b  # −b ± √Δ from a·low to a·high
        if side < 0:
            return below >= 0 and delta <= below * below and (above >= 0 or delta >= above * above)
        return above >= 0 and delta <= above * above and (below >= 0 or delta >= below * below)

    return int(within(-1)) + int(delta > 0 and within(1))
