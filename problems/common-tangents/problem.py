"""Where the common tangents of two circles touch the first one, and the promise of every case."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from judge.data.draw import Draw
from judge.topics.circles import COMMON, Bands, CirclePair, builders, two_circles
from judge.topics.circles.figures.figure import Figure
from judge.topics.circles.figures.posing import posed
from judge.topics.circles.recipes import pairs
from judge.values import vector


def alike(draw: Draw, *, octaves: Sequence[int], size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """Circles that are apart or cross, with radii that differ by 2**-octaves (bounds) of one of them."""
    one = draw.integer(size // 2, size)
    other = one + draw.sign() * max(1, one >> draw.integer(*octaves))
    away = draw.integer(one // 2, 4 * one)
    return posed(draw, Figure((0, 0), one, ((away, 0),), (), (other,)), poses=poses, **pose)


BUILDERS = builders(pairs.RECIPES, {"alike": alike}, adapter=two_circles)
TOPIC = COMMON


def solve(cx1, cy1, r1, cx2, cy2, r2, *, bands):
    """The points of the outer tangents and of the inner ones; the figure is no point and no ring."""
    pair, widths = CirclePair.of(cx1, cy1, r1, cx2, cy2, r2), Bands.of(bands)
    points = [vector(point, pair.extent_length()) for point in pair.tangents(widths)]
    return points, pair.small(bands["apart"]) or pair.broken(widths, bands["apart"])
