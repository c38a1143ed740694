"""A circle and the line through two points, in integers: tangent, crossing it, missing it by the least
amount.

With D = B − A, f = A − C, a = D·D and the cross product k = D × f, the line's distance to C is |k|/√a, and
Δ' = r²a − k² (Lagrange's identity) tells 0, 1 or 2 common points by its sign. The recipes choose D, k and r
so that Δ' is what they say, then find an f. Every recipe checks Δ' before it hands the figure out.
"""

from __future__ import annotations

from itertools import count
from math import gcd, isqrt

from judge.data.draw import Draw, require
from judge.topics.circles.figures.figure import Figure, draw_point, integer, line
from judge.topics.circles.figures.numbers import (
    bezout,
    is_prime,
    pell,
    pythagorean,
    root_modulo_square,
    two_squares,
)

IntPoint = tuple[int, int]
HIT, TANGENT, MISS = "hit", "tangent", "miss"
KINDS = (HIT, TANGENT, MISS)
_MISS_TRIES = 100  # about one multiple in thirty will do
_GAP_TRIES = 60  # about one in twenty will do
_PELL_REACH = 30  # coordinates of the directions `least_gap_at_any_size` starts from


def discriminant(figure: Figure) -> int:
    """Δ' = r²a − k² of an integer figure of two points; 0 where they coincide."""
    (ax, ay), (bx, by) = ((integer(x), integer(y)) for x, y in figure.points)
    cx, cy = integer(figure.centre[0]), integer(figure.centre[1])
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    cross = dx * fy - dy * fx
    return integer(figure.radius) ** 2 * (dx * dx + dy * dy) - cross * cross


def require_kind(figure: Figure, kind: str) -> None:
    """Check the sign of an integer figure's Δ'."""
    gap = discriminant(figure)
    found = HIT if gap > 0 else MISS if gap < 0 else TANGENT
    require(found == kind, f"the line is a {kind}, not a {found}")


def primitive(x: int, y: int) -> IntPoint:
    """(x, y) without its common factor; it must not be (0, 0)."""
    common = gcd(x, y)
    return x // common, y // common


def laid(centre: IntPoint, radius: int, direction: IntPoint, height: int, i: int, j: int) -> Figure:
    """The line along `direction` with the foot C + height·(−q, p); A and B are i and j directions from it."""
    (cx, cy), (p, q) = centre, direction
    foot_x, foot_y = cx - height * q, cy + height * p
    return line(centre, radius, (foot_x + i * p, foot_y + i * q), (foot_x + j * p, foot_y + j * q))


def with_cross(direction: IntPoint, cross: int, steps: int = 0) -> IntPoint:
    """f with D × f = cross for a primitive D: the one nearest to the foot, moved by `steps` times D."""
    dx, dy = direction
    u, v, common = bezout(dx, -dy)
    require(common == 1, "the direction is primitive")
    fx, fy = v * cross, u * cross
    a = dx * dx + dy * dy
    nearest = (a - 2 * (fx * dx + fy * dy)) // (2 * a)  # −(f·D)/a, rounded to the nearest integer
    slide = nearest + steps
    fx, fy = fx + slide * dx, fy + slide * dy
    require(dx * fy - dy * fx == cross, "f has the cross product that was asked for")
    return fx, fy


def placed(centre: IntPoint, radius: int, f: IntPoint, direction: IntPoint) -> Figure:
    """The line through A = C + f and B = A + direction."""
    ax, ay = centre[0] + f[0], centre[1] + f[1]
    return line(centre, radius, (ax, ay), (ax + direction[0], ay + direction[1]))


