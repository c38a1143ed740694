"""Cutting what is drawn to the panel's square."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from judge.drawing.shapes import Dot


def inside(dot: Dot) -> bool:
    """Whether a dot lies in the panel."""
    return abs(dot[0]) <= 1 and abs(dot[1]) <= 1


def polyline(dots: Sequence[Dot]) -> list[tuple[Dot, ...]]:
    """The parts of a polyline that lie in the panel."""
    parts: list[list[Dot]] = []
    for first, last in pairwise(dots):
        kept = _piece(first, last)
        if kept is None:
            continue
        if parts and parts[-1][-1] == kept[0]:
            parts[-1].append(kept[1])
        else:
            parts.append(list(kept))
    return [tuple(part) for part in parts]


def _piece(first: Dot, last: Dot) -> tuple[Dot, Dot] | None:
    """Liang and Barsky's clipping: the range of s in first + s·(last − first) between all four sides."""
    enter, leave = 0.0, 1.0
    steps = last[0] - first[0], last[1] - first[1]
    for at, step in zip(first, steps, strict=True):
        if step == 0:
            if abs(at) > 1:
                return None
            continue
        low, high = sorted(((-1 - at) / step, (1 - at) / step))
        enter, leave = max(enter, low), min(leave, high)
    if enter >= leave:
        return None
    # An end that is not cut stays as it is, so that the next piece begins where this one ends.
    return (
        first if enter == 0 else _at(first, steps, enter),
        last if leave == 1 else _at(first, steps, leave),
    )


def _at(first: Dot, steps: Dot, share: float) -> Dot:
    x, y = first[0] + steps[0] * share, first[1] + steps[1] * share
    return max(-1.0, min(1.0, x)), max(-1.0, min(1.0, y))


def polygon(dots: Sequence[Dot]) -> tuple[Dot, ...]:
    """The part of a polygon in the panel, by Sutherland and Hodgman's clipping at each side in turn."""
    kept = list(dots)
    for axis in (0, 1):
        for side in (1.0, -1.0):
            kept = _half(kept, axis, side)
    return tuple(kept)


def _half(dots: list[Dot], axis: int, side: float) -> list[Dot]:
    kept: list[Dot] = []
    for first, last in zip([*dots[-1:], *dots[:-1]], dots, strict=True):
        a, b = side * first[axis] - 1, side * last[axis] - 1
        if (a <= 0) != (b <= 0):
            share = a / (a - b)
            x = first[0] + (last[0] - first[0]) * share
            y = first[1] + (last[1] - first[1]) * share
            kept.append((side, y) if axis == 0 else (x, side))
        if b <= 0:
            kept.append(last)
    return kept
