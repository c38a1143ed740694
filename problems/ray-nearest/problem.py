"""The circle and the ray: the exact parameter of the first common point, and the promise of every case."""

from __future__ import annotations

from judge.topics.circles import RAY, Bands, CircleLine, builders
from judge.topics.circles.recipes import edges, rays, whole
from judge.values import Real

BUILDERS = builders(rays.RECIPES, edges.RAYS, whole.RAYS)
TOPIC = RAY


def solve(cx, cy, r, origin, direction, *, bands):
    """The least t >= 0 or None; the unit is the extent in terms of t, which only t = 0 needs."""
    line, widths = CircleLine.ray(cx, cy, r, origin, direction), Bands.of(bands)
    t = widths.ray(line)
    return None if t is None else Real(t, line.extent_parameter()), widths.broken_ray(line)
