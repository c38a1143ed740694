"""A radius that puts a figure at the very edge of what is decided, whatever the figure is.

The figure is finished: turned, scaled, rounded. Only then is the radius chosen, so that a tangency, an end or
a point is off by a share of the figure's own extent, and held against what was asked for, in integers. The
double of the radius is off by 2⁻⁵³ of it, and the extent is that of the figure without the share: together
they change the share by less than a thousandth, which the ranges leave room for.

    snap     0.9 to 1 times the band: just within
    clear    1.01 to 3 times the promise: just outside of it
    within   anything in the band, down to 2e-15
    beyond   anything outside of the promise, up to a tenth

All magnitudes of a range are equally likely.
"""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

from msgspec import Struct

from judge.data.draw import Draw, require
from judge.topics.circles.figures.figure import Figure, with_radius
from judge.topics.circles.line import CircleLine
from judge.topics.circles.outline import CircleOutline
from judge.topics.circles.window import Window

_BITS = 64  # of what is computed here below the unit of the figure
_MOST_OBLIQUE = 3  # a root is found where the radius is at most so many times its distance to the foot


class Edge(Struct, frozen=True):
    """A range of shares: `cuts` part it into steps of equal ratio, in units of 1 / `units`; `window` is what
    may come out.
    """

    cuts: tuple[int, ...]
    units: int
    window: Window

    def share(self, draw: Draw) -> int:
        """A share, all magnitudes of the range equally likely."""
        step = draw.integer(0, len(self.cuts) - 2)
        return draw.integer(self.cuts[step], self.cuts[step + 1])


def _edge(low: int, high: int, units: int, least: str, most: str) -> Edge:
    cuts = [low]
    while cuts[-1] * 9 < high * 8:
        cuts.append(-(-cuts[-1] * 9 // 8))
    return Edge((*cuts, high), units, Window.of(Fraction(least), Fraction(most)))


EDGES = {
    "snap": _edge(9_050, 9_950, 10**16, "0.9e-12", "1e-12"),
    "clear": _edge(1_015, 2_985, 10**10, "1.01e-7", "3e-7"),
    "within": _edge(20, 9_950, 10**16, "1e-15", "1e-12"),
    "beyond": _edge(1_015, 850_000_000, 10**10, "1.01e-7", "0.1"),
}


def tangent_off(draw: Draw, figure: Figure, edge: Edge, side: str) -> Figure:
    """The figure with a radius that its line touches but for a share: a "hit" or a "miss"."""
    line, spans = _seen(figure)
    if line.a == 0:
        draw.reject()
    distance = isqrt((line.k * line.k << 2 * _BITS) // line.a)
    gap = _share(draw, edge, max(distance, spans << _BITS))
    radius = distance + gap if side == "hit" else distance - gap
    if radius <= 0:
        draw.reject()
    changed, line = _with(figure, radius, line.shift)
    require(edge.window.has_tangent(line, side), f"the line is a {side} by the share that was asked for")
    return changed


def root_off(draw: Draw, figure: Figure, edge: Edge, t: int, sign: int) -> Figure:
    """The figure with a radius that puts a root beyond (sign 1) or before (−1) the point t = 0 or 1, by a
    share.
    """
    line, spans = _seen(figure)
    if line.a == 0:
        draw.reject()
    along = line.b + t * line.a  # (P − C)·D, P being the point
    x, y = line.ax + t * line.dx - line.cx, line.ay + t * line.dy - line.cy
    square = x * x + y * y
    if _MOST_OBLIQUE**2 * along * along < square * line.a:
        draw.reject()  # the root would move much farther than the radius changes
    gap = sign * _share(draw, edge, max(isqrt(square << 2 * _BITS), spans << _BITS))
    steep = (along << 2 * _BITS) // isqrt(line.a << 2 * _BITS)
    radius = isqrt((square << 2 * _BITS) + 2 * gap * steep + gap * gap)
    changed, line = _with(figure, radius, line.shift)
    require(edge.window.has_root(line, t, sign), "a root is off by the share that was asked for")
    return changed


def point_off(draw: Draw, figure: Figure, edge: Edge, side: str) -> Figure:
    """The figure with a radius that its first point is "inside" or "outside" of by a share."""
    line, spans = _seen(figure)
    square = (line.ax - line.cx) ** 2 + (line.ay - line.cy) ** 2
    away = isqrt(square << 2 * _BITS)
    gap = _share(draw, edge, max(away, spans << _BITS))
    radius = away + gap if side == "inside" else away - gap
    if radius <= 0:
        draw.reject()
    changed, line = _with(figure, radius, line.shift)
    require(edge.window.has_point(line, side), f"the point is {side} by the share that was asked for")
    return changed


def seen(figure: Figure) -> CircleLine:
    """The figure's circle and line, in integers; of more than two points their polygon's first edge."""
    (start, *rest) = figure.points
    if len(rest) > 1:
        return CircleOutline.of(*figure.centre, figure.radius, figure.points).edges[0]
    if rest:
        return CircleLine.through(*figure.centre, figure.radius, start, rest[0])
    return CircleLine.ray(*figure.centre, figure.radius, start, figure.vectors[0])


def _seen(figure: Figure) -> tuple[CircleLine, int]:
    """The line, and how far the figure reaches from its centre but for its radius, in the line's unit."""
    line = seen(with_radius(figure, 0))
    return line, line.extent


def _share(draw: Draw, edge: Edge, extent: int) -> int:
    return extent * edge.share(draw) // edge.units


def _with(figure: Figure, radius: int, shift: int) -> tuple[Figure, CircleLine]:
    changed = with_radius(figure, radius / (1 << (shift + _BITS)))
    return changed, seen(changed)


def whole_gap(draw: Draw, extent: int) -> int:
    """A whole number that is 1.01 to 3 times the promise of that extent; gives up where there is none."""
    edge = EDGES["clear"]
    low, high = -(-extent * edge.cuts[0] // edge.units), extent * edge.cuts[-1] // edge.units
    if low > high:
        draw.reject()
    return draw.integer(low, high)
