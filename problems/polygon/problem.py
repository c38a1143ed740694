"""Where the boundary of a polygon crosses a circle: exact, edge by edge, and the promise of every case."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from judge.data.draw import Draw
from judge.topics.circles import OUTLINE, Bands, CircleOutline, builders, circle_and_polygon
from judge.topics.circles.figures.figure import Figure
from judge.topics.circles.figures.posing import posed
from judge.topics.circles.recipes import polygons
from judge.values import vector


def zigzag(draw: Draw, *, corners: Sequence[int], size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """The boundary goes to and fro across the circle: nearly every edge crosses it twice."""
    radius = draw.integer(size // 2, size)
    places = [
        ((1 - number % 2 * 2) * draw.integer(radius + 1, 2 * radius), draw.integer(-radius // 3, radius // 3))
        for number in range(draw.integer(*corners))
    ]
    return posed(draw, Figure((0, 0), radius, tuple(places)), poses=poses, **pose)


BUILDERS = builders(polygons.RECIPES, {"zigzag": zigzag}, adapter=circle_and_polygon)
TOPIC = OUTLINE


def solve(cx, cy, r, V, *, bands):
    """The crossings as (edge, point) along the boundary; a crossing at a corner is its own edge's, once."""
    outline, widths = CircleOutline.of(cx, cy, r, V), Bands.of(bands)
    unit = outline.edges[0].extent_length()
    crossings, broken = outline.solved(widths, bands["least_edge"])
    return [(each.edge, vector(outline.point(each), unit)) for each in crossings], broken
