"""Recipes for two moving discs: how they come together, and how nearly.

Each draws a figure of P0 and r, the points P1, Q0 and Q1, and s as a length. Level figures are laid out as
seen from Q, which is at the origin: P goes along y = `height` towards +x. Then Q's own motion is added to
both. What goes to `posed` is explained in posing.py.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import isqrt
from typing import Any

from msgspec.structs import replace

from judge.data.draw import Draw, require
from judge.problem import Case
from judge.topics.circles.bands import Bands
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
from judge.topics.circles.figures.posing import posed, rational_chord, small_turn, spun
from judge.topics.circles.motion.balls import Balls

BANDS = Bands(Fraction(1, 10**12), Fraction(1, 10**7))
LEAST_RADIUS, LEAST_MOTION = Fraction(1, 10**6), Fraction(1, 10**3)
_BITS = 64  # of what is computed here below the unit of the figure
_REACH = 1 << 27  # of whole numbers, so that figures fit into the bounds
_FAST = (20, 2000)  # reaches that a fast disc goes on either side
_SPANS = ((2, 2), (8, 0), (0, 8), (0, 0), (0, 0))  # so that anything may be what makes the extent
_LONG = 100  # a way of so many sizes is never short
_SLOW = (50, 900)  # ways of P as seen from Q that Q itself goes where both go far
_OBLIQUE = 4  # the way to an end is at most so many times the way straight to the other disc


def two_balls(figure: Figure) -> Case:
    """The arguments P0, P1, r, Q0, Q1, s."""
    p1, q0, q1 = figure.points
    return (figure.centre, p1, figure.radius, q0, q1, figure.lengths[0])


def balls_of(figure: Figure) -> Balls:
    """The figure's discs in integers."""
    return Balls.of(*two_balls(figure))


def balls(
    draw: Draw,
    *,
    kinds: Sequence[str],
    size: int,
    poses: Sequence[str],
    drifts: Sequence[str] = ("any",),
    radii: Sequence[str] = ("both",),
    scales: Sequence[int] = (0,),
    ratio: Sequence[int] = _FAST,
    **pose: Any,
) -> Figure:
    """Two discs that meet in time (hit, fast, rush), that P stops before (short), misses (pass) or leaves
    (away), that overlap from the start (overlap) or touch there (touching), that graze each other (graze),
    would do so later (graze-late) or would have done so before (graze-behind); or that keep their distance
    (rest-apart, rest-overlap, rest-touching).

    `drifts` is how Q moves: any, still, along with P and faster than P nears it, far that way, against P,
    or alone. `radii` are both, or one is 0 (one), or both but one is tiny (tiny). A fast disc goes as many
    reaches on either side as `ratio` bounds.
    """
    reach, height, start, end = _level(draw, draw.choice(kinds), size, ratio)
    drift = _drift(draw, draw.choice(drifts), size, end - start)
    one, other = _radii(draw, draw.choice(radii), reach)
    points = ((end + drift[0], height + drift[1]), (0, 0), drift)
    figure = Figure((start, height), one, points, (), (other,))
    # P0 is beside the origin, so that a case is told from the next one.
    figure = moved(figure, *draw_point(draw, size))
    return _kept(draw, posed(draw, figure, poses=poses, scale=draw.choice(scales), **pose))


def grid(draw: Draw, *, size: int) -> Figure:
    """All numbers small integers."""
    start, *points = (draw_point(draw, size) for _ in range(4))
    figure = Figure(start, draw.integer(0, size), tuple(points), (), (draw.integer(0, size),))
    return _kept(draw, figure)


def edge(
    draw: Draw,
    *,
    kinds: Sequence[str],
    edges: Sequence[str],
    poses: Sequence[str],
    size: int = 1000,
    drifts: Sequence[str] = ("any",),
    scales: Sequence[int] = (0,),
    spans: Sequence[Sequence[int]] = _SPANS,
    **pose: Any,
) -> Figure:
    """Discs that nearly graze each other (graze), nearly touch at the start (start), at the end (end) or
    all the time (rest): r is more or less than that takes by a share of the extent.

    The way to a graze and the way on are up to so many times `size` as one of `spans` says; 0 is hardly any.
    """
    kind, name = draw.choice(kinds), draw.choice(edges)
    require(name in EDGES, f"{name!r} is an edge, one of {', '.join(EDGES)}")
    reach, height, start, end = _edge_level(draw, kind, size, draw.choice(spans))
    drift = _drift(draw, draw.choice(drifts), size, end - start)
    points = ((end + drift[0], height + drift[1]), (0, 0), drift)
    figure = Figure((start, height), reach, points, (), (0,))
    figure = moved(figure, *draw_point(draw, size))
    figure = posed(draw, figure, poses=poses, numbers="float", scale=draw.choice(scales), **pose)
    figure = _off(draw, figure, EDGES[name], kind)
    return typed(draw, _kept(draw, figure), "any")


