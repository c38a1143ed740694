"""The normal form of a line, exactly; no case breaks any promise."""

from __future__ import annotations

from judge.topics.circles import NORMAL, CircleLine, builders, line_alone
from judge.topics.circles.recipes import bounds, chords, feet
from judge.values import Real

BUILDERS = builders(chords.RECIPES, feet.RECIPES, bounds.RECIPES, adapter=line_alone)
TOPIC = NORMAL


def solve(A, B):
    """The left normal (a, b), whose unit is 1, and the origin's signed distance c; None for A == B."""
    line = CircleLine.through(0, 0, 0, A, B)
    if line.degenerate:
        return None, None
    a, b = line.left_normal()
    return (Real(a, 1), Real(b, 1), Real(line.height(), line.extent_length())), None
