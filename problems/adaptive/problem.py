"""The sign of Δ = r²·a − k² for doubles just as they are: no band, no tolerance, no promise."""

from __future__ import annotations

from judge.topics.circles import builders
from judge.topics.circles.recipes import counting, exact_signs, roundings
from judge.topics.circles.seven import SEVEN, discriminant, seven

BUILDERS = builders({"grid": counting.RECIPES["grid"]}, exact_signs.RECIPES, roundings.RECIPES, adapter=seven)
TOPIC = SEVEN


def solve(cx, cy, r, ax, ay, bx, by):
    """In integers over one power of two; 0 for A == B."""
    delta = discriminant(cx, cy, r, ax, ay, bx, by).delta
    return (delta > 0) - (delta < 0), None
