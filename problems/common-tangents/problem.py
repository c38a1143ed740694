"""Where the common tangents of two circles touch the first one, and the promise of every case."""

from __future__ import annotations

from judge.topics.circles import COMMON, Bands, CirclePair, builders, two_circles
from judge.topics.circles.recipes import pairs
from judge.values import vector

BUILDERS = builders(pairs.RECIPES, adapter=two_circles)
TOPIC = COMMON


def solve(cx1, cy1, r1, cx2, cy2, r2, *, bands):
    """The points of the outer tangents and of the inner ones; the figure is no point and no ring."""
    pair, widths = CirclePair.of(cx1, cy1, r1, cx2, cy2, r2), Bands.of(bands)
    points = [vector(point, pair.extent_length()) for point in pair.tangents(widths)]
    return points, pair.small(bands["apart"]) or pair.broken(widths, bands["apart"])
