"""Recipes for first steps: a few points and perhaps a circle in whole numbers, just so or nearly so.

Each draws a figure whose numbers are all within `reach`, which is one bound or several of which one is drawn.
`off` are the whole numbers by which something is missed, 0 where it is met.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from math import gcd, isqrt

from judge.data.draw import Draw, require
from judge.topics.circles.figures.figure import Figure, Recipe, draw_mirrored, draw_point
from judge.topics.circles.figures.lines import primitive, with_cross
from judge.topics.circles.figures.numbers import off_by_one, pythagorean

Reach = int | Sequence[int]
IntPoint = tuple[int, int]
Near = tuple[IntPoint, int, int]  # a direction, a cross product with it, a radius

_BEST = 2  # of the choices that go so far in x, the last that counts as nearest
_LEAST = 20  # how many of all choices do
_NEARLY = 64  # less than this part of it below a size is nearly the size
_STEPS = 3  # how many lengths of A→B a third point may be away along the line


def scattered(
    draw: Draw, *, reach: Reach, points: int, circle: bool = False, corners: bool = False
) -> Figure:
    """So many points anywhere; with `circle` one about any centre, its radius at least 1.

    With `corners` those of every second figure are nearly in the corners of what is within reach, or about
    its middle; of three points the last is often on the side opposite to the others'.
    """
    size = _reach(draw, reach)
    if corners and draw.boolean():
        if points == 3 and draw.boolean():
            return _opposite(draw, size)
        return Figure((0, 0), 0, tuple(_corner(draw, size) for _ in range(points)))
    centre = draw_point(draw, size) if circle else (0, 0)
    radius = draw.integer(1, size) if circle else 0
    return Figure(centre, radius, tuple(draw_point(draw, size) for _ in range(points)))


def apart(draw: Draw, *, reach: Reach) -> Figure:
    """Two points anywhere, or nearly `reach` apart in x, and in y."""
    size = _reach(draw, reach)
    if draw.boolean():
        return Figure((0, 0), 0, (draw_point(draw, size), draw_point(draw, size)))
    return _fitted(draw, 0, ((0, 0), (_nearly(draw, size), _nearly(draw, size))), size)


def lined_up(draw: Draw, *, reach: Reach) -> Figure:
    """Two points that agree in y, in x or in both."""
    size = _reach(draw, reach)
    x, y = draw_point(draw, size)
    other = x if draw.integer(0, 5) == 0 else draw.integer(-size, size)
    return draw_mirrored(draw, Figure((0, 0), 0, ((x, y), (other, y))))


def beside_line(draw: Draw, *, reach: Reach, off: Sequence[int], broad: int = 0) -> Figure:
    """A, B and P: the cross product of B − A and P − A is `off`, or a small multiple of it.

    In every fourth figure those differences are nearly `broad` in x and in y, unless it is 0.
    """
    if broad and draw.integer(0, 3) == 0:
        return _fitted(draw, 0, ((0, 0), *_broad(draw, int(broad), off)), int(broad))
    size = _reach(draw, reach)
    direction = _direction(draw, 2 * size)
    times = draw.choice((1, 1, 1, 2))
    away = _away(draw, direction, off)
    end = times * direction[0], times * direction[1]
    return _fitted(draw, 0, ((0, 0), end, away), size, swap=draw.boolean())


def beside_circle(draw: Draw, *, reach: Reach, on: bool, broad: int = 0) -> Figure:
    """A circle and P: on it, or off it by one at most, often on a diagonal and mostly as near as ints come.

    In every eighth figure the radius is nearly `broad`, and P just above the circle's end, unless it is 0.
    """
    if broad and draw.integer(0, 7) == 0:
        radius = _nearly(draw, int(broad))
        return _fitted(draw, radius, ((radius, draw.integer(1, 3)),), 2 * int(broad))
    most = _reach(draw, reach)
    size = most // 2
    if on:
        size = _magnitude(draw, size)
        p, q, h = (1, 0, 1) if size < 5 or draw.integer(0, 3) == 0 else pythagorean(draw, min(size, 1 << 12))
        times = draw.integer(1, size // h)
        return _fitted(draw, h * times, ((p * times, q * times),), most)
    if draw.integer(0, 3):
        size = min(size, 1 << draw.integer(0, size.bit_length()))
    if size >= 8 and draw.integer(0, 3):
        x, y, radius = off_by_one(draw, size, draw.sign())
    else:
        x, y = draw_point(draw, size)
        if draw.boolean():
            y = x + draw.integer(-1, 1)
        radius = isqrt(x * x + y * y) + draw.integer(0, 1)
    if radius == 0 or x * x + y * y == radius * radius:
        draw.reject()
    return _fitted(draw, radius, ((x, y),), most)


def right_angle(
    draw: Draw, *, reach: Reach, off: Sequence[int], broad: int = 0, level: bool = False
) -> Figure:
    """A, B and P: the scalar product of A − P and B − P is `off`, 0 on the circle with the diameter AB.

    In every fourth figure those differences are nearly `broad` in x and in y, unless it is 0. With `level` AB
    is level or upright in every third, and P on the circle.
    """
    if level and draw.integer(0, 2) == 0:
        return _level_diameter(draw, _reach(draw, reach))
    if broad and draw.integer(0, 3) == 0:
        size = int(broad)
        first, (u, v) = _broad(draw, size, off)
    else:
        size = _reach(draw, reach)
        first = _direction(draw, 2 * size)
        u, v = _away(draw, first, off)
    second = v, -u  # a quarter turn makes a scalar product of the cross product
    return _fitted(draw, 0, (first, second, (0, 0)), size, swap=draw.boolean())


def level(draw: Draw, *, reach: Reach) -> Figure:
    """A and B on a level or upright line, and P anywhere."""
    size = _reach(draw, reach)
    (x, y), other = draw_point(draw, size), draw.integer(-size, size)
    if x == other:
        draw.reject()
    return draw_mirrored(draw, Figure((0, 0), 0, ((x, y), (other, y), draw_point(draw, size))))


def level_rounded(draw: Draw, *, reach: Reach) -> Figure:
    """The same; or the foot is near 0, and doubles round f/D times D, the way to it from A."""
    size = _reach(draw, reach)
    if draw.integer(0, 9) == 0:  # of the others nine in ten are given up below
        return level(draw, reach=size)
    start, other, foot = draw.integer(-size, size), draw.integer(-size, size), draw.integer(-9, 9)
    span, way = other - start, foot - start
    if span == 0 or way / span * span == way:
        draw.reject()
    y = draw.integer(-size, size)
    points = ((start, y), (other, y), (foot, draw.integer(-size, size)))
    return draw_mirrored(draw, Figure((0, 0), 0, points))


def level_beyond(draw: Draw, *, reach: Reach) -> Figure:
    """A and B on a level or upright line, and P not between them, but beyond one of them or just above it."""
    size = _reach(draw, reach)
    x, y = draw.integer(-size, size - 2), draw.integer(-size, size)
    other = draw.integer(x + 1, size - 1)
    p = draw.integer(other, size), draw.integer(-size, size)
    ends = ((x, y), (other, y))[:: -1 if draw.boolean() else 1]
    return draw_mirrored(draw, Figure((0, 0), 0, (*ends, p)))


def tangent(draw: Draw, *, reach: int) -> Figure:
    """A circle and a line that touches it, at a grid point or not."""
    p, q, h = (1, 0, 1) if draw.integer(0, 3) == 0 else pythagorean(draw, max(5, reach))
    radius = draw.integer(1, reach)
    return _line(draw, (p, q), h * radius, radius, reach)


def nearly(draw: Draw, *, reach: int) -> Figure:
    """A circle and a line that hits or misses it by less than one; mostly by as little as numbers allow.

    That is the least for how far the line goes in x, or the least of all.
    """
    across = draw.choice((0, draw.integer(1, 2 * reach)))
    gaps = _narrowest(across, reach)
    last = draw.choice((_BEST, len(gaps) - 1)) if across else len(gaps) - 1
    direction, cross, radius = gaps[draw.integer(0, last)]
    return _line(draw, direction, cross, radius, reach)


@lru_cache(maxsize=128)
def _narrowest(across: int, reach: int) -> tuple[Near, ...]:
    """Directions that go so far in x and no farther in y, cross products and radii: the nearest first.

    For 0 the nearest of all directions.
    """
    if not across:
        every = (near for each in range(1, 2 * reach + 1) for near in _gaps(each, reach))
        return tuple(near for _, near in sorted(every)[:_LEAST])
    return tuple(near for _, near in sorted(_gaps(across, reach)))


def _gaps(across: int, reach: int) -> Iterator[tuple[Fraction, Near]]:
    """Each with d² - r² over r, which is about twice d - r."""
    for up in (up for up in range(across + 1) if gcd(across, up) == 1):
        square = across * across + up * up
        for radius in range(1, reach + 1):
            root = isqrt(radius * radius * square)
            for cross in (root, root + 1):
                off = abs(cross * cross - radius * radius * square)
                if off:
                    yield Fraction(off, square * radius), ((across, up), cross, radius)


def _line(draw: Draw, direction: IntPoint, cross: int, radius: int, reach: int) -> Figure:
    """The line along `direction` with that cross product as seen from the centre."""
    long = max(map(abs, direction)) > reach // 2
    steps, times = (draw.integer(-1, 0), 1) if long else (draw.integer(-_STEPS, _STEPS), draw.integer(1, 3))
    x, y = with_cross(direction, cross * draw.sign(), steps)
    end = x + times * direction[0], y + times * direction[1]
    return _fitted(draw, radius, ((x, y), end), reach, swap=draw.boolean())


def _away(draw: Draw, direction: IntPoint, off: Sequence[int]) -> IntPoint:
    """A vector whose cross product with `direction` is one of `off`, the shortest one in many cases."""
    cross = draw.choice(off)
    return with_cross(direction, cross, 0 if cross and draw.boolean() else draw.integer(-_STEPS, _STEPS))


def _level_diameter(draw: Draw, size: int) -> Figure:
    """The foot of P divides AB into p²·n and q²·n, so P is on the circle at the height p·q·n."""
    p, q = (draw.integer(1, isqrt(size)) for _ in range(2))
    times = draw.integer(1, max(1, 2 * size // (p * p + q * q)))
    points = (0, 0), ((p * p + q * q) * times, 0), (p * p * times, p * q * times)
    return _fitted(draw, 0, points, size, swap=draw.boolean())


def _broad(draw: Draw, size: int, off: Sequence[int]) -> tuple[IntPoint, IntPoint]:
    """Two vectors whose cross product is one of `off`; all four numbers are nearly ±`size`."""
    little = size // _NEARLY
    step = primitive(_nearly(draw, little), _nearly(draw, little))
    most = size // max(step) - 1
    far = with_cross(step, draw.choice(off), _nearly(draw, most))
    near, sign = (far[0] - step[0], far[1] - step[1]), draw.sign()
    return far, (sign * near[0], sign * near[1])


def _nearly(draw: Draw, size: int) -> int:
    return size - draw.integer(0, size // _NEARLY)


def _opposite(draw: Draw, size: int) -> Figure:
    """A and B nearly in two corners of what is within reach, and P nearly on the side opposite."""
    low, high = (-_nearly(draw, size), -_nearly(draw, size)), (-_nearly(draw, size), _nearly(draw, size))
    p = _nearly(draw, size), draw.integer(-(size // 4), size // 4)
    return draw_mirrored(draw, Figure((0, 0), 0, (low, high, p)))


def _corner(draw: Draw, size: int) -> IntPoint:
    """Nearly a corner of the square from −size to size; or a point about its middle."""
    if draw.integer(0, 2) == 0:
        return draw_point(draw, size // 8)
    return draw.sign() * _nearly(draw, size), draw.sign() * _nearly(draw, size)


def _direction(draw: Draw, size: int) -> IntPoint:
    """A vector without a common factor, of any magnitude."""
    x, y = draw_point(draw, _magnitude(draw, size))
    if x == y == 0:
        draw.reject()
    return primitive(x, y)


def _magnitude(draw: Draw, size: int) -> int:
    """The size in every second case, else anything up to it, every power of two as likely as the next."""
    return size if draw.boolean() else min(size, 1 << draw.integer(0, size.bit_length()))


def _fitted(
    draw: Draw, radius: int, points: tuple[IntPoint, ...], reach: int, *, swap: bool = False
) -> Figure:
    """The figure about the origin, mirrored and moved anywhere within `reach`; `swap` exchanges A and B."""
    if swap:
        points = (points[1], points[0], *points[2:])
    figure = draw_mirrored(draw, Figure((0, 0), radius, points))
    (dx, dy) = (_room(draw, [0, *(int(point[axis]) for point in figure.points)], reach) for axis in (0, 1))
    require(radius <= reach, "the radius is within reach")
    moved = tuple((x + dx, y + dy) for x, y in figure.points)
    return Figure((dx, dy), radius, moved)


def _room(draw: Draw, values: Sequence[int], reach: int) -> int:
    """How far these may all be moved and stay within `reach`, drawn; some rooms have no place."""
    low, high = -reach - min(values), reach - max(values)
    if low > high:
        draw.reject()
    return draw.integer(low, high)


def _reach(draw: Draw, reach: Reach) -> int:
    size = draw.choice(reach) if isinstance(reach, Sequence) else reach
    require(size == int(size) and size > 0, "reach is a whole number above 0")
    return int(size)


RECIPES: Mapping[str, Recipe] = {
    "scattered": scattered,
    "apart": apart,
    "lined_up": lined_up,
    "beside_line": beside_line,
    "beside_circle": beside_circle,
    "right_angle": right_angle,
    "level": level,
    "level_rounded": level_rounded,
    "level_beyond": level_beyond,
    "tangent": tangent,
    "nearly": nearly,
}
