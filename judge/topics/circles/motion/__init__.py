"""Things that move evenly over the time t = 0 … 1, and when they first touch.

BALLS    the topic of problems with two discs, (P0, P1, r, Q0, Q1, s)
WALL     of those with a disc and a wall, (P0, P1, r, A, B)

moments.py         a moment beside the start and the end of the time
balls.py           two discs in scaled integers, seen from one of them
ball_simpler.py    simpler cases like a failing one
ball_picture.py    a failing case drawn; film.py draws whatever moves
wall.py, wall_*.py the same for a disc and a wall
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from judge.problem.topic import Shown, Topic
from judge.topics.circles.motion.ball_simpler import simpler_balls, special_balls
from judge.topics.circles.motion.wall_simpler import simpler_walls, special_walls

if TYPE_CHECKING:
    from judge.drawing import Picture

__all__ = ["BALLS", "WALL"]


def _ball_picture(shown: Shown) -> Picture | None:
    from judge.topics.circles.motion.ball_picture import ball_picture  # late: most are judged, not drawn

    return ball_picture(shown)


BALLS = Topic(
    simpler=simpler_balls,
    special=special_balls,
    picture=_ball_picture,
)


def _wall_picture(shown: Shown) -> Picture | None:
    from judge.topics.circles.motion.wall_picture import wall_picture  # late as well

    return wall_picture(shown)


WALL = Topic(
    simpler=simpler_walls,
    special=special_walls,
    picture=_wall_picture,
)
