"""A window on the plane: from decimals of any size to strokes in a panel.

Its axes may be turned, and it may be stretched: `along` and `across` are the lengths that half a panel shows
on each of them. All that is far or large is worked out in decimals, so that nothing cancels.
"""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from math import cos, pi, sin

from judge.drawing.clip import polygon, polyline
from judge.drawing.shapes import Dot, Role, Stroke
from judge.geometry.view import Place, Ring, Way, cross, dot, length, minus

FAR = Decimal(10**6)  # panels: whatever is further away is drawn as if it were there
_LARGE = 20  # a circle of more panels than this is drawn as the arc that can be seen
_STEPS = 48  # of that arc
_FOLLOWED = Decimal(3)  # panels: how far a line without an end is followed


@dataclass(frozen=True, slots=True)
class Frame:
    """A panel around `middle`, whose first axis runs along `axis`, a direction of any length."""

    middle: Place
    along: Decimal
    across: Decimal
    axis: Place = (Decimal(1), Decimal(0))

    def turned(self, way: Place) -> Place:
        """A vector, in panels."""
        size = length(self.axis)
        return dot(self.axis, way) / size / self.along, cross(self.axis, way) / size / self.across

    def place(self, at: Place) -> Dot:
        """A point in the panel."""
        x, y = self.turned(minus(at, self.middle))
        return _near(x), _near(y)

    def ring(self, ring: Ring) -> list[Stroke]:
        """A circle, and its disc faintly filled where it is one of the case."""
        x, y = self.turned(minus((ring.x, ring.y), self.middle))
        a, b = ring.r / self.along, ring.r / self.across
        if not ring.r:
            return []
        if max(a, b) < _LARGE:
            dots = _round(_near(x), _near(y), float(a), float(b))
            inner, closed = dots, [*dots, dots[0]]
        else:
            upright = abs(y) * a >= abs(x) * b  # whether what is seen is a function of x
            closed = _arc(x, y, a, b) if upright else [(u, v) for v, u in _arc(y, x, b, a)]
            if not closed:
                return []
            depth = 9.0 if (y if upright else x) > 0 else -9.0
            (u1, v1), (u2, v2) = closed[0], closed[-1]
            inner = [*closed, *([(u2, depth), (u1, depth)] if upright else [(depth, v2), (depth, v1)])]
        area = polygon(inner) if ring.role is Role.SHAPE else ()
        fill = [Stroke(area, Role.SHAPE, filled=True)] if area else []
        return [*fill, *(Stroke(part, ring.role) for part in polyline(closed))]

    def way(self, way: Way) -> list[Stroke]:
        """A line, ray, segment or vector, and faintly where it goes on beyond its ends."""
        start, along = self.turned(minus(way.start, self.middle)), self.turned(way.along)
        size = length(along)
        if not size:
            return []
        if way.beside:
            shift = Decimal(str(way.beside)) / size
            start = start[0] - along[1] * shift, start[1] + along[0] * shift
        middle = -dot(start, along) / (size * size)
        reach = _FOLLOWED / size
        first, last = middle - reach, middle + reach
        low = first if way.low is None else min(max(first, Decimal(way.low)), last)
        high = last if way.high is None else max(min(last, Decimal(way.high)), first)
        parts = [(low, high, way.role)]
        if way.beyond:
            parts = [(first, low, Role.BEYOND), (high, last, Role.BEYOND), *parts]
        strokes = []
        for t0, t1, role in parts:
            if t0 < t1:
                dots = [tuple(_near(p + t * d) for p, d in zip(start, along, strict=True)) for t in (t0, t1)]
                strokes += [Stroke(each, role, way.arrow and role is way.role) for each in polyline(dots)]  # type: ignore[arg-type]
        return strokes


def _near(value: Decimal) -> float:
    return float(max(-FAR, min(FAR, value)))


def _round(x: float, y: float, a: float, b: float) -> list[Dot]:
    steps = 48 if max(a, b) < 0.4 else 72 if max(a, b) < 2 else 360
    return [(x + a * cos(2 * pi * k / steps), y + b * sin(2 * pi * k / steps)) for k in range(steps)]


def _arc(x: Decimal, y: Decimal, a: Decimal, b: Decimal) -> list[Dot]:
    """The part of an ellipse about (x, y) on the panel's side of its centre, over u from −1.2 to 1.2."""
    dots = []
    for k in range(-_STEPS, _STEPS + 1):
        u = Decimal(k * 12) / (10 * _STEPS)
        over = 1 - ((u - x) / a) ** 2
        if over >= 0:
            rise = b * over.sqrt()
            dots.append((float(u), _near(y - rise if y > 0 else y + rise)))
    return dots
