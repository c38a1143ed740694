"""Circles, and the lines, segments and rays that meet them.

LINE, SEGMENT, RAY    the topic of problems with the arguments (cx, cy, r, A, B) or (cx, cy, r, O, D)
CHORD                 the same as LINE, where the answer is a length on it
HIT, BOUNCE     the same as RAY, where the answer is the normal there, or the point and what is reflected
POINT, FOOT, NORMAL   of those with the arguments (cx, cy, r, P), (A, B, P) or (A, B)
HITS, SPANS, SHADOW   of those with many circles and a ray, (circles, O, D, …)
TANGENTS              the same as POINT, where the answer is points of tangents through P

PAIR, COMMON          of those with two circles, (cx1, cy1, r1, cx2, cy2, r2), for their points and tangents
OUTLINE         of those with a circle and a polygon, (cx, cy, r, V)
plane(Kind…)          the topic of first steps: points and perhaps a circle in whole numbers

line.py        a circle and a directed line in scaled integers
pair.py        two circles, and how they lie to one another
outline.py     a circle and a closed polygon, edge by edge
bands.py       what counts as a touch, as an end, as an origin; what the promise forbids
part.py        what a problem is about
signature.py   from figures to cases and back
plane.py       first steps, each of a kind
frames.py      a circle that moves from frame to frame, and whether a line meets it
simpler.py     simpler cases like a failing one
pair_*.py, simpler_pair.py  the same for two circles
crowd.py              many circles and a ray, and the places of its hits
solids.py             what of the ray is inside a solid made of discs
shadow.py             whether a light reaches the ray's first hit
crowd_*.py, simpler_crowd.py  the same for those
types/         types of parameters, found by their names as those of a pack are
picture/       a failing case drawn
puzzle.py      small figures for quiz cards
explore/       the page of `judge explore`, whose arithmetic is exact in JavaScript
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

from judge.problem.topic import Chance, Puzzle, Shown, Topic
from judge.topics.circles.bands import Bands
from judge.topics.circles.crowd import Crowd, Hit
from judge.topics.circles.line import CircleLine
from judge.topics.circles.outline import OUTLINE, CircleOutline
from judge.topics.circles.pair import CirclePair, Lie
from judge.topics.circles.part import Part
from judge.topics.circles.plane import Kind, plane
from judge.topics.circles.simpler import simpler, special
from judge.topics.circles.simpler_crowd import simpler_crowds, special_crowd
from judge.topics.circles.simpler_pair import simpler_pairs, special_pair

if TYPE_CHECKING:
    from judge.drawing import Picture
    from judge.problem import Problem

__all__ = [
    "BOUNCE",
    "CHORD",
    "COMMON",
    "FOOT",
    "HIT",
    "HITS",
    "LINE",
    "NORMAL",
    "OUTLINE",
    "PAIR",
    "POINT",
    "RAY",
    "SEGMENT",
    "SHADOW",
    "SPANS",
    "TANGENTS",
    "Bands",
    "CircleLine",
    "CircleOutline",
    "CirclePair",
    "Crowd",
    "Hit",
    "Kind",
    "Lie",
    "Part",
    "plane",
    "topic_of",
]


def topic_of(part: Part) -> Topic:
    """What is known of a circle and so much of a line."""
    return Topic(
        simpler=simpler,
        special=special,
        picture=partial(_picture, part),
        explore=partial(_explored, part),
        puzzle=partial(_puzzle, part) if part in (Part.LINE, Part.RAY) else None,
    )


def _puzzle(part: Part, form: str, chance: Chance, solve: Callable[..., Any]) -> Puzzle | None:
    from judge.topics.circles.puzzle import line_puzzle, ray_puzzle  # late: only a quiz asks

    return (ray_puzzle if part is Part.RAY else line_puzzle)(form, chance, solve)


def _hits_puzzle(form: str, chance: Chance, solve: Callable[..., Any]) -> Puzzle | None:
    from judge.topics.circles.puzzle import hits_puzzle  # late as well

    return hits_puzzle(form, chance, solve)


def _picture(part: Part, shown: Shown) -> Picture | None:
    from judge.topics.circles.picture import compose  # late: most problems are loaded to be judged, not drawn

    return compose(part, shown)


def _explored(part: Part, problem: Problem, values: Mapping[str, Any] | None) -> str | None:
    from judge.topics.circles.explore import explored  # late: only who explores asks

    return explored(part, problem, values)


LINE = topic_of(Part.LINE)
SEGMENT = topic_of(Part.SEGMENT)
RAY = topic_of(Part.RAY)
HIT = topic_of(Part.HIT)
BOUNCE = topic_of(Part.BOUNCE)
CHORD = topic_of(Part.CHORD)
POINT = topic_of(Part.POINT)
FOOT = topic_of(Part.FOOT)
NORMAL = topic_of(Part.NORMAL)
TANGENTS = topic_of(Part.TANGENTS)
PAIR, COMMON = (
    Topic(
        simpler=simpler_pairs,
        special=special_pair,
        picture=partial(_picture, part),
    )
    for part in (Part.PAIR, Part.COMMON)
)
HITS, SPANS, SHADOW = (
    Topic(
        simpler=simpler_crowds,
        special=special_crowd,
        picture=partial(_picture, part),
        puzzle=_hits_puzzle if part is Part.HITS else None,
    )
    for part in (Part.HITS, Part.SPANS, Part.SHADOW)
)