def anywhere(draw: Draw, *, size: int) -> Figure:
    """Everything anywhere: whole numbers up to the bounds, or small ones that are divided."""
    if draw.boolean():
        return _whole(draw)
    start, *points = (draw_point(draw, size) for _ in range(4))
    figure = Figure(start, draw.integer(1, size), tuple(points), (), (draw.integer(1, size),))
    return _kept(draw, posed(draw, figure, poses=("any",), divisor=draw.integer(1, size)))


def whole(draw: Draw) -> Figure:
    """Whole numbers up to the bounds, in ints."""
    return as_ints(_whole(draw))


def _level(draw: Draw, kind: str, size: int, ratio: Sequence[int]) -> tuple[int, int, int, int]:
    """The reach r + s, and P's height, start and end as seen from Q."""
    reach = draw.integer(2, size)
    if kind in ("touching", "rest-touching"):
        reach, height, half = rational_chord(draw, max(5, size))
        start = half * draw.sign()
        end = start if kind == "rest-touching" else start + draw.integer(1, 2 * size) * draw.sign()
        return reach, height, start, end
    if kind in ("graze", "graze-late", "graze-behind"):
        start, end = -draw.integer(1, 2 * size), draw.integer(0, 2 * size)
        if kind == "graze-late":
            start, end = start - end - 1, start
        elif kind == "graze-behind":
            start, end = end + 1, end - start + 1
        return reach, reach * draw.sign(), start, end
    height = draw.integer(1 - reach, reach - 1)
    inner = isqrt(reach * reach - height * height - 1)  # the last place inside
    outer = isqrt(reach * reach - height * height) + 1  # the first one outside
    far = draw.integer(0, 2 * size)
    lengths = {
        "hit": lambda: (-outer - far, draw.integer(-inner, 2 * size)),
        "rush": lambda: (-outer - far, 2 * (outer + far)),
        "fast": lambda: (-reach * draw.integer(*ratio), reach * draw.integer(*ratio)),
        "short": lambda: (-outer - far - 1 - draw.integer(0, size), -outer - far),
        "away": lambda: (outer + far, outer + far + draw.integer(1, 2 * size)),
        "overlap": lambda: (draw.integer(-inner, inner), draw.integer(-2 * size, 2 * size)),
        "pass": lambda: (-draw.integer(1, 2 * size), draw.integer(1, 2 * size)),
        "rest-apart": lambda: (outer + far, outer + far),
        "rest-overlap": lambda: (inner, inner),
    }
    require(kind in lengths, f"{kind!r} is a way for discs to meet")
    if kind == "pass":
        height = (reach + draw.integer(1, size)) * draw.sign()
    start, end = lengths[kind]()
    return reach, height, start, end


