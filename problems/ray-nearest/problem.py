"""The circle and the ray: the exact answer, the promise of every case, the recipes of the data."""

from __future__ import annotations

from functools import lru_cache

from judge.compare.answers import Parameter
from judge.problem.load import bands_beside
from judge.problem.model import Number, Point
from judge.topics.circles.bands import Bands
from judge.topics.circles.images import mirror_images
from judge.topics.circles.line import CircleLine
from judge.topics.circles.recipes.rays import RAY_BUILDERS

BANDS = Bands(**bands_beside(__file__))
BUILDERS = RAY_BUILDERS
IMAGES = mirror_images

_line = lru_cache(1)(CircleLine.ray)  # the promise and the reference ask for one case in turn


def reference(cx: Number, cy: Number, r: Number, origin: Point, direction: Point) -> Parameter:
    """The least t >= 0 or None; the unit is the extent in terms of t, which only t = 0 needs."""
    line = _line(cx, cy, r, origin, direction)
    return Parameter(BANDS.ray(line), line.extent_parameter())


def promise(cx: Number, cy: Number, r: Number, origin: Point, direction: Point) -> str | None:
    """What is within the forbidden bands: the tangency, or a common point near the origin."""
    return BANDS.broken_ray(_line(cx, cy, r, origin, direction))
