"""A moving disc and a wall: the exact moment of their first touch, and the promise of every case."""

from __future__ import annotations

from judge.topics.circles import Bands, builders
from judge.topics.circles.motion import WALL
from judge.topics.circles.motion import wall_recipes as recipes
from judge.topics.circles.motion.wall import Wall, Widths
from judge.values import Real

BUILDERS = builders(recipes.WALLS, adapter=recipes.wall_case)
TOPIC = WALL


def solve(p0, p1, r, a, b, *, bands):
    """The first t from 0 to 1 or None; the unit is the extent in terms of t."""
    wall, widths = Wall.of(p0, p1, r, a, b), Bands.of(bands)
    t = wall.meeting(widths)
    least = Widths(*(bands[f"least_{name}"] for name in ("radius", "motion", "wall", "sine")))
    return None if t is None else Real(t, wall.pace.unit()), wall.broken(widths, least)
