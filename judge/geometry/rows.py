"""How often each of many circles meets one line: doubles where they are sure, integers elsewhere."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

from judge.geometry.line import Line
from judge.problem.declare import InvalidCase

Point = tuple[float, float]

_SURE = 4e-7  # of a circle's size: far more than the promise and what doubles lose, which is 1e-14


def counts(cx: Sequence[float], cy: Sequence[float], r: Sequence[float], A: Point, B: Point) -> list[int]:
    """0, 1 or 2 common points of each circle (cx[i], cy[i]), r[i] and the line through A and B.

    e is each circle's own, as in `Line.through`. Raises InvalidCase where a line nearly touches, A is B, or
    the columns are of different lengths.
    """
    if not len(cx) == len(cy) == len(r):
        raise InvalidCase(
            f"cx, cy and r have {len(cx)}, {len(cy)} and {len(r)} numbers. They must have as many."
        )
    (ax, ay), (bx, by) = A, B
    dx, dy = bx - ax, by - ay
    length = hypot(dx, dy)
    if not length:
        raise InvalidCase("A and B are the same point. There must be a line.")
    found = []
    for place, (x, y, radius) in enumerate(zip(cx, cy, r, strict=True)):
        fx, fy = ax - x, ay - y
        gap = abs(dx * fy - dy * fx) / length - radius
        room = _SURE * max(radius, abs(fx), abs(fy), abs(bx - x), abs(by - y))
        if gap > room or -gap > room:
            found.append(0 if gap > 0 else 2)
            continue
        try:
            found.append(len(Line.through(x, y, radius, A, B).meets()))
        except InvalidCase as broken:
            raise InvalidCase(f"Circle {place}: {broken}") from None
    return found
