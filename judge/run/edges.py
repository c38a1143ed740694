"""Which edges the cases of a problem reach: a parameter is 0, two are equal, a decision is exact or nearly.

For a setter, who looks for what no case has.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import combinations
from typing import Any

from msgspec import Struct

from judge.data.load import ProblemData
from judge.problem.declare import InvalidCase, decisions

NEARLY = 1e-5  # of the size: a decision that is less than this and not exact


class Edge(Struct, frozen=True):
    """How many cases reach an edge of what may come."""

    what: str
    cases: int


def edges_of(data: ProblemData) -> list[Edge]:
    """The edges of the signature and those of the decisions of `solve`; 0 where no case has one."""
    problem, solve = data.problem, data.module.solve
    names = [parameter.name for parameter in problem.parameters]
    found: Counter[str] = Counter()
    decided: dict[str, Counter[str]] = {}
    for case in (case for group in data.groups if group.group.size is None for case in group.cases):
        found.update(_of_signature(names, case))
        with decisions() as made:
            try:
                solve(*case)
            except InvalidCase:
                continue
        for what, how in {(each.what, _how(each.gap)) for each in made}:
            decided.setdefault(what, Counter())[how] += 1
    rows = [Edge(label, found[label]) for label in _labels(names, data)]
    return rows + [
        Edge(f"{what}: {how}", counts[how])
        for what, counts in sorted(decided.items())
        for how in ("exactly", "nearly", "clear")
    ]


def flat_numbers(value: Any) -> Iterator[Any]:
    """The numbers of an argument."""
    if isinstance(value, tuple | list):
        for part in value:
            yield from flat_numbers(part)
    elif isinstance(value, int | float):
        yield value


def _of_signature(names: list[str], case: Any) -> Iterator[str]:
    for name, value in zip(names, case, strict=True):
        if not any(flat_numbers(value)):
            yield f"{name} is 0"
    for (first, x), (second, y) in combinations(zip(names, case, strict=True), 2):
        if x == y:
            yield f"{first} = {second}"
    numbers = [number for value in case for number in flat_numbers(value)]
    kinds = {type(number) for number in numbers}
    yield "all ints" if kinds == {int} else "all floats" if kinds == {float} else "ints and floats"
    size = max(map(abs, numbers), default=0)
    yield "all below 1e-6" if size < 1e-6 else "some above 1e6" if size > 1e6 else "up to 1e6"


def _labels(names: list[str], data: ProblemData) -> Iterator[str]:
    """The edges of the signature: two parameters can be equal if they hold as many numbers."""
    parameters = data.problem.parameters
    yield from (f"{name} is 0" for name in names)
    for (first, x), (second, y) in combinations(zip(names, parameters, strict=True), 2):
        if x.type.width == y.type.width:
            yield f"{first} = {second}"
    if any(parameter.type.measured for parameter in parameters):
        yield from ("all ints", "all floats", "ints and floats")
        yield from ("all below 1e-6", "up to 1e6", "some above 1e6")


def _how(gap: float) -> str:
    return "exactly" if gap == 0 else "nearly" if abs(gap) < NEARLY else "clear"
