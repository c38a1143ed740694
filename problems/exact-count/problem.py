"""The common points of a circle and a line in integers of any size: no band, no tolerance, no promise."""

from __future__ import annotations

from judge.topics.circles import LINE, builders
from judge.topics.circles.recipes import counting

BUILDERS = builders(counting.RECIPES)
TOPIC = LINE


def solve(cx, cy, r, A, B):
    """The sign of r²a − k², for a = |B − A|² and the cross product k of B − A and A − C; None for A == B.

    This is the discriminant of the equation for the intersection, by Lagrange's identity.
    """
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == dy == 0:
        return None, None
    cross = dx * (A[1] - cy) - dy * (A[0] - cx)
    reach, distance = r * r * (dx * dx + dy * dy), cross * cross
    return 1 + (reach > distance) - (reach < distance), None
