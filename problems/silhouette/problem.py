"""A line held against a circle that moves: 1 or 0 for each frame, steadily, and the promise of every case."""

from __future__ import annotations

from judge.topics.circles import Bands
from judge.topics.circles.frames import FRAMES, broken, frames_of, steady
from judge.topics.circles.recipes.frames import BUILDERS

__all__ = ["BUILDERS", "TOPIC", "solve"]
TOPIC = FRAMES


def solve(circles, origin, direction, h, *, bands):
    """What each frame shows; D may not be (0, 0)."""
    frames, widths = frames_of(circles, origin, direction), Bands.of(bands)
    fault = broken(frames, h, widths)
    return ([] if frames[0].a == 0 else steady(frames, h, widths)), fault
