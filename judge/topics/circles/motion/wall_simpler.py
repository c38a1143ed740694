"""Simpler discs and walls like given ones: the wall along the x axis from the origin, numbers of few digits.

Nothing here need be right: a candidate counts only if it is valid and the submission fails on it.
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Context, Decimal, localcontext

from judge.problem import Case, Problem
from judge.topics.circles.digits import few, plain

_DIGITS = 60
_FINEST = 16  # digits that are kept at most

_Pair = tuple[Decimal, Decimal]


def simpler_walls(_problem: Problem, case: Case) -> Iterator[Case]:
    """Cases that are simpler as a whole."""
    p0, p1, r, a, b = case
    floats = any(isinstance(each, float) for each in (*p0, *p1, r, *a, *b))
    with localcontext(Context(prec=_DIGITS)):
        seen = [(Decimal(x) - Decimal(a[0]), Decimal(y) - Decimal(a[1])) for x, y in (p0, p1, b)]
        frames = [*_levelled(seen), seen]
        for kept in range(1, _FINEST + 1):
            radius = plain(few(Decimal(r), kept), floats=floats)
            for frame in frames:
                start, end, wall = (
                    tuple(plain(few(part, kept), floats=floats) for part in place) for place in frame
                )
                yield (start, end, radius, (0, 0), wall)


def special_walls(case: Case) -> int:
    """How many of these a case has: a disc that rests, a wall that is a point."""
    p0, p1, _, a, b = case
    return sum((p0 == p1, a == b))


def _levelled(places: list[_Pair]) -> Iterator[list[_Pair]]:
    """The same with the wall along the x axis, if it is one; or with the way there."""
    (px, py), (qx, qy), wall = places
    for u, v in (wall, (qx - px, qy - py)):
        length = (u * u + v * v).sqrt()
        if length:
            turned = [((x * u + y * v) / length, (u * y - v * x) / length) for x, y in places]
            yield turned
            yield [(x, -y) for x, y in turned]
