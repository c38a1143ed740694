"""The topics of first steps: whole numbers in the plane, drawn as they are, without bands.

What a case holds is known by its parameters: (cx, cy, r) is a circle, the first two points are joined as the
kind of problem says.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from enum import Enum
from functools import partial
from math import hypot, sqrt
from typing import TYPE_CHECKING

from judge.problem import Case, Problem
from judge.problem.topic import Decision, Shown, Topic
from judge.topics.circles.images import mirror_images
from judge.topics.circles.simpler import simpler, special

if TYPE_CHECKING:
    from judge.drawing import Picture

IntPoint = tuple[int, int]
Found = Iterator[tuple[str, float]]


class Kind(Enum):
    """What a first step is about."""

    DISTANCE = "distance"  # of the points P and Q
    SIDE = "side"  # of the line from A to B that P is on
    CIRCLE = "circle"  # (cx, cy, r), and where P is
    DIAMETER = "diameter"  # AB of a circle, and where P is
    FOOT = "foot"  # of the perpendicular from P to a level or upright line AB
    CROSSING = "crossing"  # of the circle (cx, cy, r) and the line AB


def plane(kind: Kind) -> Topic:
    """What is known of first steps of a kind."""
    turns = kind in (Kind.SIDE, Kind.FOOT)  # their answers turn with the figure
    return Topic(
        images=None if turns else mirror_images,
        simpler=simpler,
        special=special,
        picture=partial(_picture, kind),
        decisions=partial(_decisions, kind),
    )


def _picture(kind: Kind, shown: Shown) -> Picture | None:
    from judge.topics.circles.picture.sketch import sketch  # late: most problems are loaded to be judged

    return sketch(kind, shown)


_FINEST = 1e-16  # of the figure: what whole numbers up to 1e9 are asked for
_SMALLEST = 1e-5  # of the figure: the same for numbers up to 20


def _decisions(kind: Kind, _problem: Problem) -> tuple[Decision, ...]:
    found: dict[Kind, tuple[tuple[str, str], Callable[[Case], Found], float]] = {
        Kind.SIDE: (("left", "right"), _beside_line, _FINEST),
        Kind.CIRCLE: (("inside", "outside"), _beside_circle, _FINEST),
        Kind.DIAMETER: (("inside", "outside"), _beside_diameter, _FINEST),
        Kind.CROSSING: (("hit", "miss"), _beside_tangent, _SMALLEST),
    }
    if kind not in found:
        return ()
    sides, measure, least = found[kind]
    return (Decision(kind.value, sides, measure, least=least),)


def cross_product(a: IntPoint, b: IntPoint, p: IntPoint) -> int:
    """That of B − A and P − A, above 0 where P is to the left of A→B."""
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def scalar_product(a: IntPoint, b: IntPoint, p: IntPoint) -> int:
    """That of A − P and B − P, below 0 where P is inside the circle with the diameter AB."""
    return (a[0] - p[0]) * (b[0] - p[0]) + (a[1] - p[1]) * (b[1] - p[1])


def _beside_line(case: Case) -> Found:
    """The distance of P from the line AB."""
    a, b, p = case
    cross = cross_product(a, b, p)
    length = hypot(b[0] - a[0], b[1] - a[1])
    yield ("left" if cross > 0 else "right"), abs(cross) / length / max(length, _apart(a, p))


def _beside_circle(case: Case) -> Found:
    """| |P − C| − r |."""
    cx, cy, r, p = case
    gap = (p[0] - cx) ** 2 + (p[1] - cy) ** 2 - r * r
    away = _apart((cx, cy), p)
    yield ("outside" if gap > 0 else "inside"), abs(gap) / (away + r) / max(away, r)


def _beside_diameter(case: Case) -> Found:
    """The same for the circle with the diameter AB: |P − M|² − r² is the scalar product."""
    a, b, p = case
    gap = scalar_product(a, b, p)
    radius = _apart(a, b) / 2
    away = sqrt(gap + radius * radius) if gap > -radius * radius else 0.0
    yield ("outside" if gap > 0 else "inside"), abs(gap) / (away + radius) / max(away, radius)


def _beside_tangent(case: Case) -> Found:
    """| d − r |, d being the distance of C from the line AB."""
    cx, cy, r, a, b = case
    cross = cross_product(a, b, (cx, cy))
    square = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2
    gap = cross * cross - r * r * square
    d = abs(cross) / sqrt(square)
    size = max(r, _apart((cx, cy), a), _apart((cx, cy), b))
    yield ("miss" if gap > 0 else "hit"), abs(gap) / square / (d + r) / size


def _apart(p: IntPoint, q: IntPoint) -> float:
    return hypot(q[0] - p[0], q[1] - p[1])
