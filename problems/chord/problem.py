"""The length of the chord that a circle cuts from an infinite line, with the band of problem.toml."""

from __future__ import annotations

from judge.topics.circles import CHORD, Bands, CircleLine, builders
from judge.topics.circles.recipes import bounds, chords, edges, endpoints, whole
from judge.values import Real

BUILDERS = builders(endpoints.RECIPES, edges.LINES, whole.LINES, chords.RECIPES, bounds.RECIPES)
TOPIC = CHORD


def solve(cx, cy, r, A, B, *, bands):
    """2√Δ/|D|, 0 for a touch, None for a miss or no line; a line may not be nearly within the band."""
    line, widths = CircleLine.through(cx, cy, r, A, B), Bands.of(bands)
    count = widths.count(line)
    answer = Real(line.chord() if count == 2 else 0, line.extent_length()) if count else None
    return answer, widths.broken_count(line)
