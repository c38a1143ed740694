"""Which edges the cases of a problem reach: a parameter is 0, two are equal, a decision is exact or nearly.

For a setter, who looks for what no case has.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import suppress
from itertools import combinations
from typing import Any

from msgspec import Struct

from judge.data import ProblemData
from judge.problem import Case, Parameter
from judge.problem.declare import InvalidCase, decisions
from judge.values.letters import texts_of

NEARLY = 1e-5  # of the size: a decision that is less than this and not exact
_HOW = ("exactly", "nearly", "clear")


class EdgeCoverage(Struct, frozen=True):
    """How many cases reach an edge of what may come."""

    what: str
    cases: int


def edges_of(data: ProblemData) -> list[EdgeCoverage]:
    """The edges of the signature and those of the decisions of `solve`; 0 where no case has one."""
    cases = [case for group in data.groups if group.group.size is None for case in group.cases]
    decided: Counter[tuple[str, str]] = Counter()
    for case in cases:
        with suppress(InvalidCase), decisions() as made:
            data.module.solve(*case)
            decided.update({(each.what, _how(each.gap)) for each in made})
    rows = list(_of_signature(data.problem.parameters, cases))
    for what in sorted({what for what, _ in decided}):
        rows += [EdgeCoverage(f"{what}: {how}", decided[what, how]) for how in _HOW]
    return rows


def _of_signature(parameters: Sequence[Parameter], cases: Sequence[Case]) -> Iterator[EdgeCoverage]:
    """Two parameters can be equal if they hold as many numbers."""
    for at, each in enumerate(parameters):
        if texts_of(each.type):
            yield EdgeCoverage(f"{each.name} is empty", sum(not case[at] for case in cases))
        else:
            yield EdgeCoverage(f"{each.name} is 0", sum(not any(_numbers(case[at])) for case in cases))
    for (at, x), (other, y) in combinations(enumerate(parameters), 2):
        if x.type.width == y.type.width:
            yield EdgeCoverage(f"{x.name} = {y.name}", sum(case[at] == case[other] for case in cases))
    if any(each.type.measured for each in parameters):
        kinds = [set(map(type, _numbers(case))) for case in cases]
        ints, floats = kinds.count({int}), kinds.count({float})
        yield EdgeCoverage("all ints", ints)
        yield EdgeCoverage("all floats", floats)
        yield EdgeCoverage("ints and floats", len(cases) - ints - floats)
        sizes = [max(map(abs, _numbers(case)), default=0) for case in cases]
        yield EdgeCoverage("all below 1e-6", sum(size < 1e-6 for size in sizes))
        yield EdgeCoverage("up to 1e6", sum(1e-6 <= size <= 1e6 for size in sizes))
        yield EdgeCoverage("some above 1e6", sum(size > 1e6 for size in sizes))


def _numbers(value: Any) -> Iterator[Any]:
    """The numbers of an argument, or of a case."""
    if isinstance(value, tuple | list):
        for part in value:
            yield from _numbers(part)
    elif isinstance(value, int | float):
        yield value


def _how(gap: float) -> str:
    return _HOW[0 if gap == 0 else 1 if abs(gap) < NEARLY else 2]
