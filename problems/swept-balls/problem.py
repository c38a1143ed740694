"""Two moving discs: the exact moment of their first touch, and the promise of every case."""

from __future__ import annotations

from judge.topics.circles import Bands, builders
from judge.topics.circles.motion import BALLS
from judge.topics.circles.motion import ball_recipes as recipes
from judge.topics.circles.motion.balls import Balls
from judge.values import Real

BUILDERS = builders(recipes.BALLS, adapter=recipes.two_balls)
TOPIC = BALLS


def solve(p0, p1, r, q0, q1, s, *, bands):
    """The first t from 0 to 1 or None; the unit is the extent in terms of t."""
    balls, widths = Balls.of(p0, p1, r, q0, q1, s), Bands.of(bands)
    t = balls.meeting(widths)
    broken = balls.broken(widths, bands["least_radius"], bands["least_motion"])
    return None if t is None else Real(t, balls.pace.unit()), broken
