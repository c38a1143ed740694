"""The distance of a point from an infinite line, exactly; no case breaks any promise."""

from __future__ import annotations

from judge.topics.circles import FOOT, CircleLine, builders, line_and_point
from judge.topics.circles.recipes import bounds, feet
from judge.values import Real

BUILDERS = builders(feet.RECIPES, bounds.RECIPES, adapter=line_and_point)
TOPIC = FOOT


def solve(A, B, P):
    """|D × f| / |D| for D = B − A and f = A − P; None for A == B. The unit is the extent."""
    line = CircleLine.through(*P, 0, A, B)
    return None if line.degenerate else Real(line.distance(), line.extent_length()), None
