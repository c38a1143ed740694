"""The side of a directed line that a point is on: the sign of a cross product of whole numbers."""

from __future__ import annotations

from judge.topics.circles import Kind, builders, plane, points_only
from judge.topics.circles.plane import cross_product
from judge.topics.circles.recipes import steps

BUILDERS = builders(steps.RECIPES, adapter=points_only)
TOPIC = plane(Kind.SIDE)


def solve(A, B, P):
    """The sign of (B − A) × (P − A), above 0 on the left; A and B are not the same point."""
    if A == B:
        return None, "A and B are the same point, so there is no line"
    cross = cross_product(A, B, P)
    return (cross > 0) - (cross < 0), None
