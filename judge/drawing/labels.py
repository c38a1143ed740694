"""Placing labels within the panel, off each other and the marks and, if possible, the lines."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, inf, pi, sin

HEIGHT = 19.0
_LETTER = 7.6  # of a 13 px sans-serif, on the wide side: a fallback font must not make labels collide
_RADII = (13.0, 20.0, 30.0, 44.0, 62.0, 84.0)
_TURNS = 16
_CROSSING = 4.0  # what covering a dot of a line costs, in pixels of distance
_COVERING = 400.0  # and a label or a mark


@dataclass(frozen=True, slots=True)
class Rectangle:
    """A rectangle by its middle and half its sides."""

    x: float
    y: float
    w: float
    h: float

    def meets(self, other: Rectangle) -> bool:
        """Whether the two overlap."""
        return abs(self.x - other.x) < self.w + other.w and abs(self.y - other.y) < self.h + other.h

    def holds(self, x: float, y: float) -> bool:
        """Whether a point lies in it."""
        return abs(self.x - x) < self.w and abs(self.y - y) < self.h


@dataclass(frozen=True, slots=True)
class Label:
    """A text in its place; `leader` says that it stands so far from its mark that a line must join them."""

    box: Rectangle
    text: str
    x: float
    y: float
    leader: bool


def width(text: str) -> float:
    """How wide a label is at most, in pixels."""
    return _LETTER * len(text) + 4


def place_labels(
    wanted: Sequence[tuple[float, float, str]],
    size: float,
    taken: Sequence[Rectangle],
    ink: Sequence[tuple[float, float]],
) -> list[Label]:
    """A label for each (x, y, text), in pixels of a square panel, off the boxes `taken` and dots `ink`."""
    placed: list[Label] = []
    boxes, rows = list(taken), _Rows(ink)
    for x, y, text in wanted:
        radius, best = _cheapest(_candidates(x, y, text, size), boxes, rows)
        placed.append(Label(best, text, x, y, leader=radius > 25))
        boxes.append(best)
    return placed


def _candidates(x: float, y: float, text: str, size: float) -> list[tuple[float, Rectangle]]:
    w, h = width(text) / 2, HEIGHT / 2
    found = []
    for radius in _RADII:
        for turn in range(_TURNS):
            angle = 2 * pi * (turn + 1) / _TURNS
            bx = x + cos(angle) * (radius + w * abs(cos(angle)) ** 0.5)
            by = y - sin(angle) * (radius + h)
            # Kept inside: a label that is too wide for its place moves rather than being cut off.
            bx = min(max(bx, w + 2), size - w - 2)
            by = min(max(by, h + 2), size - h - 2)
            found.append((radius, Rectangle(bx, by, w, h)))
    return found


def _cheapest(
    candidates: Sequence[tuple[float, Rectangle]], boxes: Sequence[Rectangle], rows: _Rows
) -> tuple[float, Rectangle]:
    """The first of those that cost least; dots are counted only where they can still decide."""
    best, least = candidates[0], inf
    for candidate in candidates:
        radius, box = candidate
        cost = radius + _COVERING * sum(box.meets(other) for other in boxes)
        if cost < least:
            cost += _CROSSING * rows.within(box)
            if cost < least:
                best, least = candidate, cost
    return best


class _Rows:
    """The dots of lines, by their height: thousands of them, of which a label is near a few."""

    def __init__(self, dots: Sequence[tuple[float, float]]) -> None:
        self._dots = sorted((y, x) for x, y in dots)

    def within(self, box: Rectangle) -> int:
        """How many dots the box holds."""
        first = bisect_left(self._dots, (box.y - box.h - 1, -inf))  # a pixel more: `holds` decides
        last = bisect_right(self._dots, (box.y + box.h + 1, inf))
        return sum(box.holds(x, y) for y, x in self._dots[first:last])
