"""Recipes for a circle and the infinite line through two points: how often they meet, and how nearly.

Each draws a figure of two points, A and B.

Parameters they share, each one value or a list of which one is drawn: `size` bounds the integers a figure is
made of; `exponent` scales it by 2**exponent; `turn` rotates it by an angle that no double holds, which makes
every number a rounded float; `numbers` is the type the numbers arrive in, "int", "float", "mixed" or "any",
a third of the cases each (Python multiplies ints exactly, so a program that goes wrong in doubles shows it on
floats only, and one that divides with // on ints only; this one is a single word).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from judge.data.draw import Draw, require
from judge.topics.circles.figures import lines
from judge.topics.circles.figures.figure import (
    Figure,
    Recipe,
    as_floats,
    draw_mirrored,
    draw_turn,
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
Turns = bool | Sequence[bool]
Words = str | tuple[str, ...]

_GAP = Fraction(1, 10**9)  # of the extent: what `near` counts in
_HAIR = Fraction(1, 10**14)  # of the extent: what `band` counts in


def grid(draw: Draw, *, reach: int, numbers: str = "int", exponent: Exponents = 0) -> Figure:
    """All numbers small integers."""
    return typed(draw, scaled(lines.scattered(draw, reach), _exponent(draw, exponent)), numbers)


def degenerate(draw: Draw, *, size: Sizes, numbers: str = "int") -> Figure:
    """A == B: there is no line."""
    return typed(draw, lines.one_point(draw, _size(draw, size)), numbers)


def axis(draw: Draw, *, size: Sizes, numbers: str = "int", exponent: Exponents = 0) -> Figure:
    """Verticals and horizontals of every kind."""
    figure = lines.axis_parallel(draw, _size(draw, size), draw.choice(KINDS))
    return typed(draw, scaled(draw_mirrored(draw, figure), _exponent(draw, exponent)), numbers)


def zero_radius(
    draw: Draw, *, size: Sizes, numbers: str = "int", turn: Turns = False, exponent: Exponents = 0
) -> Figure:
    """r = 0: through the centre or past it."""
    figure = lines.point_circle(draw, _size(draw, size), draw.choice((TANGENT, MISS)))
    return _finished(draw, figure, numbers, turn, exponent)


def tangent(
    draw: Draw, *, size: Sizes, numbers: str = "int", turn: Turns = False, exponent: Exponents = 0
) -> Figure:
    """Tangents in oblique directions, whose foot is a grid point or any rational one."""
    return _finished(draw, lines.plain(draw, _size(draw, size), TANGENT), numbers, turn, exponent)


def any_kind(
    draw: Draw, *, size: Sizes, numbers: str = "int", turn: Turns = False, exponent: Exponents = 0
) -> Figure:
    """Tangents, clear hits and clear misses, a third each."""
    return _finished(draw, lines.plain(draw, _size(draw, size), draw.choice(KINDS)), numbers, turn, exponent)


def near(
    draw: Draw,
    *,
    size: Sizes,
    low: int,
    high: int,
    side: Words,
    turn: Turns = False,
    exponent: Exponents = 0,
    distance: Sizes = 1,
) -> Figure:
    """Lines that cross or miss the circle, as `side` says, by `low` to `high` billionths of the extent.

    The figure is moved by up to `distance` before it is scaled; only one that is not turned can go far.
    """
    kind = draw.choice(side) if isinstance(side, tuple) else side
    require(kind in (HIT, MISS), "side is hit or miss")
    away = _size(draw, distance)
    figure = _loosened(draw, lines.tangent(draw, _size(draw, size)), turn)
    # The radius changes the extent by less than a millionth, and `low` keeps clear of the promise by more.
    change = Fraction(draw.integer(low * 1000, high * 1000), 1000) * _GAP * figure.extent
    radius = float(Fraction(figure.radius) + (change if kind == HIT else -change))
    figure = with_radius(figure, radius)
    if away > 1:
        figure = moved(figure, away - draw.integer(0, away // 2), draw.integer(0, away // 2) - away)
    return typed(draw, scaled(figure, _exponent(draw, exponent)), "any")


def band(draw: Draw, *, size: Sizes, high: int, turn: Turns = False, exponent: Exponents = 0) -> Figure:
    """Tangents within the band: r is off by up to `high` hundredths of a trillionth of the extent."""
    figure = _loosened(draw, lines.tangent(draw, _size(draw, size)), turn)
    return typed(draw, scaled(_off_by_a_hair(draw, figure, high), _exponent(draw, exponent)), "any")


def far(draw: Draw, *, ratio: int, high: int = 0, turn: Turns = False) -> Figure:
    """A and B lie about `ratio` radii away, on one side (perhaps close together) or on both.

    d is r, or off by a fifth of it. A tangent's radius is off by up to `high` hundredths of a trillionth of
    the extent, as in `band`.
    """
    p, q, h = draw.choice(((3, 4, 5), (4, 3, 5), (5, 12, 13), (8, 15, 17), (21, 20, 29)))
    units = draw.integer(5, 12)
    kind = draw.choice(KINDS)
    low, top = {
        TANGENT: (units, units),
        HIT: (0, units * 4 // 5),
        MISS: (units + units // 5 + 1, 3 * units),
    }[kind]
    height = draw.integer(low, top) * draw.sign()
    reach = ratio * units
    i = draw.integer(reach // 2, reach)
    gap = draw.choice((reach // 4, reach // 500))
    j = i - draw.integer(gap // 2, gap) if draw.integer(0, 3) else -draw.integer(reach // 8, reach)
    centre = draw.integer(-units, units), draw.integer(-units, units)
    figure = lines.laid(centre, units * h, (p, q), height, i, j)
    lines.require_kind(figure, kind)
    figure = _loosened(draw, swapped(figure) if draw.boolean() else figure, turn)
    return typed(draw, _off_by_a_hair(draw, figure, high) if kind == TANGENT else figure, "any")


def lopsided(draw: Draw, *, ratio: int, high: int) -> Figure:
    """Axis-parallel tangents as in `band`; of A and B one is near, the other up to `ratio` radii away."""
    radius = draw.integer(5, 500)
    centre = draw.integer(-radius, radius), draw.integer(-radius, radius)
    away = draw.integer(ratio // 2, ratio) * radius
    figure = lines.laid(centre, radius, (1, 0), radius * draw.sign(), away, draw.integer(-radius, radius))
    lines.require_kind(figure, TANGENT)
    figure = _loosened(draw, swapped(figure) if draw.boolean() else figure, False)
    return typed(draw, _off_by_a_hair(draw, figure, high), "any")


def close(draw: Draw, *, size: Sizes, bits: int, numbers: str = "any", exponent: Exponents = 0) -> Figure:
    """A and B differ, but only by a few times 2**-bits: a line all the same, and an exact one."""
    kind = draw.choice(KINDS)
    figure = lines.plain(draw, _size(draw, size), kind)
    (ax, ay), (bx, by) = figure.points
    dx, dy = lines.primitive(int(bx - ax), int(by - ay))
    big = scaled(figure, bits)
    start = big.points[0]
    near_start = Figure(big.centre, big.radius, (start, (start[0] + dx, start[1] + dy)))
    lines.require_kind(near_start, kind)
    return typed(draw, scaled(draw_mirrored(draw, near_start), _exponent(draw, exponent) - bits), numbers)


def offset(draw: Draw, *, size: Sizes, distance: Sizes, numbers: str = "any", halves: int = 0) -> Figure:
    """A small figure, moved exactly by half to all of `distance` in x and in y; in steps of 2**-halves."""
    figure = draw_mirrored(draw, lines.plain(draw, _size(draw, size), draw.choice(KINDS)))
    away = _size(draw, distance)
    dx, dy = (draw.sign() * draw.integer(away // 2, away) for _ in range(2))
    return typed(draw, moved(scaled(figure, -halves), dx, dy), numbers)


def scattered(draw: Draw, *, size: Sizes, numbers: str = "int", exponent: Exponents = 0) -> Figure:
    """Everything anywhere."""
    return typed(draw, scaled(lines.scattered(draw, _size(draw, size)), _exponent(draw, exponent)), numbers)


def off_segment(
    draw: Draw, *, size: Sizes, numbers: str = "int", turn: Turns = False, exponent: Exponents = 0
) -> Figure:
    """The line crosses the circle where the segment from A to B does not."""
    return _finished(draw, lines.off_the_segment(draw, _size(draw, size)), numbers, turn, exponent)


def just_hit(draw: Draw, *, size: Sizes, root: int = 1) -> Figure:
    """Δ' = root²: two points, by the least integers allow."""
    return _finished(draw, lines.just_hit(draw, _size(draw, size), root), "int", False, 0)


