"""From exact geometry to floats near 1: everything is relative to a panel's centre before it is rounded."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import cos, hypot, pi, sin, sqrt

from judge.drawing.clip import polygon, polyline
from judge.drawing.shapes import Dot, Role, Stroke
from judge.exact import Surd
from judge.topics.circles.line import CircleLine
from judge.topics.circles.picture.scene import Exact, Figure, Scene

FAR = 1e6  # whatever is further away than this, in panels, is drawn as if it were there
_FLAT = 30.0  # a circle of more panels than this is drawn as the arc that can be seen
_SEEN = 1.5  # half the panel's diagonal, and a little more
_REACH = 4.0  # how far a line is followed


def near(value: Exact) -> float:
    """The double next to `value`, at most `FAR` in magnitude."""
    try:
        double = float(value)
    except OverflowError:
        return FAR if value > 0 else -FAR
    return max(-FAR, min(FAR, double))


def over_root(value: Fraction, square: int) -> float:
    """value/√square."""
    size = sqrt(near(value * value / square))
    return size if value >= 0 else -size


def length(x: Exact, y: Exact) -> Fraction:
    """√(x² + y²) to three digits, as a fraction: for scales and for words."""
    return root(rounded(x) ** 2 + rounded(y) ** 2)


def root(square: Fraction) -> Fraction:
    """√square to three digits."""
    return rounded(Surd(0, 1, square.numerator * square.denominator, square.denominator))


def rounded(value: Exact) -> Fraction:
    """`value` to three digits."""
    return Fraction(Surd.of(value).decimal(3))


def direction(x: Fraction | int, y: Fraction | int) -> Dot:
    """(x, y) made one long; (1, 0) for no direction."""
    across, up = Fraction(x), Fraction(y)
    most = max(abs(across), abs(up))
    if not most:
        return 1.0, 0.0
    u, v = float(across / most), float(up / most)
    size = hypot(u, v)
    return u / size, v / size


@dataclass(frozen=True, slots=True)
class Frame:
    """A square window: its centre and half its side, in the scene's units."""

    x: Fraction
    y: Fraction
    unit: Fraction

    def place(self, x: Exact | int, y: Exact | int) -> Dot:
        """An exact point in the panel."""
        return near((x - self.x) / self.unit), near((y - self.y) / self.unit)

    def circle(self, line: CircleLine) -> tuple[Stroke, ...]:
        """The disc, faintly filled, and its circle."""
        if not line.r:
            return ()
        size = near(line.r / self.unit)
        dots = self._whole_ring(line, size) if size < _FLAT else self._arc(line)
        closed = (*dots, dots[0]) if size < _FLAT else dots
        area = polygon(dots if size < _FLAT else (*dots, *self._within(line, dots)))
        fill = (Stroke(area, Role.CIRCLE, filled=True),) if area else ()
        return (*fill, *(Stroke(part, Role.CIRCLE) for part in polyline(closed)))

    def _whole_ring(self, line: CircleLine, size: float) -> tuple[Dot, ...]:
        x, y = self.place(line.cx, line.cy)
        steps = 120 if size < 2 else 720
        turns = (2 * pi * step / steps for step in range(steps))
        return tuple((x + size * cos(turn), y + size * sin(turn)) for turn in turns)

    def _arc(self, line: CircleLine) -> tuple[Dot, ...]:
        """A large circle as seen from here: h outside it, falling away by v²/(r + √(r² − v²)) at v beside."""
        fx, fy = self.x - line.cx, self.y - line.cy
        square = fx * fx + fy * fy
        top, bottom = square.numerator, square.denominator
        h = near(Surd(-line.r * bottom, 1, top * bottom, bottom) / self.unit)
        bend = near(self.unit / line.r)
        ux, uy = direction(fx, fy)
        dots = []
        for step in range(-24, 25):
            v = _SEEN * step / 24
            n = -h - bend * v * v / (1 + sqrt(1 - (bend * v) ** 2))
            dots.append((ux * n - uy * v, uy * n + ux * v))
        return tuple(dots)

    def _within(self, line: CircleLine, dots: tuple[Dot, ...]) -> tuple[Dot, Dot]:
        """Two corners that close an arc on its inner side."""
        ux, uy = direction(self.x - line.cx, self.y - line.cy)
        depth = 2 * _REACH + max(abs(x) + abs(y) for x, y in dots)
        (x1, y1), (x2, y2) = dots[0], dots[-1]
        return (x2 - ux * depth, y2 - uy * depth), (x1 - ux * depth, y1 - uy * depth)

    def straight(self, scene: Scene) -> tuple[Stroke, ...]:
        """The line, segment or ray with its direction, and faintly the line that it is part of."""
        line = scene.line
        if not line.a:
            return ()
        fx, fy = line.ax - self.x, line.ay - self.y
        height = (line.dx * fy - line.dy * fx) / line.a
        offset = near(-height * line.dy / self.unit), near(height * line.dx / self.unit)
        u = direction(line.dx, line.dy)
        along = (line.dx * fx + line.dy * fy) / self.unit
        start = over_root(along, line.a)
        end = over_root(along + line.a / self.unit, line.a)
        return pieces(scene.figure, offset, u, start, end)


def pieces(figure: Figure, offset: Dot, u: Dot, start: float, end: float) -> tuple[Stroke, ...]:
    """A line through `offset` along `u`, drawn between its ends as far as the figure has any."""
    first = -_REACH if figure is Figure.LINE else max(-_REACH, min(_REACH, start))
    last = max(-_REACH, min(_REACH, end)) if figure is Figure.SEGMENT else _REACH
    strokes = [*_piece(offset, u, -_REACH, first), *_piece(offset, u, last, _REACH)]
    return (*strokes, *_piece(offset, u, first, last, Role.LINE))


def _piece(offset: Dot, u: Dot, first: float, last: float, role: Role = Role.BEYOND) -> list[Stroke]:
    if first >= last:
        return []
    dots = tuple((offset[0] + u[0] * at, offset[1] + u[1] * at) for at in (first, last))
    return [Stroke(part, role, arrow=role is Role.LINE) for part in polyline(dots)]
