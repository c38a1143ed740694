"""The circle and the line in a panel."""

from __future__ import annotations

from fractions import Fraction
from math import cos, pi, sin, sqrt
from typing import Protocol

from judge.drawing.clip import polygon, polyline
from judge.drawing.frame import ExactNumber, Frame, direction, near, over_root, rounded
from judge.drawing.shapes import Dot, Role, Stroke
from judge.exact import Surd
from judge.topics.circles.part import Part
from judge.topics.circles.picture.scene import Scene
from judge.topics.circles.picture.spots import Spot

_FLAT = 30.0  # a circle of more panels than this is drawn as the arc that can be seen
_SEEN = 1.5  # half the panel's diagonal, and a little more
_REACH = 4.0  # how far a line is followed


class Round(Protocol):
    """Whatever has a centre and a radius."""

    @property
    def cx(self) -> Fraction | int:
        """The centre's x."""
        ...

    @property
    def cy(self) -> Fraction | int:
        """The centre's y."""
        ...

    @property
    def r(self) -> int:
        """The radius."""
        ...


def circles(frame: Frame, scene: Scene) -> tuple[Stroke, ...]:
    """Every circle of the scene."""
    return tuple(stroke for each in scene.circles for stroke in circle(frame, each))


def circle(frame: Frame, line: Round) -> tuple[Stroke, ...]:
    """The disc, faintly filled, and its circle."""
    if not line.r:
        return ()
    size = near(Fraction(line.r) / frame.unit)
    dots = _whole_ring(frame, line, size) if size < _FLAT else _arc(frame, line)
    closed = (*dots, dots[0]) if size < _FLAT else dots
    area = polygon(dots if size < _FLAT else (*dots, *_within(frame, line, dots)))
    fill = (Stroke(area, Role.SHAPE, filled=True),) if area else ()
    return (*fill, *(Stroke(part, Role.SHAPE) for part in polyline(closed)))


def _whole_ring(frame: Frame, line: Round, size: float) -> tuple[Dot, ...]:
    x, y = frame.place(line.cx, line.cy)
    steps = 120 if size < 2 else 720
    turns = (2 * pi * step / steps for step in range(steps))
    return tuple((x + size * cos(turn), y + size * sin(turn)) for turn in turns)


def _arc(frame: Frame, line: Round) -> tuple[Dot, ...]:
    """A large circle as seen from here: h outside it, falling away by v²/(r + √(r² − v²)) at v beside."""
    fx, fy = frame.x - line.cx, frame.y - line.cy
    square = fx * fx + fy * fy
    top, bottom = square.numerator, square.denominator
    h = near(Surd(-line.r * bottom, 1, top * bottom, bottom) / frame.unit)
    bend = near(frame.unit / line.r)
    ux, uy = direction(fx, fy)
    dots = []
    for step in range(-24, 25):
        v = _SEEN * step / 24
        n = -h - bend * v * v / (1 + sqrt(1 - (bend * v) ** 2))
        dots.append((ux * n - uy * v, uy * n + ux * v))
    return tuple(dots)


def _within(frame: Frame, line: Round, dots: tuple[Dot, ...]) -> tuple[Dot, Dot]:
    """Two corners that close an arc on its inner side."""
    ux, uy = direction(frame.x - line.cx, frame.y - line.cy)
    depth = 2 * _REACH + max(abs(x) + abs(y) for x, y in dots)
    (x1, y1), (x2, y2) = dots[0], dots[-1]
    return (x2 - ux * depth, y2 - uy * depth), (x1 - ux * depth, y1 - uy * depth)


def straight(frame: Frame, scene: Scene) -> tuple[Stroke, ...]:
    """The line, segment or ray with its direction, and faintly the line that it is part of; further ways."""
    return (*_line(frame, scene), *_ways(frame, scene))


def _line(frame: Frame, scene: Scene) -> tuple[Stroke, ...]:
    line = scene.line
    if scene.part is Part.TANGENTS:
        return _tangents(frame, scene)
    if scene.part is Part.COMMON:
        return _across_radii(frame, scene)
    if not line.a:
        return ()
    fx, fy = line.ax - frame.x, line.ay - frame.y
    height = (line.dx * fy - line.dy * fx) / line.a
    offset = near(-height * line.dy / frame.unit), near(height * line.dx / frame.unit)
    u = direction(line.dx, line.dy)
    along = (line.dx * fx + line.dy * fy) / frame.unit
    start = over_root(along, line.a)
    end = over_root(along + line.a / frame.unit, line.a)
    return (*pieces(scene.part, offset, u, start, end), *_across(frame, scene))


