"""Recipes for many circles and one ray: where the origin is, which hits are at one place, and how nearly.

A figure's centre is the ray's origin O and its vector the direction D; its points are the circles' centres,
its radius and its lengths their radii. A level ray stands at O = (0, 0) and runs towards +x, so that a circle
is three integers (x, y, r). What goes to `posed` is explained in posing.py.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import isqrt
from typing import Any

from msgspec.structs import replace

from judge.data.draw import Draw, require
from judge.problem.model import Number
from judge.topics.circles.crowd import Crowd, Hit
from judge.topics.circles.figures.edges import EDGES, Edge, whole_gap
from judge.topics.circles.figures.figure import (
    Figure,
    Recipe,
    as_ints,
    draw_mirrored,
    draw_point,
    moved,
    typed,
)
from judge.topics.circles.figures.posing import posed, rational_chord, small_turn, spun, stretched

LevelCircle = tuple[int, int, int]

_BITS = 64  # of what is computed here below the unit of the figure
_STEPS = 6  # bounds the level direction before it is stretched
_MOST_OBLIQUE = 3  # a hit is put somewhere where the radius is at most so many half-chords
_REACH = 1 << 26  # of whole numbers, so that figures fit into the bounds
_SHARP = 16  # figures of whole numbers are so many times smaller before they are turned


def scene(
    draw: Draw,
    *,
    kinds: Sequence[str],
    size: int,
    poses: Sequence[str],
    must: Sequence[str] = (),
    count: Sequence[int] = (1, 5),
    scales: Sequence[int] = (0,),
    stretch: Sequence[int] = (0, 0),
    divisor: int = 1,
    numbers: str = "any",
    **pose: Any,
) -> Figure:
    """Circles of these kinds, those of `must` among them, in any order; `count` bounds how many there are
    beside them, `stretch` the power of two that D is finally multiplied by.
    """
    circles = level_circles(draw, must=must, kinds=kinds, count=draw.integer(*count), size=size)
    figure = level_figure(draw, circles, divisor)
    figure = posed(
        draw, figure, poses=poses, divisor=divisor, numbers=numbers, scale=draw.choice(scales), **pose
    )
    return stretched(figure, draw.integer(*stretch))


def row(
    draw: Draw,
    *,
    size: int,
    poses: Sequence[str],
    count: Sequence[int] = (2, 4),
    scales: Sequence[int] = (0,),
    **pose: Any,
) -> Figure:
    """Small circles one after the other along the ray, and a last one that holds them all."""
    circles: list[LevelCircle] = []
    place = draw.integer(0, size)
    for _ in range(draw.integer(*count)):
        radius = draw.integer(2, size)
        offset = draw.integer(1 - radius, radius - 1)
        circles.append((place + radius + draw.integer(1, size), offset, radius))
        place = circles[-1][0] + radius
    middle = draw.integer(place // 4, place // 2)
    circles.append((middle, draw.integer(-size, size), place - middle + draw.integer(3, 5) * size))
    figure = level_figure(draw, circles, 1, shuffled=False)
    return posed(draw, figure, poses=poses, scale=draw.choice(scales), **pose)


def specks(
    draw: Draw,
    *,
    octaves: Sequence[int],
    size: int,
    poses: Sequence[str],
    count: Sequence[int] = (1, 3),
    cut: Sequence[int] = (),
    **pose: Any,
) -> Figure:
    """A large circle ahead, and circles 2**-octaves (bounds) of its size that are touched.

    With `cut` (bounds) they are so many billionths of its size, and the ray cuts them through the middle.
    """
    radius = draw.integer(size // 2, size)
    circles: list[LevelCircle] = [(2 * radius, draw.integer(-radius // 2, radius // 2), radius)]
    for _ in range(draw.integer(*count)):
        speck = radius * draw.integer(*cut) // 10**9 if cut else max(1, radius >> draw.integer(*octaves))
        place = draw.integer(3 * radius // 2, 4 * radius)
        circles.append((place, 0 if cut else speck * draw.sign(), speck))
    return posed(draw, level_figure(draw, circles, 1, shuffled=False), poses=poses, **pose)


def grid(draw: Draw, *, size: int, count: Sequence[int] = (1, 3)) -> Figure:
    """All numbers small integers."""
    circles = [(*draw_point(draw, size), draw.integer(0, size)) for _ in range(draw.integer(*count))]
    direction = draw_point(draw, size)
    if direction == (0, 0):
        draw.reject()
    return _figure(draw_point(draw, size), direction, circles)


def uniform(draw: Draw, *, size: int, count: Sequence[int] = (1, 6), numbers: str = "any") -> Figure:
    """Everything anywhere in ±size."""
    circles = [(*draw_point(draw, size), draw.integer(1, size)) for _ in range(draw.integer(*count))]
    direction = draw_point(draw, size)
    if direction == (0, 0):
        draw.reject()
    return typed(draw, _figure(draw_point(draw, size), direction, circles), numbers)


def whole(draw: Draw, *, must: Sequence[str], kinds: Sequence[str], count: Sequence[int] = (1, 4)) -> Figure:
    """Whole numbers up to the bounds, in ints; the first circle perhaps nearly touches."""
    size = _REACH >> draw.integer(5, 12)
    near = draw.choice(("", "near-hit", "near-miss"))
    circles = level_circles(draw, must=must, kinds=kinds, count=draw.integer(*count), size=size)
    turn = small_turn(draw)
    figure = spun(level_figure(draw, circles, 1, shuffled=not near), turn)
    if near:
        # The first circle is off a touch by whole units, which the turned figure has room for.
        (x, _, r), far = circles[0], int(figure.extent)
        gap = whole_gap(draw, far) * (1 if near == "near-hit" else -1)
        if r * turn.norm + gap <= 0:
            draw.reject()
        height = r * draw.sign()
        place = (turn.cosine * x - turn.sine * height, turn.sine * x + turn.cosine * height)
        figure = replace(figure, points=(place, *figure.points[1:]), radius=r * turn.norm + gap)
    reach = max(1, _REACH - int(figure.extent))
    return as_ints(moved(draw_mirrored(draw, figure), *draw_point(draw, reach)))


def edge(
    draw: Draw,
    *,
    sides: Sequence[str],
    edges: Sequence[str],
    poses: Sequence[str],
    size: int = 200,
    scales: Sequence[int] = (0,),
    stretch: Sequence[int] = (0, 0),
    count: Sequence[int] = (0, 2),
    ratio: Sequence[int] = (),
    around: Sequence[int] = (),
    **pose: Any,
) -> Figure:
    """Circles of which one is at the very edge of what is decided, by a share of the extent.

    The ray cuts it ("hit") or misses it ("miss"); it has a hit just "ahead" of the origin or "behind" it; or
    just "before" or "after" a hit of another circle. `count` bounds how many others there are. With `ratio`
    one more is so many sizes behind the origin, with `around` the radius of one about it is so many.
    """
    side = draw.choice(sides)
    circles = _special(draw, side, size)
    circles += [_one(draw, "ahead", size, circles) for _ in range(draw.integer(*count))]
    if ratio:
        circles.append((-size * draw.integer(*ratio), draw.integer(-size, size), draw.integer(1, size)))
    if around:
        circles.append((*draw_point(draw, size), size * draw.integer(*around)))
    figure = level_figure(draw, circles, 1, shuffled=False)
    figure = posed(draw, figure, poses=poses, numbers="float", scale=draw.choice(scales), **pose)
    name = draw.choice(edges)
    require(name in EDGES, f"{name!r} is an edge, one of {', '.join(EDGES)}")
    figure = _off(draw, figure, EDGES[name], side)
    return typed(draw, _shuffled(draw, stretched(figure, draw.integer(*stretch))), "any")


def crowd_of(figure: Figure) -> Crowd:
    """The figure's circles and ray, in integers."""
    return Crowd.of(circles_of(figure), figure.centre, figure.vectors[0])


