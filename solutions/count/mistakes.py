"""How counting goes wrong: right ways through it, and mistakes beside the lines that they spoil."""

from fractions import Fraction
from math import hypot, sqrt
from struct import pack, unpack


def squares(cx, cy, r, A, B):
    # k² and r²·a, exactly
    cx, cy, r, px, py, qx, qy = map(Fraction, (cx, cy, r, *A, *B))
    dx, dy = qx - px, qy - py
    return (dx * (py - cy) - dy * (px - cx)) ** 2, r * r * (dx * dx + dy * dy)


def single(x):
    # the nearest 32-bit float
    return unpack("f", pack("f", max(-3e38, min(3e38, x))))[0]


def wrap(x, bits):
    # a whole number as an integer of so many bits holds it; a float stays
    return x if isinstance(x, float) else (x + (1 << bits - 1)) % (1 << bits) - (1 << bits - 1)


def distance(cx, cy, r, A, B):
    "right"
    ax, ay = A[0] - cx, A[1] - cy
    # ? forgotten-centre@x: ax, ay = A[0], A[1] - cy
    # : cy is subtracted, cx is not. Subtract the centre in both coordinates.
    # ? swapped-coordinates@c: ax, ay = A[0] - cy, A[1] - cx
    # : The centre is subtracted with x and y exchanged. Its x belongs to the x of the points.
    # ? rounded-input@seen: ax, ay = round(A[0] - cx, 7), round(A[1] - cy, 7)
    # : The coordinates seen from the centre are rounded to seven decimal places. What is beyond the seventh
    # : place may be what decides. Leave them alone.
    bx, by = B[0] - cx, B[1] - cy
    # ? forgotten-centre@b: bx, by = B
    # : The centre is subtracted from A but not from B, and the direction is that of another line. Subtract
    # : it from both, or take the direction from B − A.
    # ? forgotten-centre@x: bx, by = B[0], B[1] - cy
    # : One coordinate of the centre is not subtracted. Subtract the centre in both coordinates.
    # ? swapped-coordinates@c: bx, by = B[0] - cy, B[1] - cx
    # : The centre is subtracted with x and y exchanged. Its x belongs to the x of the points.
    # ? rounded-input@seen: bx, by = round(B[0] - cx, 7), round(B[1] - cy, 7)
    size = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    # = size = max(r, hypot(ax, ay), hypot(bx, by))
    # ? coordinate-epsilon: size = max(r, abs(cx), abs(cy), abs(A[0]), abs(A[1]), abs(B[0]), abs(B[1]))
    # ? coordinate-epsilon: size = 1 + max(r, abs(cx), abs(cy), abs(A[0]), abs(A[1]), abs(B[0]), abs(B[1]))
    # : The threshold is a fraction of 1 plus all coordinates, "to be safe": for a small figure, or one far
    # : from the origin, it is wider than the figure. Measure the size from the centre, and add nothing to
    # : it.
    near = 1e-10 * size
    # = near = 1e-9 * size
    # ? single-precision@wide: near = 4e-7 * size
    # ? absolute-epsilon: near = 1e-9
    # ? loose-epsilon: near = 1e-4 * size
    dx, dy = B[0] - A[0], B[1] - A[1]
    # ? forgotten-centre@b: dx, dy = bx - ax, by - ay
    # ? shifted-direction: dx, dy = bx - ax, by - ay
    # ? point-for-direction: dx, dy = B
    length = hypot(dx, dy)
    # ? shifted-direction@cross: length = hypot(bx - ax, by - ay)
    # + zero-radius: if r == 0: return 0
    # @ With r = 0
    # + zero-radius: if r == 0: raise ValueError
    # : A radius of 0 raises an error. The statement allows it: the circle is then its centre, and a line
    # : through that point has one point in common with it.
    if length == 0:
        return None
        # ? no-degenerate: return 0
        # @ If A and B are equal
        # : A = B is answered with a number. There is no line then: the contract asks for None, which is not
        # : the same as a line that misses.
        # ? no-degenerate: return 2
        # : A = B is answered with 2, as a point inside the circle. There is no line then; return None
        # : before anything else.
        # ? sentinel-degenerate: return -1
        # ? sentinel-degenerate: return 3
        # : A = B is answered with 3, for "infinitely many". The contract says None where there is no line.
    # ? shifted-direction@cross: if dx == 0 == dy: return None
    # + degenerate-epsilon: if length <= 1e-4: return None
    # + degenerate-epsilon: if length <= 1e-8 * size: return None
    k = dx * ay - dy * ax
    # ? shifted-direction@cross: k = ax * by - ay * bx
    # : The cross product and the length are taken from coordinates that the centre has been subtracted from:
    # : where A and B are very close together nothing is left of the direction, and the length may be 0. Take
    # : it from the points as they are given, B − A.
    # ? swapped-coordinates: k = dx * ax + dy * ay
    # : The dot product of B − A and A − C is divided by the length, which gives how far along the line the
    # : foot is and not how far away the line. The cross product is dx·fy − dy·fx.
    # ? global-frame: k = (B[1] - A[1]) * cx - (B[0] - A[0]) * cy + B[0] * A[1] - B[1] * A[0]
    # ? overflow-32: k = wrap(dx * ay - dy * ax, 32)
    d = abs(k) / length
    # ? forgotten-abs: d = k / length
    # ? forgotten-abs: d = -k / length
    # ? equality-tangency@f: d = (lambda t: hypot(ax + t * dx, ay + t * dy))(-(ax * dx + ay * dy) / length ** 2)
    # : For example, the foot of the perpendicular is computed, and its distance from the centre compared
    # : with the radius by ==. After so many roundings it is hardly ever the same double. Compare within a
    # : small fraction of the size.
    # ? equality-tangency@u: d = abs(dx / length * ay - dy / length * ax)
    # : For example, the direction is normalised first, and the cross product with the unit vector is
    # : compared with the radius by ==. Compare within a small fraction of the size.
    # ? global-frame: d = abs(dy / length * cx - dx / length * cy - (dy / length * A[0] - dx / length * A[1]))
    # : The line is written p·x + q·y = s with p² + q² = 1, and s is as large as the distance from the
    # : origin; far away the difference to the centre's own p·x + q·y has lost the digits that decide.
    # : Subtract the centre from A and B first.
    # ? unnormalised-distance: d = abs(k) / length ** 2
    # : The cross product is divided by |D|², not by |D|. It is the distance times |D|: divide by the root.
    # ? single-precision: d = single(abs(single(single(dx) * single(ay)) - single(single(dy) * single(ax))) / single(length))
    # ? single-precision@wide: d = single(abs(single(single(dx) * single(ay)) - single(single(dy) * single(ax))) / single(length))
    # ? cancellation: d = sqrt(max(0.0, ax * ax + ay * ay - (ax * dx + ay * dy) ** 2 / length ** 2))
    # : The distance comes from the triangle A, C and the foot, as |f|² - (f·D)²/a: two numbers that are
    # : nearly equal when A is far away. The cross product gives the same distance without a difference of
    # : large squares: |D × f| / |D|.
    # ? cancellation: d = sqrt(max(0.0, (ax * ax + ay * ay) * (bx * bx + by * by) - (ax * bx + ay * by) ** 2)) / length
    # : The doubled area of the triangle A, B, C is the root of |a|²·|b|² − (a·b)², two numbers that are
    # : nearly equal when C is near the line. The cross product gives it without a difference of large
    # : squares.
    # ? segment-for-line: d = (lambda t: hypot(ax + t * dx, ay + t * dy))(min(1, max(0, -(ax * dx + ay * dy) / length ** 2)))
    # @ goes on for ever
    # : The distance is that of the nearest point between A and B, whose parameter is clamped to 0 and 1.
    # : The question is about the infinite line: do not clamp.
    # ? whole-numbers: d = int(abs(k) / length)
    # ? whole-numbers: return (lambda d, r: 1 if d == r else 2 if d < r else 0)(int(abs(k) / length), int(r))
    # : For example, the distance and the radius are both cut down to whole numbers before they are
    # : compared. Compare them as they are.
    # ? foot-sign: d = (lambda t: hypot(ax + t * dx, ay + t * dy))((ax * dx + ay * dy) / length ** 2)
    # + rounded-distance: d = round(d, 6)
    # + rounded-distance: return (lambda d: 1 if d == r else 2 if d < r else 0)(round(d, 6))
    if d > r + near:
        return 0
        # ? swapped-answers@s: return 2
    # = return (lambda p, q: 1 if p == q else 2 if p < q else 0)(*squares(cx, cy, r, A, B))
    # ? equality-tangency@f: return 1 if d == r else 2 if d < r else 0
    # ? equality-tangency@u: return 1 if d == r else 2 if d < r else 0
    # ? unnormalised-distance: return 1 if abs(k) == r else 2 if abs(k) < r else 0
    # : For example, k² is compared with r² without the a that belongs to it. The line meets the circle
    # : where k² <= r²·a.
    # ? tangent-missed: return 2 if d < r else 0
    # ? tangent-twice: return 2 if d <= r else 0
    # @ one point in common
    # ? absolute-epsilon: return 1 if abs(d * d - r * r) <= 1e-6 else 2 if d < r else 0
    # ? mixed-units: return 1 if abs(d * d - r * r) <= near else 2 if d < r else 0
    # ? mixed-units: return 1 if abs(abs(k) - r * length) <= near else 2 if d < r else 0
    # : For example, the cross product and r·|D| are areas, but the threshold they are compared with is a
    # : length, 1e-9 of the size. Divide by |D| first, or multiply the threshold by it.
    # ? sqrt-of-negative: h = sqrt(r * r - d * d); return 1 if abs(d - r) <= near else 2
    # : Every miss ends in a ValueError. For example, the half-chord √(r² − d²) is taken before it is known
    # : whether the line comes that close. Compare the distance with the radius first.
    # ? sqrt-of-negative: return 1 if abs(d - r) <= near else 2
    # : Lines that miss the circle get 2. For example, a root is taken with ** 0.5, which of a negative
    # : number is complex: two different numbers. Decide on the sign of the discriminant first.
    # ? segment-for-line: m, h = -(ax * dx + ay * dy) / length, sqrt(max(0.0, (r - d) * (r + d))); return sum(-near <= s <= length + near for s in ({m} if abs(d - r) <= near else {m - h, m + h} if d < r else ()))
    return 1 if d >= r - near else 2
    # ? boolean-answer: return d <= r
    # ? swapped-answers@s: return 1 if d >= r - near else 0


