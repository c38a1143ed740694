"""Simpler motions like a given one: Q at rest in the origin, P along the x axis, numbers of few digits.

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


def simpler_balls(_problem: Problem, case: Case) -> Iterator[Case]:
    """Motions that are simpler as a whole."""
    p0, p1, r, q0, q1, s = case
    floats = any(isinstance(each, float) for each in (*p0, *p1, r, *q0, *q1, s))
    with localcontext(Context(prec=_DIGITS)):
        start, end, drift = (_less(p0, q0), _less(p1, q0), _less(q1, q0))
        way = (end[0] - start[0] - drift[0], end[1] - start[1] - drift[1])
        frames = [(start, (start[0] + way[0], start[1] + way[1]), (Decimal(0), Decimal(0)))]
        frames += _levelled(start, way)
        frames.append((start, end, drift))
        one, other = Decimal(r), Decimal(s)
        for kept in range(1, _FINEST + 1):
            for first, last, still in frames:
                for radii in ((one + other, Decimal(0)), (one, other)):
                    lengths = [plain(few(each, kept), floats=floats) for each in radii]
                    places = [_pair(each, kept, floats) for each in (first, last, still)]
                    yield (places[0], places[1], lengths[0], (0, 0), places[2], lengths[1])


def special_balls(case: Case) -> int:
    """How many of these a motion has: a radius of 0, another one, a disc P that stays where it is."""
    p0, p1, r, _, _, s = case
    return sum((r == 0, s == 0, p0 == p1))


def _levelled(start: _Pair, way: _Pair) -> list[tuple[_Pair, _Pair, _Pair]]:
    """The motion seen from Q laid along the x axis, if there is any."""
    length = (way[0] * way[0] + way[1] * way[1]).sqrt()
    if not length:
        return []
    along = (start[0] * way[0] + start[1] * way[1]) / length
    height = abs(way[0] * start[1] - way[1] * start[0]) / length
    still = (Decimal(0), Decimal(0))
    return [((along, height), (along + length, height), still)]


def _less(p: tuple[float, float], q: tuple[float, float]) -> _Pair:
    return Decimal(p[0]) - Decimal(q[0]), Decimal(p[1]) - Decimal(q[1])


def _pair(pair: _Pair, kept: int, floats: bool) -> tuple[int | float, int | float]:
    return plain(few(pair[0], kept), floats=floats), plain(few(pair[1], kept), floats=floats)