def circles_of(figure: Figure) -> tuple[tuple[Number, Number, Number], ...]:
    """The figure's circles, (x, y, r) each; points beyond the radii are none."""
    radii = (figure.radius, *figure.lengths)
    return tuple((*place, r) for place, r in zip(figure.points, radii, strict=False))


def level_figure(
    draw: Draw, circles: Sequence[LevelCircle], divisor: int, *others: tuple[int, int], shuffled: bool = True
) -> Figure:
    """The figure of a level ray from (0, 0) and these circles, perhaps in another order; and other points."""
    direction = (draw.integer(1, _STEPS) * divisor, 0)
    figure = _figure((0, 0), direction, circles)
    figure = _shuffled(draw, figure) if shuffled else figure
    return replace(figure, points=(*figure.points, *others))


def level_circles(
    draw: Draw, *, must: Sequence[str], kinds: Sequence[str], count: int, size: int
) -> list[LevelCircle]:
    """LevelCircle circles of these kinds; those of `must` come first."""
    found: list[LevelCircle] = []
    for kind in (*must, *(draw.choice(kinds) for _ in range(count))):
        found.append(_one(draw, kind, size, found))
    return found


def _figure(origin: tuple[int, int], direction: tuple[int, int], circles: Sequence[LevelCircle]) -> Figure:
    places = tuple((x, y) for x, y, _ in circles)
    first, *radii = (r for _, _, r in circles)
    return Figure(origin, first, places, (direction,), tuple(radii))


