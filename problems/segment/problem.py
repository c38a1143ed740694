"""The circle and the closed segment: the exact common points, in order, and the promise of every case."""

from __future__ import annotations

from judge.topics.circles import SEGMENT, Bands, CircleLine, builders
from judge.topics.circles.recipes import edges, endpoints, whole
from judge.values import vector

BUILDERS = builders(endpoints.RECIPES, edges.SEGMENTS, whole.SEGMENTS)
TOPIC = SEGMENT


def solve(cx, cy, r, A, B, *, bands):
    """The common points in order of t; none of them, and no tangency, may be nearly within a band."""
    line, widths = CircleLine.through(cx, cy, r, A, B), Bands.of(bands)
    points = [vector(line.point(which), line.extent_length()) for which in widths.segment(line)]
    return points, widths.broken_segment(line)
