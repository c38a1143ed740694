"""The circle and the ray: the exact answer, the promise of every case, the recipes of the data."""

from __future__ import annotations

from functools import lru_cache

from judge.data.builders.rays import RAY_BUILDERS
from judge.data.images import mirror_images
from judge.exact import Bands, CircleLine
from judge.problem.load import bands_beside
from judge.problem.model import Number, Point
from judge.values import Real

BANDS = Bands(**bands_beside(__file__))
BUILDERS = RAY_BUILDERS
IMAGES = mirror_images

_line = lru_cache(1)(CircleLine.ray)  # the promise and the reference ask for one case in turn


def reference(cx: Number, cy: Number, r: Number, origin: Point, direction: Point) -> Real | None:
    """The least t >= 0 or None; the unit is the extent in terms of t, which only t = 0 needs."""
    line = _line(cx, cy, r, origin, direction)
    t = BANDS.ray(line)
    return None if t is None else Real(t, line.extent_parameter())


def promise(cx: Number, cy: Number, r: Number, origin: Point, direction: Point) -> str | None:
    """What is within the forbidden bands: the tangency, or a common point near the origin."""
    return BANDS.broken_ray(_line(cx, cy, r, origin, direction))