def _shuffled(draw: Draw, figure: Figure) -> Figure:
    circles = list(circles_of(figure))
    for last in range(len(circles) - 1, 0, -1):
        other = draw.integer(0, last)
        circles[last], circles[other] = circles[other], circles[last]
    points = tuple((x, y) for x, y, _ in circles)
    first, *radii = (r for _, _, r in circles)
    return Figure(figure.centre, first, points, figure.vectors, tuple(radii))


def _one(draw: Draw, kind: str, size: int, others: Sequence[LevelCircle]) -> LevelCircle:
    """A circle that the ray cuts (ahead), begins in (around), passes (beside), leaves behind, touches (touch,
    touch-at, touch-behind: where, at the origin, behind), or begins on, entering (on-in) or leaving (on-out).

    point and off-point have no radius. Of others there are a copy, one about the same centre (nested), one
    through one of their hits (tied), one across the ray (mirror), one that begins where it ends (next), and
    one that overlaps it (overlap).
    """
    if kind in ("copy", "nested", "tied", "mirror", "next", "overlap"):
        return _beside(draw, kind, size, draw.choice(others or [_one(draw, "ahead", size, ())]))
    radius = draw.integer(2, size)
    if kind in ("touch", "touch-at", "touch-behind"):
        away = {"touch": draw.integer(1, 2 * size), "touch-at": 0}.get(kind, -draw.integer(1, 2 * size))
        return away, radius * draw.sign(), radius
    if kind in ("point", "off-point", "point-at"):
        away = 0 if kind == "point-at" else draw.sign() * draw.integer(1, 2 * size)
        return away, draw.sign() * draw.integer(1, size) if kind == "off-point" else 0, 0
    if kind == "beside":
        return draw.integer(-size, 2 * size), (radius + draw.integer(1, size)) * draw.sign(), radius
    if kind in ("on-in", "on-out"):
        radius, offset, half = rational_chord(draw, size)
        return (half if kind == "on-in" else -half), offset, radius
    if draw.boolean():
        radius, offset, half = rational_chord(draw, size)
        inner, outer = max(0, half - 1), half + 1
    else:
        offset = draw.integer(1 - radius, radius - 1)
        inner = isqrt(radius * radius - offset * offset - 1)
        outer = isqrt(radius * radius - offset * offset) + 1
    places = {
        "ahead": outer + draw.integer(0, 2 * size),
        "around": draw.integer(-inner, inner),
        "behind": -outer - draw.integer(0, size),
    }
    require(kind in places, f"{kind!r} is a way for a circle to lie on a ray")
    return places[kind], offset, radius


def _beside(draw: Draw, kind: str, size: int, other: LevelCircle) -> LevelCircle:
    x, y, r = other
    if kind == "copy":
        return other
    if kind == "mirror":
        return x, -y, r
    if kind == "nested":
        return x, y, draw.integer(1, 2 * size)
    if kind == "overlap":
        radius = draw.integer(2, size)
        return x + draw.integer(-r, r), draw.integer(1 - radius, radius - 1), radius
    half = isqrt(max(0, r * r - y * y))
    if half * half != r * r - y * y:
        draw.reject()
    radius, offset, reach = rational_chord(draw, size)
    if kind == "next":
        return x + half + reach, offset, radius
    require(kind == "tied", f"{kind!r} is a way to lie beside another circle")
    return x + half * draw.sign() + reach * draw.sign(), offset, radius


