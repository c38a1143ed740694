"""Whether a point is inside the circle with a given diameter, on it or outside, in whole numbers."""

from __future__ import annotations

from judge.topics.circles import Kind, builders, plane, points_only
from judge.topics.circles.plane import scalar_product
from judge.topics.circles.recipes import steps

BUILDERS = builders(steps.RECIPES, adapter=points_only)
TOPIC = plane(Kind.DIAMETER)


def solve(A, B, P):
    """The sign of (A − P)·(B − P): by Thales' theorem it is 0 on the circle, and below 0 inside."""
    if A == B:
        return None, "A and B are the same point, so there is no diameter"
    gap = scalar_product(A, B, P)
    return (gap > 0) - (gap < 0), None
