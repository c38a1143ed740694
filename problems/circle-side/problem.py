"""Whether a point is inside a circle, on it or outside: two squares of whole numbers compared."""

from __future__ import annotations

from judge.topics.circles import Kind, builders, plane
from judge.topics.circles.recipes import steps

BUILDERS = builders(steps.RECIPES)
TOPIC = plane(Kind.CIRCLE)


def solve(cx, cy, r, P):
    """The sign of |P − C|² − r²."""
    gap = (P[0] - cx) ** 2 + (P[1] - cy) ** 2 - r * r
    return (gap > 0) - (gap < 0), None
