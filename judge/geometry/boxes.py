"""Thousands of circles in whole numbers, and which of them a ray meets first.

A tree of boxes leads a ray to the circles that may be first. Doubles with a margin wider than the promise
sort out nearly all of them; what they leave is decided in integers. e is the largest of all r and all
|C − O|∞, as seen from the ray's origin O.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import inf, sqrt
from typing import Any

from judge.exact.signs import two_root_sign
from judge.geometry.crowd import apart
from judge.geometry.line import Line
from judge.geometry.sure import Sure
from judge.problem.declare import InvalidCase
from judge.values.answers import AnyOf, Exact

IntCircle = tuple[int, int, int]
IntPoint = tuple[int, int]

_MARGIN = 1.2e-7  # of e: wider than the promise, and far wider than what doubles lose
_LEAF = 6  # circles

Box = tuple[Any, ...]  # least and largest x, least and largest y, then indices or None, and two boxes


class Boxes:
    """Circles (x, y, r) in ints with r >= 1; at least one. Coordinates and D up to 2**21."""

    def __init__(self, circles: Sequence[IntCircle]) -> None:
        self.circles = circles
        xs, ys, rs = zip(*circles, strict=True)
        self._ends: tuple[int, ...] = min(xs), max(xs), min(ys), max(ys), max(rs)
        self._root = self._box(sorted(range(len(circles)), key=lambda at: circles[at]))

    def size(self, O: IntPoint) -> int:
        """e, as seen from there."""
        x0, x1, y0, y1, r = self._ends
        return max(r, O[0] - x0, x1 - O[0], O[1] - y0, y1 - O[1])

    def sight(self, O: IntPoint, D: IntPoint) -> tuple[tuple[int, ...], int]:
        """What doubles say of a ray: the circles that may be first, by index, and the root of the only one.

        It is -1 or 1 where that circle is met clearly, and 0 where integers must decide.
        """
        (ox, oy), (dx, dy) = O, D
        margin, length = _MARGIN * self.size(O), sqrt(dx * dx + dy * dy)
        ux, uy = dx / length or 1e-300, dy / length or 1e-300
        found, best = [], inf  # nothing beyond the best can be first
        stack = [self._root]
        while stack:
            x0, x1, y0, y1, leaf, one, other = stack.pop()
            a, b = (x0 - margin - ox) / ux, (x1 + margin - ox) / ux
            c, d = (y0 - margin - oy) / uy, (y1 + margin - oy) / uy
            start = max(min(a, b), min(c, d))
            if start > best or min(max(a, b), max(c, d)) < max(start, -margin):
                continue
            if leaf is None:
                # The box that lies ahead in the longer direction last: it is asked first.
                first = (
                    (dx > 0) == (one[0] < other[0]) if abs(dx) > abs(dy) else (dy > 0) == (one[2] < other[2])
                )
                stack += (other, one) if first else (one, other)
                continue
            for index in leaf:
                met = self._met(index, O, D, length, margin)
                if met is not None:
                    found.append((met[0], index, met[1]))
                    if met[1]:
                        best = min(best, met[0] + margin)
        near = [each for each in found if each[0] <= best]
        return tuple(sorted(index for _, index, _ in near)), near[0][2] if len(near) == 1 else 0

    def clear(self, O: IntPoint, D: IntPoint) -> bool:
        """Whether the answer is beyond doubt, and far from where it turns."""
        near, which = self.sight(O, D)
        return not near or which != 0

    def first(self, O: IntPoint, D: IntPoint) -> Exact:
        """(index, t) of the circle met first at t >= 0, any of those that tie, or None; its unit is e/|D|∞.

        Raises InvalidCase where that is close, up to the first hit.
        """
        near, which = self.sight(O, D)
        if not near:
            return None
        sure = Sure(self.size(O))
        lines = []
        for index in near:
            line = Line.ray(*self.circles[index], O, D)
            line.sure = sure
            lines.append((index, line))
        if which:
            index, line = lines[0]
            return index, line.time(which)
        return _first(lines)

    def _met(
        self, index: int, O: IntPoint, D: IntPoint, length: float, margin: float
    ) -> tuple[float, int] | None:
        """How far along the ray a circle may be met, and at which root if that is clear; None for never."""
        x, y, r = self.circles[index]
        fx, fy = x - O[0], y - O[1]
        gap = abs(D[0] * fy - D[1] * fx) / length - r
        if gap > margin:
            return None
        middle = (D[0] * fx + D[1] * fy) / length
        if gap < -margin:
            half = sqrt(-gap * (gap + r + r))
            # Whether O is inside is told across the circle, as the promise does.
            beside = sqrt(fx * fx + fy * fy) - r
            if beside > margin:
                return (middle - half, -1) if middle > 0 else None
            return (middle + half, 1) if beside < -margin else (0.0, 0)
        half = sqrt(max(0.0, (r + margin) ** 2 - (gap + r) ** 2))
        return None if middle + half < -margin else (max(0.0, middle - half), 0)

    def _box(self, indices: list[int]) -> Box:
        circles = self.circles
        x0 = min([circles[at][0] - circles[at][2] for at in indices])
        x1 = max([circles[at][0] + circles[at][2] for at in indices])
        y0 = min([circles[at][1] - circles[at][2] for at in indices])
        y1 = max([circles[at][1] + circles[at][2] for at in indices])
        if len(indices) <= _LEAF:
            return x0, x1, y0, y1, indices, None, None
        axis, half = (0 if x1 - x0 >= y1 - y0 else 1), len(indices) // 2
        indices.sort(key=lambda at: circles[at][axis])
        return x0, x1, y0, y1, None, self._box(indices[:half]), self._box(indices[half:])


def _first(lines: Sequence[tuple[int, Line]]) -> Exact:
    """The same among these few, in integers."""
    hits = [(index, line, line.first()) for index, line in lines]
    met = [(index, line, which) for index, line, which in hits if which is not None]
    if not met:
        return None
    best = met[0]
    for each in met[1:]:
        p, q = best[1], each[1]
        if two_root_sign(p.b - q.b, each[2], q.delta, -best[2], p.delta) < 0:
            best = each
    ties = [each for each in met if each is best or not apart(*best[1:], *each[1:])]
    answers = [(index, line.time(which)) for index, line, which in ties]
    return answers[0] if len(answers) == 1 else AnyOf(answers)


def nearest(
    circles: Sequence[IntCircle], rays: Sequence[tuple[IntPoint, IntPoint]], fastest: int
) -> list[Exact]:
    """`Boxes.first` of each ray. Raises InvalidCase, also for r < 1 and a D that is (0, 0) or too long."""
    for at, circle in enumerate(circles):
        if circle[2] < 1:
            raise InvalidCase(f"Circle {at} has r = {circle[2]}. Each r must be at least 1.")
    boxes, found = Boxes(circles), []
    for at, (O, D) in enumerate(rays):
        if not any(D) or max(map(abs, D)) > fastest:
            raise InvalidCase(f"Ray {at} has D = {D}. It must not be (0, 0), nor beyond {fastest}.")
        try:
            found.append(boxes.first(O, D))
        except InvalidCase as broken:
            raise InvalidCase(f"Ray {at}: {broken}") from None
    return found


def scan(circles: Sequence[IntCircle], O: IntPoint, dirs: Sequence[IntPoint], fastest: int) -> list[Exact]:
    """`nearest` for rays from one place outside all discs, in the order of their angles from −π to π."""
    for at, (x, y, r) in enumerate(circles):
        if (x - O[0]) ** 2 + (y - O[1]) ** 2 <= r * r:
            raise InvalidCase(f"O is in circle {at}, or on it. It must be outside every disc.")
    for at, (one, other) in enumerate(pairwise(dirs)):
        if _turn(one) > _turn(other) or (
            _turn(one) == _turn(other) and one[0] * other[1] - one[1] * other[0] < 0
        ):
            raise InvalidCase(f"Direction {at} comes before one of a lesser angle. They must be sorted.")
    return nearest(circles, [(O, D) for D in dirs], fastest)


def _turn(D: IntPoint) -> int:
    """0 for angles below 0, 1 for those from 0 up to π, 2 for π itself."""
    return 0 if D[1] < 0 else 2 if D[1] == 0 and D[0] < 0 else 1
