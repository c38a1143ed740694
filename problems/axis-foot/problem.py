"""The foot of the perpendicular on a level or upright line: one coordinate of the point, one of the line."""

from __future__ import annotations

from judge.topics.circles import Kind, builders, plane, points_only
from judge.topics.circles.recipes import steps

BUILDERS = builders(steps.RECIPES, adapter=points_only)
TOPIC = plane(Kind.FOOT)


def solve(A, B, P):
    """(x of P, y of the line) for a level line, (x of the line, y of P) for an upright one."""
    if A == B:
        return None, "A and B are the same point, so there is no line"
    if A[1] == B[1]:
        return (P[0], A[1]), None
    if A[0] == B[0]:
        return (A[0], P[1]), None
    return None, "the line is neither level nor upright"
