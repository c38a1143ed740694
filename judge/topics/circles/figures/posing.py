"""From a level figure to any other: how recipes put a circle and a line into the plane.

A recipe lays its line level: the circle's centre at the origin, the line at height `offset`, running
towards +x, so that a place on the line is one integer, counted from the foot of the perpendicular. A pose
then takes the figure to any direction, place, size and number type:

    axis    one of the 8 symmetries of the square: the line stays level or becomes upright; exact
    exact   turned by a Pythagorean triple and enlarged by its hypotenuse: integers stay integers; exact
    any     turned by an angle no double holds and divided; every number is rounded once
    steep   turned by 1 down to 1e-14 off level or upright, all magnitudes alike; rounded and divided as well
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import ldexp

from msgspec.structs import replace

from judge.data.draw import Draw, require
from judge.problem.model import Number, Point
from judge.topics.circles.figures.figure import (
    Figure,
    Turn,
    draw_mirrored,
    draw_turn,
    integer,
    moved,
    scaled,
    turned,
    typed,
)
from judge.topics.circles.figures.numbers import pythagorean

POSES = ("axis", "exact", "any", "steep")
CLEAR = 10**7  # units to a level one, for a gap that is to be just wider than 1e-7 of the extent
WITHIN = 10**15  # and for one that is to be within 1e-12 of it


_ROUNDED = ("any", "steep")
_STEEPEST = 46  # octaves of the slope of a line that is nearly upright or level
_TELLING = (30, 33)  # those between the usual thresholds for a slope and for a tangency
_DIRECTIONS = 1 << 12  # bounds the hypotenuse of the direction to a point that is close
_SMALL_TRIPLES = 30  # bounds the hypotenuse, by which an exact turn enlarges a figure


def posed(
    draw: Draw,
    figure: Figure,
    *,
    poses: Sequence[str],
    numbers: str = "any",
    divisor: int = 1,
    centre: int = 2,
    scale: int = 0,
    far: int = 0,
    leaning: Sequence[int] = (),
) -> Figure:
    """A level integer figure in one of `poses`.

    `divisor` divides it (by more than 1 only in the pose "any"), `centre` moves it by up to that many times
    its extent, `scale` multiplies it by 2**scale, and `far` finally moves it by up to ±2**far (exactly).
    `leaning` bounds the octave of every second steep turn, so that it comes up more often.
    """
    pose = draw.choice(poses)
    require(pose in POSES, f"a pose is one of {', '.join(POSES)}")
    require(divisor == 1 or pose in _ROUNDED, "only a figure that is rounded is divided")
    figure = draw_mirrored(draw, figure)
    if pose == "exact":
        figure = spun(figure, small_turn(draw))
    reach = centre * int(figure.extent)
    figure = moved(figure, draw.integer(-reach, reach), draw.integer(-reach, reach))
    if pose in _ROUNDED:
        figure = turned(figure, draw_turn(draw) if pose == "any" else slight_turn(draw, leaning), divisor)
    figure = scaled(figure, scale)
    if far:
        half = 1 << (far - 1)
        figure = moved(
            figure, draw.sign() * draw.integer(half, 2 * half), draw.sign() * draw.integer(half, 2 * half)
        )
    return typed(draw, figure, numbers)


def spun(figure: Figure, turn: Turn) -> Figure:
    """The integer figure turned about the origin and enlarged by the turn's norm, exactly, in integers."""
    require(turn.cosine**2 + turn.sine**2 == turn.norm**2, "a turn keeps lengths")

    def rotate(point: Point) -> Point:
        x, y = integer(point[0]), integer(point[1])
        return turn.cosine * x - turn.sine * y, turn.sine * x + turn.cosine * y

    return Figure(
        rotate(figure.centre),
        turn.norm * integer(figure.radius),
        tuple(rotate(point) for point in figure.points),
        tuple(rotate(vector) for vector in figure.vectors),
        tuple(turn.norm * integer(length) for length in figure.lengths),
    )


