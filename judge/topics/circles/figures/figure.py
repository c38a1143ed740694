"""Figures, and the changes that keep what a recipe built.

A recipe works in small integers. These functions then carry its figure to where programs fail: far from the
origin, to other scales, to any direction, from int to float. All of them are exact but `turned`,
which round every number once and correctly. They use integers, `/` of integers and `ldexp` only, no sine or
cosine, so the data come out the same on every machine.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from itertools import chain

from msgspec import Struct
from msgspec.structs import replace

from judge.data.draw import Draw, require
from judge.exact.dyadic import integers
from judge.problem.model import Number, Point
from judge.topics.circles.figures.numbers import pythagorean

NUMBER_TYPES = ("int", "float", "mixed", "any")


class Figure(Struct, frozen=True):
    """A circle, points, free vectors (which a move leaves alone) and lengths, before it becomes a case.

    Lengths are scaled as the radius is, such as the radius of another circle.
    """

    centre: Point
    radius: Number
    points: tuple[Point, ...]
    vectors: tuple[Point, ...] = ()
    lengths: tuple[Number, ...] = ()

    @property
    def extent(self) -> Fraction:
        """The largest of r, the lengths, and |x|, |y| of the points seen from the centre, exactly."""
        (cx, cy, radius, *rest), shift = integers(
            *self.centre, self.radius, *chain(*self.points), *self.lengths
        )
        flat, lengths = rest[: 2 * len(self.points)], rest[2 * len(self.points) :]
        spans = [abs(x - cx) for x in flat[::2]] + [abs(y - cy) for y in flat[1::2]]
        return Fraction(max(radius, *spans, *lengths), 1 << shift)


Recipe = Callable[..., Figure]  # (draw, **parameters), every choice taken from `draw`


class Turn(Struct, frozen=True):
    """The rotation that takes (1, 0) to (cosine, sine) / norm: integers, cosine² + sine² = norm²."""

    cosine: int
    sine: int
    norm: int


def line(centre: Point, radius: Number, a: Point, b: Point) -> Figure:
    """The figure of a line or segment from A to B."""
    return Figure(centre, radius, (a, b))


def ray(centre: Point, radius: Number, origin: Point, direction: Point) -> Figure:
    """The figure of a ray from O along D."""
    return Figure(centre, radius, (origin,), (direction,))


def swapped(figure: Figure) -> Figure:
    """The figure with its points in reverse order."""
    return replace(figure, points=figure.points[::-1])


def exact_sum(x: Number, y: Number) -> Number:
    """x + y, checked to be free of rounding."""
    total = x + y
    # In doubles the two remainders are 0 exactly where nothing was rounded (Knuth's TwoSum); comparisons with
    # an int are exact in Python.
    if isinstance(total, float):
        a, b = float(x), float(y)
        back = total - a
        exact = a == x and b == y and a - (total - back) == 0 == b - back
        require(exact, f"{x!r} + {y!r} is exact")
    return total


def moved(figure: Figure, dx: Number, dy: Number) -> Figure:
    """The figure moved by (dx, dy), exactly."""

    def move(point: Point) -> Point:
        return exact_sum(point[0], dx), exact_sum(point[1], dy)

    return replace(figure, centre=move(figure.centre), points=tuple(move(point) for point in figure.points))


def scaled(figure: Figure, exponent: int) -> Figure:
    """The figure times 2**exponent, exactly; a negative exponent makes every number a float."""

    def scale(value: Number) -> Number:
        if isinstance(value, int) and exponent >= 0:
            return value << exponent
        plain = float(value)
        result = math.ldexp(plain, exponent)
        # Only a subnormal result is ever rounded, and one that was does not come back.
        if plain != value or math.ldexp(result, -exponent) != plain:
            require(False, f"{value!r} scales exactly")
        return result

    return _each_number(figure, scale) if exponent else figure


def mirrored(figure: Figure, symmetry: int) -> Figure:
    """The figure under one of the 8 symmetries of the square about the origin, exactly; 0 changes nothing."""

    def mirror(point: Point) -> Point:
        x, y = point
        x, y = (-x if symmetry & 1 else x), (-y if symmetry & 2 else y)
        return (y, x) if symmetry & 4 else (x, y)

    return replace(
        figure,
        centre=mirror(figure.centre),
        points=tuple(mirror(point) for point in figure.points),
        vectors=tuple(mirror(vector) for vector in figure.vectors),
    )


def turned(figure: Figure, turn: Turn, divisor: int = 1) -> Figure:
    """The integer figure turned about the origin and divided by `divisor`, each number rounded once.

    The rounding moves a point by up to 2⁻⁵³ of its distance from the origin: a tangent stays one within the
    bands only if the origin is not much farther away than the figure is wide, and |B − A| not much shorter.
    """
    require(turn.cosine**2 + turn.sine**2 == turn.norm**2, "a turn keeps lengths")

    def rotate(point: Point) -> Point:
        x, y = integer(point[0]), integer(point[1])
        divide = turn.norm * divisor
        return (turn.cosine * x - turn.sine * y) / divide, (turn.sine * x + turn.cosine * y) / divide

    return Figure(
        rotate(figure.centre),
        integer(figure.radius) / divisor,
        tuple(rotate(point) for point in figure.points),
        tuple(rotate(vector) for vector in figure.vectors),
        tuple(integer(length) / divisor for length in figure.lengths),
    )


def as_floats(figure: Figure) -> Figure:
    """The figure with every number a float of the same value."""
    return _each_number(figure, exact_float)


def as_ints(figure: Figure) -> Figure:
    """The figure with every number an int that is integral."""
    return _each_number(figure, _whole)


def mixed(draw: Draw, figure: Figure) -> Figure:
    """The figure with some of its integral numbers as ints and the others as floats.

    There is one of either type, unless no number of the figure is integral.
    """
    flips = iter([draw.boolean() for _ in range(_how_many(figure))])
    changed = _each_number(figure, lambda value: exact_float(value) if next(flips) else _whole(value))
    kinds = {type(value) for value in _numbers(changed)}
    if kinds == {int}:
        return replace(changed, radius=exact_float(changed.radius))
    if kinds == {float}:
        return replace(changed, radius=_whole(changed.radius), centre=_whole_pair(changed.centre))
    return changed


def typed(draw: Draw, figure: Figure, numbers: str) -> Figure:
    """The figure with its numbers as they are ("int"), all floats ("float"), of both types ("mixed"), or
    ("any") a third of the figures in ints as far as they are integral, a third in floats, a third mixed.
    """
    require(numbers in NUMBER_TYPES, f"numbers is one of {', '.join(NUMBER_TYPES)}")
    if numbers == "any":
        return (as_ints, as_floats, partial(mixed, draw))[draw.integer(0, 2)](figure)
    if numbers == "int":
        return figure
    return as_floats(figure) if numbers == "float" else mixed(draw, figure)


def with_radius(figure: Figure, radius: Number) -> Figure:
    """The figure with another radius."""
    return replace(figure, radius=radius)


def draw_point(draw: Draw, size: int) -> tuple[int, int]:
    """A point of integers, each up to `size` in magnitude."""
    return draw.integer(-size, size), draw.integer(-size, size)


def draw_turn(draw: Draw, size: int = 1 << 12) -> Turn:
    """A rotation by an angle whose sine and cosine no double holds; `size` bounds the norm from above."""
    cosine, sine, norm = pythagorean(draw, size)
    return Turn(cosine * draw.sign(), sine * draw.sign(), norm)


def draw_mirrored(draw: Draw, figure: Figure) -> Figure:
    """The figure under any of the 8 symmetries of the square."""
    return mirrored(figure, draw.integer(0, 7))


def exact_float(value: Number) -> float:
    """The float of the same value, checked to be it."""
    result = float(value)
    if result != value:  # which Python decides exactly
        require(False, f"{value!r} is a double")
    return result


def integer(value: Number) -> int:
    """The number, checked to be an int."""
    if not isinstance(value, int):
        require(False, f"{value!r} is an int")
        return int(value)
    return value


def _whole(value: Number) -> Number:
    return int(value) if isinstance(value, float) and value.is_integer() else value


def _whole_pair(point: Point) -> Point:
    return _whole(point[0]), _whole(point[1])


def _numbers(figure: Figure) -> Iterator[Number]:
    yield from figure.centre
    yield figure.radius
    yield from chain(*figure.points, *figure.vectors, figure.lengths)


def _how_many(figure: Figure) -> int:
    return 3 + 2 * len(figure.points) + 2 * len(figure.vectors) + len(figure.lengths)


def _each_number(figure: Figure, change: Callable[[Number], Number]) -> Figure:
    def pair(point: Point) -> Point:
        return change(point[0]), change(point[1])

    return Figure(
        pair(figure.centre),
        change(figure.radius),
        tuple(pair(point) for point in figure.points),
        tuple(pair(vector) for vector in figure.vectors),
        tuple(change(length) for length in figure.lengths),
    )
