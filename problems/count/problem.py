"""The common points of a circle and a line: the exact count, with the tangency band of problem.toml."""

from __future__ import annotations

from judge.topics.circles import LINE, Bands, CircleLine, builders
from judge.topics.circles.recipes import bounds, chords, counting, edges, whole

BUILDERS = builders(chords.RECIPES, counting.RECIPES, edges.LINES, whole.LINES, bounds.RECIPES)
TOPIC = LINE


def solve(cx, cy, r, A, B, *, bands):
    """0, 1 or 2 by exact signs, None for A == B; a line may not be nearly within the tangency band."""
    line, widths = CircleLine.through(cx, cy, r, A, B), Bands.of(bands)
    return widths.count(line), widths.broken_count(line)