def _special(draw: Draw, side: str, size: int) -> list[LevelCircle]:
    """LevelCircle circles, the first of which the share is to change."""
    radius = draw.integer(size // 2, size)
    if side in ("hit", "miss"):
        return [(draw.integer(radius, 3 * size), radius * draw.sign(), radius)]
    offset = draw.integer(-radius * 9 // 10, radius * 9 // 10)
    half = isqrt(radius * radius - offset * offset)
    if side in ("ahead", "behind"):
        return [(half * draw.sign(), offset, radius)]
    require(side in ("before", "after"), f"{side!r} is a side of something decided")
    other = _one(draw, "ahead", size, ())
    x, y, r = other
    at = x + isqrt(max(0, r * r - y * y)) * draw.sign()
    return [(at + half * draw.sign(), offset, radius), other]


def _off(draw: Draw, figure: Figure, edge: Edge, side: str) -> Figure:
    """The figure with a first radius that puts its circle at the edge."""
    seen = crowd_of(replace(figure, radius=0))
    share = Fraction(edge.share(draw), edge.units) * (1 if side in ("hit", "ahead", "after") else -1)
    line = seen.lines[0]
    if side in ("hit", "miss"):
        distance = isqrt((line.k * line.k << 2 * _BITS) // line.a)
        gap = share * max(distance, seen.extent << _BITS)
        changed = _with(figure, distance + int(gap), seen.shift)
        require(edge.window.has_tangent(crowd_of(changed).lines[0], side), "the circle is off by the share")
        return changed
    away = isqrt((line.ax - line.cx) ** 2 + (line.ay - line.cy) ** 2)
    t = _target(crowd_of(figure), side) + share * max(away, seen.extent) / seen.step
    x, y = line.ax + t * line.dx - line.cx, line.ay + t * line.dy - line.cy
    square = x * x + y * y
    if square > _MOST_OBLIQUE**2 * (square - Fraction(line.k * line.k, line.a)):
        draw.reject()
    changed = _with(figure, isqrt((square.numerator << 2 * _BITS) // square.denominator), seen.shift)
    if not _is_there(crowd_of(changed), edge, side):
        draw.reject()  # rounded too far, or another hit was meant
    return changed


def _with(figure: Figure, radius: int, shift: int) -> Figure:
    return replace(figure, radius=radius / (1 << (shift + _BITS)))


def _target(crowd: Crowd, side: str) -> Fraction:
    """t of the place that the first circle's hit is put next to: of its own old hit's neighbour, nearly."""
    if side in ("ahead", "behind"):
        return Fraction(0)
    own, other = crowd.lines[:2]
    places = [Fraction(hit, other.a << _BITS) for hit in _roots(other)]
    return min(places, key=lambda t: min(abs(t - Fraction(hit, own.a << _BITS)) for hit in _roots(own)))


def _roots(line: Any) -> list[int]:
    root = isqrt(max(0, line.delta) << 2 * _BITS)
    return [(-line.b << _BITS) - root, (-line.b << _BITS) + root]


def _is_there(crowd: Crowd, edge: Edge, side: str) -> bool:
    """Whether a hit of the first circle is off by the share that was asked for, on the right side."""
    low, high = (Fraction(width.n, width.m) for width in (edge.window.low, edge.window.high))
    own = _hits(crowd, 0)
    others = _hits(crowd, 1) if side in ("before", "after") else [Hit(0, 0, 0, 0)]
    return any(
        crowd.together(one, other, high)
        and not crowd.together(one, other, low, strictly=True)
        and (one.near > other.near) == (side in ("ahead", "after"))
        for one in own
        for other in others
    )


def _hits(crowd: Crowd, index: int) -> list[Hit]:
    line = crowd.lines[index]
    if line.delta <= 0:
        return []
    return [
        Hit(near, -line.b, side, line.delta, index, side)
        for side, near in zip((-1, 1), _roots(line), strict=True)
    ]


RECIPES: Mapping[str, Recipe] = {
    "scene": scene,
    "row": row,
    "specks": specks,
    "grid": grid,
    "uniform": uniform,
    "whole": whole,
    "crowd-edge": edge,
}
