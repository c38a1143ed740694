"""The distance of two points, squared: whole numbers of any sign, no root."""

from __future__ import annotations

from judge.topics.circles import Kind, builders, plane, points_only
from judge.topics.circles.recipes import steps

BUILDERS = builders(steps.RECIPES, adapter=points_only)
TOPIC = plane(Kind.DISTANCE)


def solve(P, Q):
    """|Q − P|² by Pythagoras."""
    return (Q[0] - P[0]) ** 2 + (Q[1] - P[1]) ** 2, None
