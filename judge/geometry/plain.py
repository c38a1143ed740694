"""What plain programs in doubles find, with a tolerance or without: for scenes that keep the draws that tell.

A scene asks both, `telling(scene, first_hit, partial(first_hit, tolerance=1e-10))`, and keeps a case where
they differ. Nothing here decides an answer.
"""

from __future__ import annotations

from math import hypot, sqrt

from judge.geometry.quadratic import Number

Point = tuple[Number, Number]

MISS, AT_ORIGIN, AHEAD = "miss", "at the origin", "ahead"
_NEAR = 1e-9  # of the size: what counts as at the origin, after the program has decided


def first_hit(
    cx: Number,
    cy: Number,
    r: Number,
    O: Point,
    D: Point,
    *,
    tolerance: float = 0.0,
) -> str:
    """Where a plain program sees a ray meet a circle first: MISS, AT_ORIGIN or AHEAD.

    It compares the line's distance with r, and a point's way along the ray with 0, both with a tolerance that
    is a part of e = max(r, |O − C|∞).
    """
    fx, fy, (dx, dy) = O[0] - cx, O[1] - cy, D
    length, size = hypot(dx, dy), max(r, abs(fx), abs(fy))
    if length == 0:
        return MISS
    edge, foot, across = tolerance * size, -(fx * dx + fy * dy) / length, abs(dx * fy - dy * fx) / length
    if across - r > edge:
        return MISS
    half = sqrt(max(0.0, (r - across) * (r + across))) if r - across > edge else 0.0
    for way in (foot - half, foot + half):
        if way >= -edge:
            return AT_ORIGIN if way <= _NEAR * size else AHEAD
    return MISS