def tangent(draw: Draw, size: int) -> Figure:
    """A tangent in a Pythagorean direction: Δ' = 0; lengths of about `size`, none much smaller."""
    p, q, h = pythagorean(draw, max(5, size // 4))
    reach = max(2, size // h)
    height = draw.integer(max(1, reach // 8), reach) * draw.sign()
    i = draw.integer(-reach, reach)
    j = i + draw.integer(max(1, reach // 4), reach) * draw.sign()
    figure = laid(draw_point(draw, size), abs(height) * h, (p, q), height, i, j)
    require(discriminant(figure) == 0, "Δ' = 0")
    return figure


def rational_tangent(draw: Draw, size: int) -> Figure:
    """A tangent in a Pythagorean direction whose foot, C ± r·(−q, p)/h, is seldom a grid point: Δ' = 0."""
    p, q, h = pythagorean(draw, max(5, size // 4))
    radius = draw.integer(max(1, size // 8), size)
    reach = max(2, size // h)
    f = with_cross((p, q), radius * h * draw.sign(), draw.integer(-reach, reach))
    j = draw.integer(max(1, reach // 4), reach) * draw.sign()
    figure = placed(draw_point(draw, size), radius, f, (j * p, j * q))
    require_kind(figure, TANGENT)
    return figure


def plain(draw: Draw, size: int, kind: str) -> Figure:
    """A line that clearly crosses or misses the circle, or a tangent, with numbers of about `size` (≥ 20).

    Distance and radius differ by at least a tenth of the radius; A and B lie anywhere along the line.
    """
    if kind == TANGENT:
        return draw.choice((tangent, rational_tangent))(draw, size)
    p, q, h = pythagorean(draw, max(5, size // 4))
    reach = max(2, size // h)
    height = draw.integer(0 if kind == HIT else 1, reach) * draw.sign()
    distance = abs(height) * h
    if kind == HIT:
        radius = draw.integer(distance + distance // 8 + 1, max(2 * distance, size) + 1)
    else:
        radius = draw.integer(distance // 4, distance - distance // 8 - 1)
    i = draw.integer(-reach, reach)
    j = i + draw.integer(max(1, reach // 4), reach) * draw.sign()
    figure = laid(draw_point(draw, size), radius, (p, q), height, i, j)
    require(
        (discriminant(figure) > 0) == (kind == HIT), "the line crosses the circle, or misses it, as asked"
    )
    return figure


def axis_parallel(draw: Draw, size: int, kind: str) -> Figure:
    """A horizontal line (mirror it for a vertical one) that crosses, touches or misses the circle."""
    centre = draw_point(draw, size)
    radius = draw.integer(1, size)
    clear = max(1, radius // 10)
    if kind == TANGENT:
        height = radius
    elif kind == HIT:
        height = draw.integer(0, radius - clear)
    else:
        height = draw.integer(radius + clear, 3 * radius + clear)
    i = draw.integer(-size, size)
    j = i + draw.integer(max(1, size // 4), size) * draw.sign()
    figure = laid(centre, radius, (1, 0), height * draw.sign(), i, j)
    require_kind(figure, kind)
    return figure


def just_hit(draw: Draw, size: int, root: int = 1) -> Figure:
    """Two common points with Δ' = root², whatever the size: |D|, r and A − C are of about `size`.

    r = u² + v² and U + iV = (u + iv)², so r² = U² + V². With U·y + V·x = root, D = (x, y) and k = U·x − V·y
    give r²a − k² = (U·y + V·x)² = root².
    """
    u = draw.integer(1, max(2, isqrt(size)))
    v = draw.integer(1, max(2, isqrt(size)))
    if gcd(u, v) != 1 or (u + v) % 2 == 0:
        draw.reject()
    r, real, imaginary = u * u + v * v, u * u - v * v, 2 * u * v
    x0, y0, _ = bezout(imaginary, real)
    turns = draw.integer(1, max(1, size // r)) * draw.sign()
    x, y = root * x0 + real * turns, root * y0 - imaginary * turns
    if gcd(x, y) != 1:
        draw.reject()
    f = with_cross((x, y), real * x - imaginary * y, draw.integer(-2, 1))
    figure = placed(draw_point(draw, size), r, f, (x, y))
    require(discriminant(figure) == root * root, "Δ' = root²")
    return figure


def just_miss(draw: Draw, size: int) -> Figure:
    """No common point with Δ' = −1: |D|, r and A − C are of about `size`, up to about 1e8.

    r is even and k = r²j ± 1, so that (k² − 1)/r² = j(r²j ± 2) = a; j is one for which a is a primitive sum
    of two squares. (An odd r is impossible: look modulo 8.)
    """
    r = 2 * draw.integer(max(1, size // 8), max(1, size // 2))
    first = draw.integer(1, max(1, size // r))
    step = draw.sign()
    for j in range(first, first + _MISS_TRIES):
        direction = two_squares(j * (r * r * j + 2 * step))
        if direction is not None:
            break
    else:
        draw.reject()
    f = with_cross(direction, (r * r * j + step) * draw.sign(), draw.integer(-2, 1))
    figure = placed(draw_point(draw, size), r, f, direction)
    require(discriminant(figure) == -1, "Δ' = −1")
    return figure


def small_gap(draw: Draw, size: int, reach: int) -> Figure:
    """Δ' = δ for a small δ up to ±`reach` that is no square: a hair, but not the least one; r is prime.

    k is a root of −δ modulo r², moved by r² until a = (k² + δ)/r² is a primitive sum of two squares. r is of
    the form 4m + 3: then one of δ and −δ has a root. |D| and r are of about `size`.
    """
    start = 4 * draw.integer(max(1, size // 32), max(1, size // 4)) + 3
    r = next(n for n in count(start, 4) if is_prime(n))
    gap = draw.integer(2, reach)
    if isqrt(gap) ** 2 == gap or gap % r == 0:
        draw.reject()
    square = r * r
    root = root_modulo_square(-gap, r)
    if root is None:
        gap = -gap
        root = root_modulo_square(-gap, r)
    require(root is not None, "one of ±δ is a square modulo r")
    root = (root or 0) if draw.boolean() else square - (root or 0)
    for k in range(root, root + _GAP_TRIES * square, square):
        direction = two_squares((k * k + gap) // square)
        if direction is not None:
            break
    else:
        draw.reject()
    f = with_cross(direction, k * draw.sign(), draw.integer(-2, 1))
    figure = placed(draw_point(draw, size), r, f, direction)
    require(discriminant(figure) == gap, "Δ' = δ")
    return figure


def slid(draw: Draw, size: int, along: int, kind: str) -> Figure:
    """A line of any kind, A slid along it by up to `along` steps of D and at least an eighth of that.

    Only b' = f·D grows: b'²/|Δ'| is about (along·|D|/r)², and b'² − a·c loses twice as many digits.
    """
    p, q, h = pythagorean(draw, max(5, size // 4))
    radius = draw.integer(max(2, size // 8), size)
    clear = max(1, radius // 8)
    distance = {
        TANGENT: radius * h,
        HIT: draw.integer(0, (radius - clear) * h),
        MISS: draw.integer((radius + clear) * h, 2 * (radius + clear) * h),
    }[kind]
    steps = draw.integer(max(1, along // 8), along) * draw.sign()
    figure = placed(draw_point(draw, size), radius, with_cross((p, q), distance * draw.sign(), steps), (p, q))
    require_kind(figure, kind)
    return figure


def least_gap_at_any_size(draw: Draw, size: int, kind: str) -> Figure:
    """Δ' = ±m² with r of about `size`, where m is small: as near to a tangent as integers get.

    Pell's equation k² − a·r² = ±1 for a short primitive D of square length a gives Δ' = ∓1; then B slides
    away from A by m steps of D. A lies up to `size` from the foot.
    """
    direction = draw.integer(0, _PELL_REACH), draw.integer(1, _PELL_REACH)
    a = direction[0] ** 2 + direction[1] ** 2
    if gcd(*direction) != 1 or isqrt(a) ** 2 == a:
        draw.reject()
    solution = None
    for k, r in pell(a, -1 if kind == HIT else 1):
        if r > size:
            break
        solution = k, r
    if solution is None:
        draw.reject()
    k, r = solution
    multiple = draw.integer(1, 9)
    along = size // (isqrt(a) + 1)
    f = with_cross(direction, k * draw.sign(), draw.integer(-along, along))
    figure = placed(draw_point(draw, size), r, f, (multiple * direction[0], multiple * direction[1]))
    wanted = multiple**2 if kind == HIT else -(multiple**2)
    require(discriminant(figure) == wanted, "Δ' = ±m²")
    return figure


def nearly_tangent(draw: Draw, size: int, kind: str) -> Figure:
    """A hit or a miss by 1e-13 to 0.9 of the radius, all magnitudes alike; so are the slope and |AB|.

    `size` bounds the radius, and should be 1e20 or more: then all that is found in integers.
    """
    direction = primitive(draw.integer(1, 9), draw.integer(1, 9) * 10 ** draw.integer(0, 10) + 1)
    a = direction[0] ** 2 + direction[1] ** 2
    radius = draw.integer(size // 10, size)
    touch = isqrt(radius * radius * a)
    gap = max(1, draw.integer(1, 9) * touch // 10 ** draw.integer(1, 13))
    cross = touch - gap if kind == HIT else touch + gap
    multiple = max(1, draw.integer(1, 9) * radius // (isqrt(a) * 10 ** draw.integer(1, 13)))
    f = with_cross(direction, cross * draw.sign(), draw.integer(-multiple, multiple))
    figure = placed(draw_point(draw, size), radius, f, (multiple * direction[0], multiple * direction[1]))
    require_kind(figure, kind)
    return figure


def scattered(draw: Draw, size: int) -> Figure:
    """Everything anywhere within `size`; about as many lines cross the circle as miss it."""
    return line(draw_point(draw, size), draw.integer(0, size), draw_point(draw, size), draw_point(draw, size))


def one_point(draw: Draw, size: int) -> Figure:
    """A == B: anywhere, on the circle, or at its centre; the radius may be 0."""
    centre = draw_point(draw, size)
    radius = draw.integer(0, size)
    place = draw.choice(("anywhere", "on the circle", "centre", "point circle"))
    if place == "anywhere":
        point = draw_point(draw, size)
    elif place == "on the circle":
        p, q, h = pythagorean(draw, max(5, size))
        times = draw.integer(1, max(1, size // h))
        point, radius = (centre[0] + times * p, centre[1] + times * q), times * h
    else:
        point = centre
        radius = radius if place == "centre" else 0
    return line(centre, radius, point, point)


def point_circle(draw: Draw, size: int, kind: str) -> Figure:
    """r = 0: the line runs through the centre (tangent, one point) or clearly past it (miss)."""
    p, q, h = pythagorean(draw, max(5, size // 4))
    reach = max(2, size // h)
    height = 0 if kind == TANGENT else draw.integer(max(1, reach // 4), reach) * draw.sign()
    i = draw.integer(-reach, reach)
    j = i + draw.integer(max(1, reach // 4), reach) * draw.sign()
    figure = laid(draw_point(draw, size), 0, (p, q), height, i, j)
    require_kind(figure, kind)
    return figure


def off_the_segment(draw: Draw, size: int) -> Figure:
    """The line crosses the circle twice, but no point of the segment from A to B lies on it."""
    p, q, h = pythagorean(draw, max(5, size // 8))
    reach = max(4, size // h)
    height = draw.integer(0, reach // 2)
    chord = draw.integer(2, reach)  # the half-chord is between chord − 1 and chord, in directions
    radius = isqrt((height * h) ** 2 + (chord * h) ** 2)
    if (radius**2 - (height * h) ** 2) <= ((chord - 1) * h) ** 2:
        draw.reject()
    if draw.boolean() and chord > 2:  # both inside
        i = draw.integer(1 - chord, chord - 2)
        j = draw.integer(i + 1, chord - 1)
    else:  # both beyond the same end
        i = draw.integer(chord + 1, chord + reach)
        j = i + draw.integer(1, reach)
    figure = laid(draw_point(draw, size), radius, (p, q), height * draw.sign(), i, j)
    require_kind(figure, HIT)
    return figure
