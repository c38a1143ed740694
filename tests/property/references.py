"""Exact answers of katas held against other formulas, in so many digits that none is lost; vectors."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from decimal import Decimal, localcontext
from pathlib import Path
from typing import Any

from judge.data import reseeded
from judge.data.build import draw_cases
from judge.data.load import load_data
from judge.exact import Surd
from judge.problem.declare import InvalidCase
from judge.problem.load import load_problem
from judge.problem.module import load_module
from judge.values.answers import Real

PROBLEMS = Path(__file__).parents[2] / "problems"
CASES = 20_000 if os.environ.get("NIGHTLY") else 2_000  # of other seeds than the pinned one
SNAP = Decimal("1e-12")
CLOSE = Decimal("1e-60")  # of a number's unit; of 160 digits differences keep 80, and a root of them more


def vec(*numbers):
    return tuple(map(Decimal, numbers))  # of ints or doubles, without rounding


def plus(p, q, times=1):
    return tuple(x + times * y for x, y in zip(p, q, strict=True))


def minus(p, q):
    return plus(p, q, -1)


def times(share, p):
    return tuple(share * x for x in p)


def dot(p, q):
    return sum(x * y for x, y in zip(p, q, strict=True))


def cross(p, q):
    return p[0] * q[1] - p[1] * q[0]


def norm(p):
    return dot(p, p).sqrt()


def reach(*vectors):
    return max(abs(x) for vector in vectors for x in vector)


def number(x: Any) -> Decimal:
    x = x.x if isinstance(x, Real) else x
    x = x if isinstance(x, Surd) else Surd.of(x)
    return (Decimal(x.p) + Decimal(x.q) * Decimal(x.d).sqrt()) / Decimal(x.s)


def alike(answer: Any, other: Any, close: Decimal = CLOSE) -> bool:
    """Whether two answers are alike: each number within a hair of its own unit."""
    if isinstance(answer, Real):
        unit = number(answer.unit)
        return other is not None and abs(number(answer) - other) <= close * unit
    if isinstance(answer, list | tuple):
        return (
            isinstance(other, list | tuple)
            and len(answer) == len(other)
            and all(alike(*pair, close) for pair in zip(answer, other, strict=True))
        )
    return answer == other


def solver(name: str) -> Callable[..., Any]:
    return load_module(load_problem(PROBLEMS / name)).solve


def broken_promise(name: str, *case: Any) -> str | None:
    """What of the kata's promise a case breaks."""
    try:
        solver(name)(*case)
    except InvalidCase as broken:
        return str(broken)
    return None


def cases_of(name: str) -> list[Any]:
    """Cases of two seeds or more that are not the pinned one, as many of every group."""
    problem = load_problem(PROBLEMS / name)
    wanted = CASES
    seeds = max(2, -(-wanted // sum(group.count for group in problem.groups)))
    groups = [
        group for seed in range(seeds) for group in load_data(problem, seed=11 + seed, store=None).groups
    ]
    most = -(-wanted // len(groups))
    return [case for group in groups for case in group.cases[:most]]


def answers(
    name: str, formula: Callable[..., Any], cases: Iterable[Any], same: Callable[..., bool] = alike
) -> Iterator[Any]:
    """The exact answers, each of which is that of the formula in 160 digits."""
    solve = solver(name)
    for case in cases:
        answer = solve(*case)
        with localcontext(prec=160):
            assert same(answer, formula(*case)), case
        yield answer


def small_cases(name: str, seeds: Iterable[int | None]) -> Iterator[Any]:
    """The first cases of the groups of a kata of large ones that are not large, with their exact answers."""
    problem = load_problem(PROBLEMS / name)
    module = load_module(problem)
    for seed in seeds:
        for group in problem.groups:
            if group.size is None and group.name != "examples":
                made = draw_cases(problem, module, reseeded(group, seed))
                yield from ((each.case, each.exact) for each in made[:12])