def _edge_level(draw: Draw, kind: str, size: int, span: Sequence[int]) -> tuple[int, int, int, int]:
    """The same for an edge; the reach is found later."""
    height = draw.integer(max(1, size // 20), size)
    if kind == "graze":
        start, end = (
            draw.integer(times * size // 2, times * size)
            if times > _LONG
            else draw.integer(1, times * size or max(1, height // 4))
            for times in span
        )
        return height, height * draw.sign(), -start, end
    # An end next to the other disc, the way there not too oblique.
    place = -draw.integer(max(1, height // (_OBLIQUE - 1)), 2 * size)
    height *= draw.choice((0, 1, -1))
    if kind == "rest":
        return 1, height, place, place
    if kind == "start":
        return 1, height, place, place + draw.integer(1, 2 * size) * draw.sign()
    require(kind == "end", f"{kind!r} is an edge of two moving discs")
    return 1, height, place - draw.integer(1, 2 * size), place


def _drift(draw: Draw, kind: str, size: int, way: int) -> tuple[int, int]:
    """How Q moves: anyhow, not at all, alone, against P, or along with it, several or many times as far."""
    if kind == "still":
        return (0, 0)
    if kind == "alone":  # P rests
        return -way, 0
    if kind == "against":
        return -2 * way // 3, draw.integer(-1, 1)
    if kind in ("along", "far"):
        times = draw.integer(2, 9) if kind == "along" else draw.integer(*_SLOW)
        return draw.sign() * max(1, abs(way)) * times, draw.integer(-1, 1)
    require(kind == "any", f"{kind!r} is a way for a disc to drift")
    return draw_point(draw, size)


def _radii(draw: Draw, kind: str, reach: int) -> tuple[int, int]:
    """Both radii of a reach, in either order."""
    one = draw.integer(1, reach - 1) if reach > 1 else 0
    if kind == "one":
        one = 0
    elif kind == "tiny":
        one = min(reach, 1 + reach // 100)
    else:
        require(kind == "both", f"{kind!r} is a kind of two radii")
    return (one, reach - one) if draw.boolean() else (reach - one, one)


def _off(draw: Draw, figure: Figure, edge: Edge, kind: str) -> Figure:
    """The figure with radii whose sum is off by a share of the extent."""
    seen = balls_of(replace(figure, radius=0, lengths=(0,)))
    line = seen.line
    share, wider = edge.share(draw), draw.sign()
    if kind == "graze":
        touch = isqrt((line.k * line.k << 2 * _BITS) // line.a)
    elif kind in ("start", "rest"):
        touch = isqrt(seen.apart << 2 * _BITS)
    else:
        return _ending(draw, figure, seen, edge, share * wider)
    gap = wider * max(line.extent << _BITS, touch) * share // edge.units
    changed = _reaching(draw, figure, touch + gap, line.shift)
    after = balls_of(changed).line
    square, bottom = (after.k * after.k, after.a) if kind == "graze" else (balls_of(changed).apart, 1)
    found = Fraction(square, bottom)
    scale = found.denominator  # |√square − r| in parts of the extent, all of it over one number
    fits = edge.window.has_share(
        found.numerator * scale, after.r * scale, after.extent * scale
    )  # √(n/m) is √(n·m)/m
    require(fits, "the discs are off by the share that was asked for")
    return changed


def _ending(draw: Draw, figure: Figure, seen: Balls, edge: Edge, share: int) -> Figure:
    """The figure with radii at which the discs touch a share of the extent before the end, or after it."""
    line, pace = seen.line, seen.pace
    x, y = line.ax + line.dx - line.cx, line.ay + line.dy - line.cy
    extent = max(line.extent << _BITS, isqrt(x * x + y * y << 2 * _BITS))
    back = Fraction(share * extent, edge.units * pace.step << _BITS)  # of the motion, before the end
    x2, y2 = x - back * line.dx, y - back * line.dy
    square = x2 * x2 + y2 * y2
    touch = isqrt((square.numerator << 2 * _BITS) // square.denominator)
    changed = _reaching(draw, figure, touch, line.shift)
    after = balls_of(changed)
    first = after.first(BANDS)
    low, high = (Fraction(width.n, width.m) for width in (edge.window.low, edge.window.high))
    if first is None:
        draw.reject()
    fits = after.pace.close(first, 1, high) and not after.pace.close(first, 1, low, strictly=True)
    if not fits:
        draw.reject()  # the way is too oblique for a radius that is a double
    return changed


def _reaching(draw: Draw, figure: Figure, reach: int, shift: int) -> Figure:
    """The figure with two radii of that sum, but for rounding; the second has a few digits."""
    if reach <= 0:
        draw.reject()
    unit = 1 << (shift + _BITS)
    other = float(f"{reach / unit * draw.integer(50, 950) / 1000:.3g}")
    one = Fraction(reach, unit) - Fraction(other)
    return replace(figure, radius=one.numerator / one.denominator, lengths=(other,))


def _kept(draw: Draw, figure: Figure) -> Figure:
    """The figure, unless it breaks the promise."""
    if balls_of(figure).broken(BANDS, LEAST_RADIUS, LEAST_MOTION):
        draw.reject()
    return figure


def _whole(draw: Draw) -> Figure:
    """Whole numbers up to the bounds: a graze, nearly one, or anything."""
    kind = draw.choice(("any", "graze", "near"))
    if kind == "any":
        first, *others = (draw_point(draw, _REACH) for _ in range(4))
        radii = (draw.integer(1, _REACH), draw.integer(0, _REACH >> draw.integer(0, 9)))
        return typed(draw, _kept(draw, Figure(first, radii[0], tuple(others), (), radii[1:])), "any")
    size = _REACH // 64 >> draw.integer(0, 3)
    reach = draw.integer(size // 4, size)
    one = draw.integer(1, reach - 1)
    start, end = -draw.integer(reach, size * 2), draw.integer(reach, size * 2)
    drift = draw_point(draw, size)
    points = ((end + drift[0], reach + drift[1]), (0, 0), drift)
    figure = spun(Figure((start, reach), one, points, (), (reach - one,)), small_turn(draw))
    if kind == "near":
        gap = draw.sign() * whole_gap(draw, int(figure.extent))
        figure = replace(figure, lengths=(int(figure.lengths[0]) + gap,))
        if figure.lengths[0] < 0:
            draw.reject()
    figure = moved(draw_mirrored(draw, figure), *draw_point(draw, _REACH))
    return typed(draw, _kept(draw, figure), "any")


BALLS: Mapping[str, Recipe] = {
    "balls": balls,
    "grid": grid,
    "balls-edge": edge,
    "anywhere": anywhere,
    "whole": whole,
}
