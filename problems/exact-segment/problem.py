"""The common points of a circle and a closed segment in integers of any size, counted by signs alone."""

from __future__ import annotations

from judge.topics.circles import SEGMENT, CircleLine, builders
from judge.topics.circles.recipes import counting, exact_ends

BUILDERS = builders({"grid": counting.RECIPES["grid"]}, exact_ends.RECIPES)
TOPIC = SEGMENT


def solve(cx, cy, r, A, B):
    """By the signs of |A − C|² − r², |B − C|² − r² and Δ, and whether the foot, at −b/a, is from A to B."""
    line = CircleLine.through(cx, cy, r, A, B)
    inside_a = (line.ax - line.cx) ** 2 + (line.ay - line.cy) ** 2 - line.r**2
    inside_b = inside_a + 2 * line.b + line.a
    between = 0 <= -line.b <= line.a
    if line.a == 0:
        return int(inside_a == 0), None
    if line.delta <= 0:
        return int(line.delta == 0 and between), None
    if inside_a < 0 or inside_b < 0:  # a root lies on each side of what is inside
        return int(inside_a >= 0) + int(inside_b >= 0), None
    if between:  # the foot is inside, neither end is: both roots are on the segment
        return 2, None
    return int(inside_a == 0) + int(inside_b == 0), None
