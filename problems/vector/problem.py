"""Many circles in three arrays and one line: how many points each has in common with it."""

from __future__ import annotations

from judge.topics.circles import Bands
from judge.topics.circles.recipes import columns
from judge.topics.circles.rows import ROWS, counts

BUILDERS = columns.RECIPES
TOPIC = ROWS


def solve(cx, cy, r, start, end, *, bands):
    """0, 1 or 2 for each circle, with its own extent, and what breaks the promise."""
    if not len(cx) == len(cy) == len(r):
        return [], "the three arrays are of different lengths"
    if start == end:
        return [], "A and B are the same point"
    if r and min(r) < 0:
        return [], "a radius is negative"
    return counts(cx, cy, r, start, end, Bands.of(bands))
