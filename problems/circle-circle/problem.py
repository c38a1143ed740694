"""The common points of two circles, exactly and in order, and the promise of every case."""

from __future__ import annotations

from judge.topics.circles import PAIR, Bands, CirclePair, Lie, builders, two_circles
from judge.topics.circles.recipes import pairs
from judge.values import vector

BUILDERS = builders(pairs.RECIPES, adapter=two_circles)
TOPIC = PAIR


def solve(cx1, cy1, r1, cx2, cy2, r2, *, bands):
    """The point left of C1→C2 and the right one, their touch, or None for one and the same circle.

    Two points of a tiny circle take more digits than a plain formula has, so circles that cross are not tiny.
    """
    pair, widths = CirclePair.of(cx1, cy1, r1, cx2, cy2, r2), Bands.of(bands)
    lie, unit = pair.lie(widths), pair.extent_length()
    points = None if lie is Lie.SAME else [vector(point, unit) for point in pair.points(lie)]
    small = pair.small(bands["least_radius"]) if lie is Lie.CROSSING else None
    return points, pair.broken(widths, bands["apart"]) or small