def just_miss(draw: Draw, *, size: Sizes) -> Figure:
    """Δ' = −1: no point, by the least integers allow."""
    return _finished(draw, lines.just_miss(draw, _size(draw, size)), "int", False, 0)


def small_gap(draw: Draw, *, size: Sizes, reach: int) -> Figure:
    """Δ' = δ, small, of either sign and no square, where r is prime."""
    return _finished(draw, lines.small_gap(draw, _size(draw, size), reach), "int", False, 0)


def slid(draw: Draw, *, size: Sizes, along: Sizes) -> Figure:
    """A and B close together and far along the line, so that b'² − a·c is a small difference of giants."""
    figure = lines.slid(draw, _size(draw, size), _size(draw, along), draw.choice(KINDS))
    return _finished(draw, figure, "int", False, 0)


def least_gap(draw: Draw, *, size: Sizes) -> Figure:
    """Δ' = ±m² for a small m at any size: either side of a tangent."""
    return _finished(
        draw, lines.least_gap_at_any_size(draw, _size(draw, size), draw.choice((HIT, MISS))), "int", False, 0
    )


def nearly(draw: Draw, *, size: Sizes) -> Figure:
    """Lines of every slope that hit or miss by any part of the radius; |AB| may be any part of it too."""
    figure = lines.nearly_tangent(draw, _size(draw, size), draw.choice((HIT, MISS)))
    return _finished(draw, figure, "int", False, 0)


