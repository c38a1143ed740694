"""The normal where a ray meets a circle first: exact, facing the ray, and the promise of every case."""

from __future__ import annotations

from judge.topics.circles import HIT, Bands, CircleLine, builders
from judge.topics.circles.recipes import edges, rays, vectors, whole
from judge.values import vector

BUILDERS = builders(rays.RECIPES, edges.RAYS, whole.RAYS, vectors.RECIPES)
TOPIC = HIT


def solve(cx, cy, r, origin, direction, *, bands):
    """The unit normal on the side of the origin, or None; the circle may not be tiny. The unit is e/r."""
    line, widths = CircleLine.ray(cx, cy, r, origin, direction), Bands.of(bands)
    if line.degenerate or line.r == 0:
        return None, None
    broken = line.small(bands["least_radius"]) or widths.broken_ray(line)
    which = widths.hit(line)
    return None if which is None else vector(line.facing(which), line.extent_radii()), broken
