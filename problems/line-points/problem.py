"""The points of a circle on an infinite line: exactly, in order, with the band of problem.toml."""

from __future__ import annotations

from judge.topics.circles import LINE, Bands, CircleLine, builders
from judge.topics.circles.recipes import chords, edges, endpoints, whole
from judge.values import vector

BUILDERS = builders(endpoints.RECIPES, edges.LINES, whole.LINES, chords.RECIPES)
TOPIC = LINE


def solve(cx, cy, r, A, B, *, bands):
    """The common points in order of t, None for A == B; a line may not be nearly within the band."""
    line, widths = CircleLine.through(cx, cy, r, A, B), Bands.of(bands)
    if line.degenerate:
        return None, None
    points = [vector(line.point(which), line.extent_length()) for which in widths.meets(line)]
    return points, widths.broken_count(line)