def _finished(draw: Draw, figure: Figure, numbers: str, turn: Turns, exponent: Exponents) -> Figure:
    """The figure mirrored and perhaps reversed at random, then turned, scaled and typed as asked."""
    figure = draw_mirrored(draw, figure)
    if draw.boolean():
        figure = swapped(figure)
    if _turn(draw, turn):
        figure = turned(figure, draw_turn(draw))
    return typed(draw, scaled(figure, _exponent(draw, exponent)), numbers)


def _loosened(draw: Draw, figure: Figure, turn: Turns) -> Figure:
    """The figure in floats, turned or just mirrored, so that its radius may become any float."""
    figure = draw_mirrored(draw, figure)
    return turned(figure, draw_turn(draw)) if _turn(draw, turn) else as_floats(figure)


def _off_by_a_hair(draw: Draw, figure: Figure, high: int) -> Figure:
    change = draw.integer(-high, high) * _HAIR * figure.extent
    return with_radius(figure, float(Fraction(figure.radius) + change))


def _size(draw: Draw, sizes: Sizes) -> int:
    """The size, or one of the sizes; problem.toml writes a large one as 1e30."""
    size = draw.choice(sizes) if isinstance(sizes, Sequence) else sizes
    require(size == int(size) and size > 0, "a size is a whole number above 0")
    return int(size)


def _exponent(draw: Draw, exponents: Exponents) -> int:
    return draw.choice(exponents) if isinstance(exponents, Sequence) else exponents


def _turn(draw: Draw, turns: Turns) -> bool:
    return draw.choice(turns) if isinstance(turns, Sequence) else turns


RECIPES: Mapping[str, Recipe] = {
    "grid": grid,
    "degenerate": degenerate,
    "axis": axis,
    "zero_radius": zero_radius,
    "tangent": tangent,
    "any_kind": any_kind,
    "near": near,
    "band": band,
    "far": far,
    "lopsided": lopsided,
    "close": close,
    "offset": offset,
    "scattered": scattered,
    "off_segment": off_segment,
    "just_hit": just_hit,
    "just_miss": just_miss,
    "small_gap": small_gap,
    "slid": slid,
    "least_gap": least_gap,
    "nearly": nearly,
}