def pieces(part: Part, offset: Dot, u: Dot, start: float, end: float) -> tuple[Stroke, ...]:
    """A line through `offset` along `u`, drawn between its ends as far as the part has any."""
    first = -_REACH if part.endless else max(-_REACH, min(_REACH, start))
    last = max(-_REACH, min(_REACH, end)) if part is Part.SEGMENT else _REACH
    strokes = [*_piece(offset, u, -_REACH, first), *_piece(offset, u, last, _REACH)]
    return (*strokes, *_piece(offset, u, first, last, Role.LINE))


def _piece(offset: Dot, u: Dot, first: float, last: float, role: Role = Role.BEYOND) -> list[Stroke]:
    if first >= last:
        return []
    dots = tuple((offset[0] + u[0] * at, offset[1] + u[1] * at) for at in (first, last))
    return [Stroke(part, role, arrow=role is Role.LINE) for part in polyline(dots)]


def _ways(frame: Frame, scene: Scene) -> tuple[Stroke, ...]:
    """The further ways of a scene, each to the left of itself as far as it says."""
    strokes = []
    for way in scene.ways:
        (x1, y1), (x2, y2) = frame.place(*way.start), frame.place(*way.end)
        u, v = direction(scene.line.dx, scene.line.dy)
        x, y = -v * way.beside, u * way.beside
        ends = (x1 + x, y1 + y), (x2 + x, y2 + y)
        strokes += [Stroke(part, Role(way.role)) for part in polyline(ends)]
    return tuple(strokes)


def _tangents(frame: Frame, scene: Scene) -> tuple[Stroke, ...]:
    """Lines from P to the points where tangents touch, and faintly to those of the submission."""
    start = frame.place(*scene.start)
    lines = [(spot, Role.LINE) for spot in scene.wanted] + [(spot, Role.BEYOND) for spot in scene.given]
    return tuple(
        Stroke(part, role) for spot, role in lines for part in polyline((start, frame.place(spot.x, spot.y)))
    )


def _across_radii(frame: Frame, scene: Scene) -> tuple[Stroke, ...]:
    """Tangents of circle 1 at the points wanted, and faintly lines like them at those given."""
    lines = [(spot, Role.LINE) for spot in scene.wanted] + [(spot, Role.BEYOND) for spot in scene.given]
    strokes = []
    for spot, role in lines:
        x, y = frame.place(spot.x, spot.y)
        u, v = direction(rounded(spot.x - scene.line.cx), rounded(spot.y - scene.line.cy))
        ends = (x + _REACH * v, y - _REACH * u), (x - _REACH * v, y + _REACH * u)
        strokes += [Stroke(part, role) for part in polyline(ends)]
    return tuple(strokes)


def _across(frame: Frame, scene: Scene) -> list[Stroke]:
    """What runs across the line: the perpendicular to a point beside it, or normals as arrows."""
    foot = frame.place(*scene.foot)
    if scene.part is Part.FOOT:
        ends = (frame.place(scene.line.cx, scene.line.cy), foot)
        return [Stroke(part, Role.BEYOND) for part in polyline(ends)]
    if scene.part is not Part.NORMAL:
        return _arrows(frame, scene)
    tips = [frame.place(spot.x, spot.y) for spot in (*scene.wanted, *scene.given)]
    return [Stroke(part, Role.LINE, arrow=True) for tip in tips for part in polyline((foot, tip))]


def _arrows(frame: Frame, scene: Scene) -> list[Stroke]:
    """The answers' vectors, each at its place."""
    return [
        Stroke(part, arrow.role, arrow=True)
        for arrow in scene.arrows
        for part in polyline((frame.place(*_at(arrow.start)), frame.place(*_at(arrow.tip))))
    ]


def _at(spot: Spot) -> tuple[ExactNumber, ExactNumber]:
    return spot.x, spot.y
