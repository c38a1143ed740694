"""A circle that moves from frame to frame beside a line, shown as a hit or a miss by two thresholds."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from judge.exact.surd import integers
from judge.geometry.quadratic import Number, Point
from judge.geometry.sure import DecisionWords, Sure
from judge.problem.declare import InvalidCase

FIRST = DecisionWords(
    "In the first frame the line is almost a tangent",
    "d must differ from r by at least 1e-7·e there.",
    ("d is below r", "d is r exactly", "d is above r"),
)
THRESHOLD = DecisionWords(
    "The distance almost equals a threshold",
    "It must equal it exactly, or differ from it by at least 1e-7·e.",
    ("d is below a threshold", "d is a threshold exactly", "d is above a threshold"),
)


def steady(circles: Sequence[tuple[Number, Number, Number]], O: Point, D: Point, h: Number) -> list[int]:
    """1 or 0 for each frame: d < r in the first; then 1 below r(1 − h), 0 above r(1 + h), else as before.

    d is the distance of a frame's circle from the line O + t·D; e = max(r, |O − C|∞), for each frame. Raises
    InvalidCase where D is (0, 0), where d equals r in the first frame, and where a threshold is nearly met;
    ValueError for nan, infinities and a radius below 0.
    """
    numbers, _ = integers(*O, *D, *(value for circle in circles for value in circle))
    ox, oy, dx, dy = numbers[:4]
    a = dx * dx + dy * dy
    if not a:
        raise InvalidCase("D is (0, 0). There must be a line.")
    share = Fraction(h)
    n, m = share.numerator, share.denominator
    shown: list[int] = []
    for x, y, r in zip(*(numbers[at::3] for at in (4, 5, 6)), strict=True):
        if r < 0:
            raise ValueError("a radius is negative")
        k, size = dx * (oy - y) - dy * (ox - x), max(r, abs(ox - x), abs(oy - y))
        if not shown:
            shown.append(int(Sure(size).distance(k * k, r, a, zero=False, what=FIRST) < 0))
            continue
        sure, square = Sure(size * m), k * k * m * m  # lengths are m times as long
        low = sure.distance(square, r * (m - n), a, what=THRESHOLD)
        high = sure.distance(square, r * (m + n), a, what=THRESHOLD)
        shown.append(int(high <= 0) if shown[-1] else int(low < 0))
    return shown