def quadratic(cx, cy, r, A, B):
    "right"
    fx, fy = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    size = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    near = 1e-10 * size
    a = dx * dx + dy * dy
    if a == 0:
        return None
    # ? no-degenerate: pass
    # ? absolute-epsilon@t: if a < 1e-9: return None
    b, c = fx * dx + fy * dy, fx * fx + fy * fy - r * r
    # ? global-frame@g: b, c = fx * dx + fy * dy, A[0] ** 2 + A[1] ** 2 + cx * cx + cy * cy - 2 * (A[0] * cx + A[1] * cy) - r * r
    # : x² and y² of the points and of the centre are expanded and added up: far from the origin they are
    # : 1e17 and more, and the radius is lost in them. Subtract the centre first, then multiply.
    k = dx * fy - dy * fx
    disc = r * r * a - k * k
    # ? wrong-sign: disc = b * b - a * (fx * fx + fy * fy + r * r)
    # ? cancellation@e: disc = b * b - a * c
    # ? global-frame@g: disc = b * b - a * c
    # ? equality-tangency@q: disc = b * b - a * c
    # ? absolute-epsilon@t: disc = 4 * (b * b - a * c)
    # ? radius-not-squared: disc = r * a - k * k
    # ? overflow-64: disc = wrap(r * r * a - k * k, 64)
    # ? overflow-32: disc = wrap(r * r * a - k * k, 32)
    # ? overflow-32: disc = wrap(r * r, 32) * wrap(a, 32) - wrap(k, 32) ** 2
    limit = a * near * (2 * r + near)
    # ? cancellation@e: limit = 1e-10 * b * b
    # ? equality-tangency: limit = 0
    # : For example, the distance is compared with the radius by ==. After a division and a root it is
    # : hardly ever the same double. Compare within a small fraction of the size.
    # ? equality-tangency@q: limit = 0
    # ? absolute-epsilon: limit = 1e-9
    # ? absolute-epsilon@t: limit = 1e-9
    # : For example, lengths are compared with one fixed number, and so is the discriminant, a fourth power
    # : of one. Compare lengths, within a small part of the size.
    # ? loose-epsilon: limit = 1e-5 * r * r * a
    if disc < -limit:
        return 0
    return 1 if disc <= limit else 2


def slope(cx, cy, r, A, B):
    "slope-intercept"
    ax, ay = A[0] - cx, A[1] - cy
    bx, by = B[0] - cx, B[1] - cy
    if A == B:
        return None
    near = 1e-10 * max(r, abs(ax), abs(ay), abs(bx), abs(by))
    # = near = 1e-9
    # = near = 0.0
    # = near = 1e-12
    # + slope-intercept: if ax == bx: return None
    # : A vertical line, which has no slope, is answered with None, as if it were no line. Work with the
    # : direction B − A, which knows no special direction.
    # + slope-intercept: if ax == bx: return 0
    # : A vertical line, which has no slope, is answered with 0. Work with the direction B − A, which knows no
    # : special direction.
    m = (by - ay) / (bx - ax)
    # = m = (by - ay) / (bx - ax) if bx != ax else 0.0
    # = m = (by - ay) / ((bx - ax) or 1e-9)
    # = m = (by - ay) / ((bx - ax) or 1e-12)
    d = abs(ay - m * ax) / sqrt(1 + m * m)
    if d > r + near:
        return 0
    # = if abs(d * d - r * r) < 1e-9: return 1
    return 1 if d >= r - near else 2
