"""Where the tangents through a point touch a circle: exact points, and the promise of every case."""

from __future__ import annotations

from judge.topics.circles import TANGENTS, Bands, CircleLine, builders, circle_and_point
from judge.topics.circles.recipes import edges, outside, points
from judge.values import vector

BUILDERS = builders(edges.SEGMENTS, points.RECIPES, outside.RECIPES, adapter=circle_and_point)
TOPIC = TANGENTS


def solve(cx, cy, r, P, *, bands):
    """The points left and right of P→C; P may not be nearly on the circle, nor the circle be tiny."""
    line, widths = CircleLine.through(cx, cy, r, P, P), Bands.of(bands)
    found = [vector(line.touching(which), line.extent_length()) for which in widths.tangents(line)]
    if 0 < line.r < bands["least_radius"] * line.extent:
        return found, "the radius is not 0, but too small a part of the extent"
    return found, widths.broken_segment(line)
