"""Inside, on or outside a circle: by exact signs, with the band of problem.toml."""

from __future__ import annotations

from judge.topics.circles import POINT, Bands, CircleLine, builders, circle_and_point
from judge.topics.circles.recipes import edges, points

BUILDERS = builders(edges.SEGMENTS, points.RECIPES, adapter=circle_and_point)
TOPIC = POINT


def solve(cx, cy, r, P, *, bands):
    """-1, 0 or 1; a point may not be nearly within the band."""
    line, widths = CircleLine.through(cx, cy, r, P, P), Bands.of(bands)
    return widths.side(line), widths.broken_segment(line)
