"""Recipes for the sign of Δ = r²·a − k² where the numbers are doubles, just as they are.

Each draws a figure of two points, A and B, whose numbers doubles hold. `size` bounds the integers a figure
is made of, `exponent` scales it by 2**exponent; either may be a list, of which one is drawn. `numbers` is the
type they arrive in, as in `counting`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import inf, ldexp, nextafter
from math import ulp as unit

from judge.data.draw import Draw, require
from judge.problem.model import Number
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
    "one_point": one_point,
    "zero": zero,
    "nearly": nearly,
}
