"""Between the arguments of a call and the circle and the line that they stand for.

The flat signature is (cx, cy, r, points …, vectors …): a circle's numbers one by one, points and vectors as
pairs.
"""

from __future__ import annotations

from judge.problem import Case
from judge.problem.model import Number, Point
from judge.topics.circles.line import CircleLine
from judge.topics.circles.pair import CirclePair
from judge.topics.circles.part import Part


def circle_and_pairs(case: Case) -> tuple[Point, Number, Point, Point] | None:
    """The centre, the radius and the two pairs of a flat case that has so many; None for any other case."""
    if len(case) != 5:
        return None
    cx, cy, radius, p, q = case
    if isinstance(cx, tuple) or isinstance(cy, tuple) or isinstance(radius, tuple):
        return None
    if not isinstance(p, tuple) or not isinstance(q, tuple):
        return None
    return (cx, cy), radius, p, q


def read(part: Part, case: Case) -> tuple[Point, Number, Point, Point] | None:
    """The centre, the radius and the two pairs that such a case stands for; None for any other case."""
    if part.of_point and len(case) == 4:
        return circle_and_pairs((*case, case[3]))
    if part is Part.FOOT and len(case) == 3 and all(isinstance(each, tuple) for each in case):
        return case[2], 0, case[0], case[1]
    if part is Part.NORMAL and len(case) == 2 and all(isinstance(each, tuple) for each in case):
        return (0, 0), 0, case[0], case[1]
    if part.of_point or part.of_pair or part.of_crowd or part in (Part.FOOT, Part.NORMAL):
        return None
    return circle_and_pairs(case)


def line_of(part: Part, case: Case) -> CircleLine | None:
    """The same as a circle and a directed line in integers."""
    if part.of_pair:
        plain = len(case) == 6 and not any(isinstance(each, tuple) for each in case)
        return CirclePair.of(*case).circles()[0] if plain else None
    found = read(part, case)
    if found is None:
        return None
    centre, radius, first, second = found
    build = CircleLine.ray if part.of_ray else CircleLine.through
    return build(*centre, radius, first, second)
