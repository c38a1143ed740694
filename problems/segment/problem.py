"""The circle and the closed segment: the exact answer, the promise of every case, the recipes of the data."""

from __future__ import annotations

from functools import lru_cache

from judge.data.builders.endpoints import SEGMENT_BUILDERS
from judge.data.images import mirror_images
from judge.exact import Bands, CircleLine
from judge.problem.load import bands_beside
from judge.problem.model import Number, Point
from judge.values import Real, vector

BANDS = Bands(**bands_beside(__file__))
BUILDERS = SEGMENT_BUILDERS
IMAGES = mirror_images

_line = lru_cache(1)(CircleLine.through)  # the promise and the reference ask for one case in turn


def reference(cx: Number, cy: Number, r: Number, A: Point, B: Point) -> list[tuple[Real, ...]]:
    """The common points in order of t, with the extent as the unit of their tolerance."""
    line = _line(cx, cy, r, A, B)
    return [vector(line.point(which), line.extent_length()) for which in BANDS.segment(line)]


def promise(cx: Number, cy: Number, r: Number, A: Point, B: Point) -> str | None:
    """What is within the forbidden bands: the tangency, or a common point near an end."""
    return BANDS.broken_segment(_line(cx, cy, r, A, B))
