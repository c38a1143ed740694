"""How many points a circle and a line have in common, in small whole numbers: the sign of one difference."""

from __future__ import annotations

from judge.topics.circles import CircleLine, Kind, builders, plane
from judge.topics.circles.recipes import steps

BUILDERS = builders(steps.RECIPES)
TOPIC = plane(Kind.CROSSING)


def solve(cx, cy, r, A, B):
    """0, 1 or 2, by the sign of r²·|B − A|² − k² with the cross product k of B − A and A − C."""
    count = CircleLine.through(cx, cy, r, A, B).count()
    return count, "A and B are the same point, so there is no line" if count is None else None
