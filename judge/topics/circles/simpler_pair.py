"""Simpler pairs of circles like a given one: C1 at the origin, C2 beside it or above, numbers of few digits.

Nothing here need be right: a candidate counts only if it is valid and the submission fails on it.
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Context, Decimal, localcontext
from fractions import Fraction

from judge.problem import Case, Problem
from judge.topics.circles.digits import few, plain

_DIGITS = 60
_FINEST = 16  # digits that are kept at most


def simpler_pairs(_problem: Problem, case: Case) -> Iterator[Case]:
    """Pairs that are simpler as a whole; those of other arguments have none."""
    if len(case) != 6 or any(isinstance(each, tuple) for each in case):
        return
    cx1, cy1, r1, cx2, cy2, r2 = map(Fraction, case)
    floats = any(isinstance(each, float) for each in case)
    with localcontext(Context(prec=_DIGITS)):
        one, two, x, y = map(_decimal, (r1, r2, cx2 - cx1, cy2 - cy1))
        away = (x * x + y * y).sqrt()
        for kept in range(1, _FINEST + 1):
            for dx, dy in ((away, Decimal(0)), (Decimal(0), away), (-away, Decimal(0)), (x, y)):
                yield (0, 0, *(plain(few(each, kept), floats=floats) for each in (one, dx, dy, two)))


def special_pair(case: Case) -> int:
    """How many of these a pair has: a radius of 0, another one, one centre of both."""
    cx1, cy1, r1, cx2, cy2, r2 = case
    return sum((r1 == 0, r2 == 0, (cx1, cy1) == (cx2, cy2)))


def _decimal(value: Fraction) -> Decimal:
    return Decimal(value.numerator) / Decimal(value.denominator)
