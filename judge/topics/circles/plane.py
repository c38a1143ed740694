"""The topics of first steps: whole numbers in the plane, drawn as they are, without bands.

What a case holds is known by its parameters: (cx, cy, r) is a circle, the first two points are joined as the
kind of problem says.
"""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum
from functools import partial
from math import hypot
from typing import TYPE_CHECKING

from judge.problem.topic import Shown, Topic
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
    return Topic(
        simpler=simpler,
        special=special,
        picture=partial(_picture, kind),
    )


def _picture(kind: Kind, shown: Shown) -> Picture | None:
    from judge.topics.circles.picture.sketch import sketch  # late: most problems are loaded to be judged

    return sketch(kind, shown)


def cross_product(a: IntPoint, b: IntPoint, p: IntPoint) -> int:
    """That of B − A and P − A, above 0 where P is to the left of A→B."""
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def scalar_product(a: IntPoint, b: IntPoint, p: IntPoint) -> int:
    """That of A − P and B − P, below 0 where P is inside the circle with the diameter AB."""
    return (a[0] - p[0]) * (b[0] - p[0]) + (a[1] - p[1]) * (b[1] - p[1])


def _apart(p: IntPoint, q: IntPoint) -> float:
    return hypot(q[0] - p[0], q[1] - p[1])
