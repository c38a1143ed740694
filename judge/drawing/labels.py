"""Placing labels within the panel, off each other and the marks and, if possible, the lines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, pi, sin

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
    boxes = list(taken)
    for x, y, text in wanted:
        best = min(
            (candidate for candidate in _candidates(x, y, text, size)),
            key=lambda candidate: _cost(candidate, boxes, ink),
        )
        placed.append(Label(best[1], text, x, y, leader=best[0] > 25))
        boxes.append(best[1])
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


def _cost(
    candidate: tuple[float, Rectangle], boxes: Sequence[Rectangle], ink: Sequence[tuple[float, float]]
) -> float:
    radius, box = candidate
    covered = sum(box.meets(other) for other in boxes)
    crossed = sum(box.holds(*dot) for dot in ink)
    return radius + _COVERING * covered + _CROSSING * crossed
