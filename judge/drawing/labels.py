"""Placing labels within the panel, off each other and the marks and, if possible, the lines."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from math import cos, inf, pi, sin
from typing import NamedTuple

HEIGHT = 19.0
_LETTER = 7.6  # of a 13 px sans-serif, on the wide side: a fallback font must not make labels collide
_RADII = (13.0, 20.0, 30.0, 44.0, 62.0, 84.0)
_LEADER = 25.0  # a label that is further from its mark than this is joined to it by a line
_TURNS = 16
_CROSSING = 4.0  # what covering a dot of a line costs, in pixels of distance
_COVERING = 400.0  # and a label or a mark


class Rectangle(NamedTuple):
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


class Label(NamedTuple):
    """A text in its place; `leader` says that a line must join it to its mark."""

    box: Rectangle
    text: str
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
    """A label for each (x, y, text), in pixels of a square panel, off the boxes `taken` and dots `ink`.

    Of the places of a label it is the first that costs least.
    """
    placed: list[Label] = []
    boxes, rows = list(taken), sorted((y, x) for x, y in ink)
    for x, y, text in wanted:
        least, best, far = inf, Rectangle(x, y, 0, 0), False
        for radius, box in _candidates(x, y, width(text) / 2, size):
            cost = radius + _COVERING * sum(box.meets(other) for other in boxes)
            if cost < least:  # of thousands of dots a label is near a few, and only then do they matter
                first = bisect_left(rows, (box.y - box.h - 1, -inf))  # a pixel more: `holds` decides
                last = bisect_right(rows, (box.y + box.h + 1, inf))
                cost += _CROSSING * sum(box.holds(x, y) for y, x in rows[first:last])
            if cost < least:
                least, best, far = cost, box, radius > _LEADER
        placed.append(Label(best, text, far))
        boxes.append(best)
    return placed


def _candidates(x: float, y: float, w: float, size: float) -> Iterator[tuple[float, Rectangle]]:
    """The places of a label of the half width `w`, each with its distance from the mark, inside the panel.

    A label that is too wide for its place moves rather than being cut off.
    """
    h = HEIGHT / 2
    for radius in _RADII:
        for turn in range(_TURNS):
            angle = 2 * pi * (turn + 1) / _TURNS
            bx = x + cos(angle) * (radius + w * abs(cos(angle)) ** 0.5)
            by = y - sin(angle) * (radius + h)
            bx, by = min(max(bx, w + 2), size - w - 2), min(max(by, h + 2), size - h - 2)
            yield radius, Rectangle(bx, by, w, h)
