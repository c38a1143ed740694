"""Spheres and rays before they are cases, and the changes that keep what a recipe built.

A recipe lays its ray level in a plane, as those of circles do: the sphere's centre at the origin, numbers
that are whole. A pose then takes it to any direction, place, size and number type:

    axis    one of the 48 symmetries of the cube, so that two axes are all there is to see; exact
    exact   turned by four small whole numbers (a quaternion) and enlarged by their norm; exact
    any     turned by larger ones and divided again; every number is rounded once

Everything is made of integers, `/` of integers and `ldexp`, so that the data come out alike on every machine.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import isqrt, ldexp

from msgspec import Struct
from msgspec.structs import replace

from judge.data.draw import Draw, require
from judge.topics.circles.figures.edges import Edge
from judge.topics.circles.figures.figure import Figure, exact_float, exact_sum, integer
from judge.topics.spheres.hit import Number, SphereRay, Triple, Whole

POSES = ("axis", "exact", "any")
NUMBERS = ("int", "float", "mixed", "any")

_SMALL, _LARGE = 2, 40  # bounds the four numbers of an exact turn, and of one that is rounded
_BITS = 64  # of what is computed here below the unit of the figure
_MOST_OBLIQUE = 3  # a root is moved where the sphere is not met at a flatter angle

Case = tuple[Triple, Number, Triple, Triple]


class Scene(Struct, frozen=True):
    """A sphere and a ray."""

    centre: Triple
    radius: Number
    origin: Triple
    direction: Triple

    @property
    def case(self) -> Case:
        """The arguments C, r, O, D."""
        return self.centre, self.radius, self.origin, self.direction

    def hit(self) -> SphereRay:
        """Both in integers."""
        return SphereRay.of(*self.case)


def lifted(figure: Figure) -> Scene:
    """A circle and a ray in whole numbers as a sphere and a ray in the plane z = 0."""
    (x, y), (u, v), (dx, dy) = figure.centre, figure.points[0], figure.vectors[0]
    return Scene((x, y, 0), figure.radius, (u, v, 0), (dx, dy, 0))


def placed(
    draw: Draw,
    scene: Scene,
    *,
    poses: Sequence[str],
    numbers: str = "any",
    centre: int = 2,
    scale: int = 0,
    far: int = 0,
    stretch: Sequence[int] = (0, 0),
) -> Scene:
    """A scene of whole numbers in one of `poses`.

    `centre` moves it by up to that many times its extent, `scale` multiplies it by 2**scale, `far` moves it
    by up to ±2**far (exactly), and D is multiplied by two to a power between `stretch`.
    """
    pose = draw.choice(poses)
    require(pose in POSES, f"a pose is one of {', '.join(POSES)}")
    if pose == "axis":
        scene, norm = turned(scene, _cube(draw), 1), 1
    else:
        rows, norm = _quaternion(draw, _SMALL if pose == "exact" else _LARGE)
        scene = turned(scene, rows, norm)
    reach = centre * scene.hit().extent
    scene = moved(scene, _triple(draw, reach))
    if pose == "any":
        scene = _each(scene, lambda value: integer(value) / norm)
    scene = stretched(scaled(scene, scale), draw.integer(*stretch))
    if far:
        scene = moved(scene, _triple(draw, 1 << far, 1 << (far - 1)))
    return typed(draw, scene, numbers)


def turned(scene: Scene, rows: Sequence[Whole], norm: int) -> Scene:
    """The scene of whole numbers turned by a matrix of such that makes every length `norm` times as long."""

    def turn(point: Triple) -> Triple:
        x, y, z = (sum(part * integer(value) for part, value in zip(row, point, strict=True)) for row in rows)
        return x, y, z

    radius = norm * integer(scene.radius)
    return Scene(turn(scene.centre), radius, turn(scene.origin), turn(scene.direction))


def moved(scene: Scene, by: Triple) -> Scene:
    """The scene moved, exactly."""

    def move(point: Triple) -> Triple:
        return exact_sum(point[0], by[0]), exact_sum(point[1], by[1]), exact_sum(point[2], by[2])

    return replace(scene, centre=move(scene.centre), origin=move(scene.origin))


def scaled(scene: Scene, exponent: int) -> Scene:
    """The scene times 2**exponent, exactly."""
    return _each(scene, lambda value: _shifted(value, exponent)) if exponent else scene


def stretched(scene: Scene, exponent: int) -> Scene:
    """The scene with D times 2**exponent, exactly."""
    x, y, z = (_shifted(value, exponent) for value in scene.direction)
    return replace(scene, direction=(x, y, z))


def typed(draw: Draw, scene: Scene, numbers: str) -> Scene:
    """The scene in ints as far as it is whole, in floats, or mixed; of "any" a third each."""
    require(numbers in NUMBERS, f"numbers is one of {', '.join(NUMBERS)}")
    kind = ("int", "float", "mixed")[draw.integer(0, 2)] if numbers == "any" else numbers
    if kind == "int":
        return _each(scene, _whole)
    if kind == "float":
        return _each(scene, exact_float)
    flips = iter([draw.boolean() for _ in range(10)])
    changed = _each(scene, lambda value: exact_float(value) if next(flips) else _whole(value))
    kinds = {type(value) for value in _numbers(changed)}
    if kinds == {int}:
        return replace(changed, radius=exact_float(changed.radius))
    return replace(changed, radius=_whole(changed.radius)) if kinds == {float} else changed


def touch_off(draw: Draw, scene: Scene, edge: Edge, side: str) -> Scene:
    """The scene with a radius that its line touches but for a share of the extent: a "hit" or a "miss"."""
    bare = replace(scene, radius=0).hit()
    if bare.a == 0:
        draw.reject()
    distance = isqrt((bare.square << 2 * _BITS) // bare.a)
    gap = _share(draw, edge, max(distance, bare.extent << _BITS))
    changed, hit = _with(draw, scene, distance + gap if side == "hit" else distance - gap, bare.shift)
    here = hit.delta > 0 if side == "hit" else hit.delta < 0
    there = edge.window.has_share(hit.square * hit.a, hit.r * hit.a, hit.extent * hit.a)
    require(here and there, f"the line is a {side} by the share that was asked for")
    return changed


def root_off(draw: Draw, scene: Scene, edge: Edge, sign: int) -> Scene:
    """The scene with a radius that puts a root ahead of O (sign 1) or behind it (−1), by a share."""
    bare = replace(scene, radius=0).hit()
    square = sum(x * x for x in bare.f)
    if bare.a == 0 or _MOST_OBLIQUE**2 * bare.b * bare.b < square * bare.a:
        draw.reject()  # the root would move much farther than the radius changes
    t = Fraction(sign * _share(draw, edge, max(isqrt(square << 2 * _BITS), bare.extent << _BITS)), bare.step)
    there = square * (1 << 2 * _BITS) + 2 * t * bare.b * (1 << _BITS) + t * t * bare.a
    changed, hit = _with(draw, scene, isqrt(int(there)), bare.shift)
    low, high = (Fraction(width.n, width.m) for width in (edge.window.low, edge.window.high))
    require(
        hit.delta > 0
        and any(
            hit.root(which).sign() == sign
            and hit.at_origin(which, high)
            and not hit.at_origin(which, low, strictly=True)
            for which in (-1, 1)
        ),
        "a root is off by the share that was asked for",
    )
    return changed


def _with(draw: Draw, scene: Scene, radius: int, shift: int) -> tuple[Scene, SphereRay]:
    if radius <= 0:
        draw.reject()
    changed = replace(scene, radius=radius / (1 << (shift + _BITS)))
    return changed, changed.hit()


def _share(draw: Draw, edge: Edge, extent: int) -> int:
    return extent * edge.share(draw) // edge.units


def _cube(draw: Draw) -> list[Whole]:
    """One of the 48 symmetries of the cube, as the rows of its matrix."""
    order = draw.choice(((0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)))
    rows = []
    for axis in order:
        sign = draw.sign()
        rows.append((sign * (axis == 0), sign * (axis == 1), sign * (axis == 2)))
    return rows


def _quaternion(draw: Draw, size: int) -> tuple[list[Whole], int]:
    """The turn of four whole numbers up to `size`, at least three of them other than 0, times their norm."""
    a, b, c, d = (draw.integer(-size, size) for _ in range(4))
    if (a, b, c, d).count(0) > 1:
        draw.reject()
    norm = a * a + b * b + c * c + d * d
    rows = [
        (a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)),
        (2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)),
        (2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d),
    ]
    require(all(sum(x * x for x in row) == norm * norm for row in rows), "a turn keeps lengths")
    return rows, norm


def _triple(draw: Draw, most: int, least: int = 0) -> Triple:
    x, y, z = (
        draw.sign() * draw.integer(least, most) if least else draw.integer(-most, most) for _ in range(3)
    )
    return x, y, z


def _shifted(value: Number, exponent: int) -> Number:
    if isinstance(value, int) and exponent >= 0:
        return value << exponent
    result = ldexp(exact_float(value), exponent)
    require(ldexp(result, -exponent) == value, f"{value!r} scales exactly")
    return result


def _whole(value: Number) -> Number:
    return int(value) if isinstance(value, float) and value.is_integer() else value


def _numbers(scene: Scene) -> tuple[Number, ...]:
    return (*scene.centre, scene.radius, *scene.origin, *scene.direction)


def _each(scene: Scene, change: Callable[[Number], Number]) -> Scene:
    cx, cy, cz, r, ox, oy, oz, dx, dy, dz = map(change, _numbers(scene))
    return Scene((cx, cy, cz), r, (ox, oy, oz), (dx, dy, dz))
