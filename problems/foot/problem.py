"""The foot of the perpendicular on an infinite line, exactly; no case breaks any promise."""

from __future__ import annotations

from judge.topics.circles import FOOT, CircleLine, builders, line_and_point
from judge.topics.circles.recipes import bounds, feet
from judge.values import Real, vector

BUILDERS = builders(feet.RECIPES, bounds.RECIPES, adapter=line_and_point)
TOPIC = FOOT


def solve(A, B, C):
    """t = (C − A)·D / D·D and A + t·D, all of it rational; None for A == B. The unit is the extent."""
    line = CircleLine.through(*C, 0, A, B)
    if line.degenerate:
        return None, None
    return (Real(line.root(0), line.extent_step()), vector(line.point(0), line.extent_length())), None
