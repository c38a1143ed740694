"""Recipes for the sign of Δ = r²·a − k² where the numbers are doubles, just as they are.

Each draws a figure of two points, A and B, whose numbers doubles hold. `size` bounds the integers a figure
is made of, `exponent` scales it by 2**exponent; either may be a list, of which one is drawn. `numbers` is the
type they arrive in, as in `counting`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import inf, isqrt, ldexp, nextafter
from math import ulp as unit

from judge.data.draw import Draw, require
from judge.problem.model import Number, Point
from judge.topics.circles.figures import lines
from judge.topics.circles.figures.figure import (
    Figure,
    Recipe,
    as_floats,
    draw_mirrored,
    draw_turn,
    line,
    moved,
    scaled,
    swapped,
    turned,
    typed,
    with_radius,
)
from judge.topics.circles.figures.lines import HIT, KINDS, MISS, TANGENT

Sizes = int | Fraction | Sequence[int | Fraction]
Exponents = int | Sequence[int]

_LOST = Fraction(9, 2)  # units of 2**-53 that roundings in one direction lose in all, of 7 that they may
_UNITS_LOST = 5.0  # the same of r²·a − k², in which more roundings are
_DISTANCES = 3000  # from A to B, which are tried for that
_TRIES, _STRIDE = 400, 0x9E3779B97F  # of a walk through numbers without a pattern
_PLAIN_BITS, _PLAIN_SCALE = 46, -39  # a plain number is below 2**7 in magnitude and has 46 bits


def plain(draw: Draw, *, numbers: str = "any") -> Figure:
    """Everything anywhere within 128: whole numbers, or doubles of 46 bits."""
    kind = draw.integer(0, 2) if numbers == "any" else 1
    if kind != 1:
        return typed(draw, lines.scattered(draw, 100), "int" if kind == 0 else "mixed")
    top = (1 << _PLAIN_BITS) - 1
    cx, cy, ax, ay, bx, by = (draw.integer(-top, top) for _ in range(6))
    radius = draw.integer(0, top)
    return scaled(line((cx, cy), radius, (ax, ay), (bx, by)), _PLAIN_SCALE)


def touch(draw: Draw, *, size: Sizes, exponent: Exponents = 0, numbers: str = "any") -> Figure:
    """Tangents in oblique directions: Δ = 0."""
    return _finished(draw, lines.plain(draw, _drawn(draw, size), TANGENT), exponent, numbers)


def ulp(draw: Draw, *, size: Sizes, exponent: Exponents = 0, steps: Sizes = 1) -> Figure:
    """A tangent, one of its seven numbers off by so many units in its last place, or by about so many."""
    figure = lines.plain(draw, _drawn(draw, size), TANGENT)
    figure = as_floats(_finished(draw, figure, exponent, "float"))
    (a, b), place = figure.points, draw.integer(0, 6)
    values = [*figure.centre, figure.radius, *a, *b]
    if not values[place]:
        draw.reject()
    sign, many = draw.sign(), _drawn(draw, steps)
    value = float(values[place])
    values[place] = value + sign * many * unit(value) if many > 1 else nextafter(value, sign * inf)
    cx, cy, r, ax, ay, bx, by = values
    return typed(draw, line((cx, cy), r, (ax, ay), (bx, by)), "any")


def unit_delta(draw: Draw, *, size: Sizes, numbers: str = "any") -> Figure:
    """Δ = 1, or −m² for a small m, where r²·a has 29 digits and more."""
    bound = _drawn(draw, size)
    hit = draw.boolean()
    figure = lines.just_hit(draw, bound) if hit else lines.least_gap_at_any_size(draw, bound, MISS)
    return _finished(draw, figure, 0, numbers)


def rotated(draw: Draw, *, size: Sizes, exponent: Exponents = 0) -> Figure:
    """A tangent turned by an angle that no double holds: Δ is whatever rounding made of 0."""
    figure = turned(lines.plain(draw, _drawn(draw, size), TANGENT), draw_turn(draw))
    return _finished(draw, figure, exponent, "float")


def through(draw: Draw, *, size: Sizes, exponent: Exponents = 0) -> Figure:
    """A line through C but for rounding: turned so that no double holds it, or in whole numbers with k = ±1.

    r is 0, or so small that r·|D| is about |k|, which is far below the rounding of dx·fy.
    """
    bound = _drawn(draw, size)
    if draw.boolean():
        bits = draw.integer(28, 34)
        direction = lines.primitive(draw.integer(1 << bits - 1, 1 << bits), draw.integer(1, 1 << bits))
        f = lines.with_cross(direction, draw.sign(), draw.integer(-2, 1))
        whole = lines.placed((0, 0), 0, f, direction)
        whole = with_radius(whole, ldexp(draw.integer(1, 8), -bits - 2))
        return _finished(draw, whole, exponent, "float")
    figure = turned(lines.point_circle(draw, bound, TANGENT), draw_turn(draw))
    if draw.integer(0, 3):
        figure = with_radius(figure, draw.integer(1, 12) * unit(float(bound)) / 8)
    return _finished(draw, figure, exponent, "float")


def far(draw: Draw, *, size: Sizes, distance: Sizes, along: Sizes) -> Figure:
    """A tangent, hit or miss moved far from the origin, or its A and B far along the line: both exactly."""
    bound = _drawn(draw, size)
    if draw.boolean():
        figure = lines.slid(draw, bound, _drawn(draw, along), draw.choice(KINDS))
        return _finished(draw, figure, 0, "any")
    away = _drawn(draw, distance)
    figure = lines.plain(draw, bound, draw.choice((TANGENT, TANGENT, HIT, MISS)))
    return _finished(draw, moved(figure, away * draw.sign(), away * draw.sign()), 0, "any")


def spread(draw: Draw, *, large: Sequence[int], little: Sequence[int]) -> Figure:
    """A line through a place of the circle or next to it, with numbers of about 2**large and 2**little.

    Seen from C, A is (0, r) or off it by a little, and B − A = (dx, dy) with a little dy or none. At its
    smallest Δ is r²·dy², beside r²·dx².
    """
    up, down = draw.integer(*large), draw.integer(*little)
    r, dx = (draw.integer(1, 99) << up for _ in range(2))
    dy, off = (draw.choice((0, 0, 1, -1)) * ldexp(draw.integer(1, 99), down) for _ in range(2))
    sides = draw.sign(), draw.sign()
    centre, a, b = (0, -r), (0, off), (dx, dy or off)
    corners: list[Point] = [(sides[0] * x, sides[1] * y) for x, y in (centre, a, b)]
    if draw.boolean():
        corners = [(y, x) for x, y in corners]
    figure = as_floats(line(corners[0], r, corners[1], corners[2]))
    return typed(draw, swapped(figure) if draw.boolean() else figure, "any")


def one_place(draw: Draw) -> Figure:
    """A tangent through a place of one of three circles, its other end off by a unit or not."""
    x, y, r = draw.choice(((3, 4, 5), (5, 12, 13), (7, 24, 25)))
    times = draw.sign() * draw.integer(1, 99) * 2 ** draw.integer(0, 30)
    b = [float(x - times * y), float(y + times * x)]
    place = draw.integer(0, 1)
    b[place] = draw.choice((b[place], nextafter(b[place], inf), nextafter(b[place], -inf)))
    return typed(draw, as_floats(line((0, 0), r, (x, y), (b[0], b[1]))), "any")


def one_way(draw: Draw) -> Figure:
    """C = A, and doubles in which all roundings of r²·a go one way, each by nearly half a unit."""
    up = draw.boolean()
    bx = _rounded_square(draw, up)
    ax = (1 if up else -1) * draw.integer(9900, 9999) / 10000 * 2.0**-53
    dy = draw.integer(1, 1 << 20) * 2.0**-45 * draw.sign()
    dx = bx - ax
    a = dx * dx + dy * dy
    r = 1 + draw.integer(1, 1 << 50) * 2.0**-52
    exact = Fraction(r) ** 2 * ((Fraction(bx) - Fraction(ax)) ** 2 + Fraction(dy) ** 2)
    lost = (Fraction(r * r * a) - exact) / exact * (1 << 53) * (1 if up else -1)
    if lost < _LOST:
        draw.reject()
    start, end = (ax, 0.0), (bx, dy)
    if draw.boolean():
        start, end = start[::-1], end[::-1]
    return line(start, r, start, end)


def unlucky(draw: Draw, *, exponent: Exponents = 0) -> Figure:
    """A tangent but for 2**-100 whose roundings of r²·a and of k² add up to five units and turn the sign.

    With dx, r ≈ 1, dy = √(a few units) and fx = 0, k² is 1 + dy² as well: fy = r·√a / dx, of which C and A
    hold 106 bits between them.
    """
    up = draw.boolean()
    dx, r = _rounded_square(draw, up), _rounded_square(draw, up)
    start = draw.integer(0, 1 << 20)
    for third in range(start, start + _DISTANCES * 7919, 7919):
        dy = (1 + third % (1 << 18) / (1 << 15)) * 2.0**-26
        square = Fraction(dx) ** 2 + Fraction(dy) ** 2
        wanted = Fraction(r) * Fraction(isqrt(int(square * (1 << 212))), 1 << 106) / Fraction(dx)
        cy = -float(wanted)
        ay = float(wanted + Fraction(cy)) or 2.0**-60
        by = ay + dy
        k = dx * (ay - cy)
        found = r * r * (dx * dx + (by - ay) * (by - ay)) - k * k
        if (found > 0) is not up or abs(found) < _UNITS_LOST * 2.0**-53 * k * k:
            continue
        square = Fraction(dx) ** 2 + (Fraction(by) - Fraction(ay)) ** 2
        exact = Fraction(r) ** 2 * square - (Fraction(dx) * (Fraction(ay) - Fraction(cy))) ** 2
        if (exact > 0) is not up:
            return _finished(draw, line((0.0, cy), r, (0.0, ay), (dx, by)), exponent, "float")
    return draw.reject()


def _rounded_square(draw: Draw, up: bool) -> float:
    """A number just above 1 whose square loses nearly half a unit where it is rounded."""
    number = draw.integer(1, 1 << 45)
    for at in range(number, number + _TRIES * _STRIDE, _STRIDE):
        whole = (1 << 52) + at % (1 << 46)
        low = whole * whole % (1 << 52) - (1 << 51)  # beyond the half, where it is rounded up
        if 0 < (low if up else -low) < 1 << 48:
            return whole * 2.0**-52
    return draw.reject()


def one_point(draw: Draw, *, size: Sizes, exponent: Exponents = 0) -> Figure:
    """A == B: Δ = 0, whatever the circle."""
    return _finished(draw, lines.one_point(draw, _drawn(draw, size)), exponent, "any")


def zero(draw: Draw, *, size: Sizes, exponent: Exponents = 0) -> Figure:
    """Δ = 0 for one reason or the other: A == B, a tangent, or r = 0 and a line through C."""
    kind = draw.integer(0, 2)
    if kind == 0:
        return one_point(draw, size=size, exponent=exponent)
    if kind == 1:
        return touch(draw, size=size, exponent=exponent)
    return _finished(draw, lines.point_circle(draw, _drawn(draw, size), TANGENT), exponent, "any")


def nearly(draw: Draw, *, size: Sizes) -> Figure:
    """Lines of every slope that hit or miss by 1e-13 to 0.9 of the radius, rounded to doubles."""
    figure = lines.nearly_tangent(draw, _drawn(draw, size), draw.choice((HIT, MISS)))

    def rounded(value: Number) -> float:
        return float(value)

    (cx, cy), (a, b) = figure.centre, figure.points
    plain_line = line(
        (0, 0), rounded(figure.radius), *((rounded(x - cx), rounded(y - cy)) for x, y in (a, b))
    )
    return typed(draw, draw_mirrored(draw, plain_line), "any")


def _finished(draw: Draw, figure: Figure, exponent: Exponents, numbers: str) -> Figure:
    """The figure mirrored, perhaps reversed, scaled and typed; a double holds each number."""
    figure = draw_mirrored(draw, figure)
    if draw.boolean():
        figure = swapped(figure)
    power = draw.choice(exponent) if isinstance(exponent, Sequence) else exponent
    as_floats(figure)  # which checks that
    return typed(draw, scaled(figure, power), numbers)


def _drawn(draw: Draw, sizes: Sizes) -> int:
    size = draw.choice(sizes) if isinstance(sizes, Sequence) else sizes
    require(size == int(size) and size > 0, "a size is a whole number above 0")
    return int(size)


RECIPES: Mapping[str, Recipe] = {
    "plain": plain,
    "touch": touch,
    "ulp": ulp,
    "unit_delta": unit_delta,
    "turned": rotated,
    "through": through,
    "far": far,
    "spread": spread,
    "one_place": one_place,
    "one_way": one_way,
    "unlucky": unlucky,
    "one_point": one_point,
    "zero": zero,
    "nearly": nearly,
}