def slight_turn(draw: Draw, leaning: Sequence[int] = ()) -> Turn:
    """A rotation by an angle of 1 to 1e-14, all octaves equally likely, those of 1e-9 to 1e-10 more so.

    Every second one is within the octaves of `leaning`, if there are such bounds.
    """
    often = (tuple(leaning),) * 3 if leaning else ()
    octave = draw.integer(*draw.choice(((1, _STEEPEST), (1, _STEEPEST), _TELLING, *often)))
    m = draw.integer(1 << octave, 2 << octave)
    return Turn(m * m - 1, 2 * m * draw.sign(), m * m + 1)


def closed_up(draw: Draw, figure: Figure, bits: Sequence[int]) -> Figure:
    """The figure with its second point 2**-bits (bounds) of the extent from the first."""
    p, q, h = pythagorean(draw, _DIRECTIONS)
    first, _ = figure.points
    extent = float(replace(figure, points=(first, first)).extent)
    length = ldexp(extent * draw.integer(1 << 10, 2 << 10), -10 - draw.integer(*bits))
    x, y = first
    near = x + draw.sign() * length * (p / h), y + draw.sign() * length * (q / h)
    if near == (x, y):
        draw.reject()
    return replace(figure, points=(first, near))


def stretched(figure: Figure, exponent: int) -> Figure:
    """The figure with its vectors times 2**exponent, exactly; ints stay ints where they can."""

    def stretch(value: Number) -> Number:
        if isinstance(value, int) and exponent >= 0:
            return value << exponent
        return ldexp(float(value), exponent)

    vectors = tuple((stretch(x), stretch(y)) for x, y in figure.vectors)
    return replace(figure, vectors=vectors) if exponent else figure


def hair(draw: Draw, span: int, *, within: bool, bits: int) -> tuple[int, int]:
    """A narrow gap and the `divisor` it is measured in: gap / divisor level units.

    `span` (level units) is at least the case's extent e and at most 3e. The gap is 2e-7·span at least and
    no more than 2**bits times that, all magnitudes equally likely; or, `within` the band, 1e-13·span to
    3e-13·span.
    """
    if within:
        return span * draw.integer(100, 300), WITHIN
    width = 2 << draw.integer(0, bits - 1)
    return span * draw.integer(width, 2 * width - 1), CLEAR


def lopsided_tangent(draw: Draw, size: int, ratio: Sequence[int]) -> tuple[int, int, Number]:
    """(radius, away, changed): a circle to touch, a distance of `ratio` (bounds) radii, and a radius that is
    off by most of the band that belongs to an extent of that distance.
    """
    radius = draw.integer(5, size)
    away = radius * draw.integer(*ratio)
    gap, divisor = hair(draw, away, within=True, bits=1)
    changed = float(radius + Fraction(gap * draw.sign(), divisor))
    change = abs(Fraction(changed) - radius) / away
    require(Fraction(9, 10**14) < change < Fraction(4, 10**13), "the radius is off by most of the band")
    return radius, away, changed


def rational_chord(draw: Draw, size: int) -> tuple[int, int, int]:
    """(radius, offset, half) with offset² + half² = radius² in integers: a chord with rational ends.

    The radius is at most `size` (at least 5); every sixth chord or so is a diameter.
    """
    if draw.integer(0, 5) == 0:
        radius = draw.integer(1, size)
        return radius, 0, radius
    offset, half, radius = pythagorean(draw, min(size, 5 * max(1, size // 10)))
    factor = draw.integer(1, max(1, size // radius))
    return radius * factor, offset * factor * draw.sign(), half * factor


def small_turn(draw: Draw) -> Turn:
    """A rotation by a Pythagorean triple of few digits."""
    cosine, sine, norm = pythagorean(draw, _SMALL_TRIPLES)
    return Turn(cosine * draw.sign(), sine * draw.sign(), norm)
