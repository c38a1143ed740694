"""A ray reflected where it meets a circle first: exact point and direction, and the promise of every case."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from judge.data.draw import Draw
from judge.topics.circles import BOUNCE, Bands, CircleLine, builders
from judge.topics.circles.figures.figure import Figure, ray
from judge.topics.circles.figures.posing import posed
from judge.topics.circles.recipes import edges, rays, vectors, whole
from judge.values import vector


def off_centre(draw: Draw, *, octaves: Sequence[int], size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """A ray that passes the centre by 2**-octaves (bounds) of the radius, from outside or from inside."""
    radius = draw.integer(size // 2, size)
    offset = max(1, radius >> draw.integer(*octaves)) * draw.sign()
    start = -radius - draw.integer(1, 2 * radius) if draw.boolean() else draw.integer(1 - radius, radius - 1)
    return posed(draw, ray((0, 0), radius, (start, offset), (draw.integer(1, 6), 0)), poses=poses, **pose)


BUILDERS = builders(rays.RECIPES, edges.RAYS, whole.RAYS, vectors.RECIPES, {"off-centre": off_centre})
TOPIC = BOUNCE


def solve(cx, cy, r, origin, direction, *, bands):
    """The point in units of e and D − 2(D·N)N in units of e/r·|D|∞, or None; the circle may not be tiny."""
    line, widths = CircleLine.ray(cx, cy, r, origin, direction), Bands.of(bands)
    if line.degenerate or line.r == 0:
        return None, None
    broken = line.small(bands["least_radius"]) or widths.broken_ray(line)
    which = widths.hit(line)
    if which is None:
        return None, broken
    point = vector(line.point(which), line.extent_length())
    return (point, vector(line.reflected(which), line.extent_reflected())), broken
