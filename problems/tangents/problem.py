"""Where the tangents through a point touch a circle: exact points, and the promise of every case."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from judge.data.draw import Draw
from judge.topics.circles import TANGENTS, Bands, CircleLine, builders, circle_and_point
from judge.topics.circles.figures.figure import Figure
from judge.topics.circles.figures.posing import posed
from judge.topics.circles.recipes import edges, outside, points
from judge.values import vector


def beside(draw: Draw, *, size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """A point outside that is straight beside the centre, but for the pose."""
    radius = draw.integer(1, size)
    return posed(
        draw, Figure((0, 0), radius, ((radius + draw.integer(1, 3 * size), 0),)), poses=poses, **pose
    )


RECIPES = (edges.SEGMENTS, points.RECIPES, outside.RECIPES, {"beside": beside})
BUILDERS = builders(*RECIPES, adapter=circle_and_point)
TOPIC = TANGENTS


def solve(cx, cy, r, P, *, bands):
    """The points left and right of P→C; P may not be nearly on the circle, nor the circle be tiny."""
    line, widths = CircleLine.through(cx, cy, r, P, P), Bands.of(bands)
    found = [vector(line.touching(which), line.extent_length()) for which in widths.tangents(line)]
    return found, line.small(bands["least_radius"]) or widths.broken_segment(line)
