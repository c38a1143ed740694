"""Programs that are wrong in one small thing are rejected by the data, and by fresh cases as well.

The programs are those of edge_programs.py: careful ones but for a threshold just inside or outside of what
the statement allows, 64-bit integers, a memory that forgets an argument, a special case that is none.
"""

from __future__ import annotations

from functools import partial
from itertools import islice
from pathlib import Path

import edge_programs as programs
import pytest

from judge.data import load_data
from judge.data.fresh import Fresh
from judge.data.module import load_module
from judge.problem.load import load_problem
from judge.values import Accepted

PROBLEMS = Path(__file__).parents[2] / "problems"
ENOUGH = 5
ROUNDS = 2  # of fresh cases: less than `judge stress` makes in a second
MISTAKES = [(name, wrong) for name, several in programs.WRONG.items() for wrong in several]


class Data:
    """A problem's pinned groups and some rounds of fresh ones, with who is right."""

    def __init__(self, name):
        self.problem = load_problem(PROBLEMS / name)
        self.pinned = load_data(self.problem, cache=False).groups
        module = load_module(self.problem)
        self.solve = module.solve
        fresh = Fresh(self.problem, module, self.problem.groups, 11)
        self.fresh = [series.data for series in islice(fresh.series(), ROUNDS * len(fresh.groups))]

    def rejected(self, groups, function):
        """How many of the groups' cases the function gets wrong, called in order."""
        return sum(
            not self.accepts(answer(function, case), target, case, data.group)
            for data in groups
            for case, target in zip(data.cases, data.targets, strict=True)
        )

    def accepts(self, raw, target, case, group):
        outcome = self.problem.answer.check(raw, target, lambda: (self.solve(*case).answer, group.tolerance))
        return isinstance(outcome, Accepted)


def answer(function, case):
    """What the function answers, as JSON has it; a crash is no answer."""
    try:
        value = function(*case)
    except ArithmeticError:
        return {"crash": True}
    return [list(point) for point in value] if isinstance(value, list) else value


@pytest.fixture(scope="module")
def data_of():
    known = {}

    def of(name):
        if name not in known:
            known[name] = Data(name)
        return known[name]

    return of


@pytest.mark.parametrize("name", programs.ENTRIES)
def test_the_program_itself_is_right(data_of, name):
    data = data_of(name)
    assert data.rejected(data.pinned, programs.ENTRIES[name]) == 0
    assert data.rejected(data.fresh, programs.ENTRIES[name]) == 0


@pytest.mark.parametrize(("name", "wrong"), MISTAKES)
def test_a_wrong_one_is_rejected_by_some_cases_and_by_fresh_ones(data_of, name, wrong):
    data = data_of(name)
    function = partial(programs.ENTRIES[name], **wrong)
    assert data.rejected(data.pinned, function) >= ENOUGH
    assert data.rejected(data.fresh, function) >= 1


@pytest.mark.parametrize("name", programs.ENTRIES)
@pytest.mark.parametrize("left_out", range(5))
@pytest.mark.parametrize("memory", [programs.forgetful, programs.stale])
def test_a_memory_that_leaves_an_argument_out_is_met(data_of, name, left_out, memory):
    data = data_of(name)
    assert data.rejected(data.pinned, memory(programs.ENTRIES[name], left_out)) >= ENOUGH
    assert data.rejected(data.fresh, memory(programs.ENTRIES[name], left_out)) >= 1


SIDES = {"ax": 0, "ay": 1, "bx": 2, "by": 3}


@pytest.mark.parametrize("quantity", SIDES)
def test_an_extent_that_leaves_a_quantity_out_is_met(data_of, quantity):
    data = data_of("count")
    function = partial(programs.count, reach=lambda *_: {quantity: 0})
    assert data.rejected(data.pinned, function) >= ENOUGH


@pytest.mark.parametrize("quantity", SIDES)
@pytest.mark.parametrize("sign", [1, -1])
def test_an_extent_that_loses_a_sign_is_met(data_of, quantity, sign):
    data = data_of("count")

    def reach(_r, *spans):
        return {quantity: sign * spans[SIDES[quantity]]}

    assert data.rejected(data.pinned, partial(programs.count, reach=reach)) >= ENOUGH


WITNESSES = [
    ("segment", {"bits": 64}, (0, 0, 10**6, (-(10**7), 10**5), (10**7, 2 * 10**5))),
    ("count", {"floor": True}, (0, 0, 1, (-3, -3), (-2, -1))),
    ("ray-nearest", {"behind": 2e-7}, (0, 0, 8000000, (8000001, 0), (1, 0))),
    ("ray-nearest", {"skip": 1e-6}, (0, 0, 2000000, (2000001, 0), (-1, 0))),
    ("segment", {"null": 1e-6}, (0, 0, 2500000, (2499999, 0), (2500001, 0))),
]


@pytest.mark.parametrize(("name", "wrong", "case"), WITNESSES)
def test_a_witness_tells_the_wrong_program_from_the_right_one(data_of, name, wrong, case):
    data = data_of(name)
    group = data.problem.groups[0]
    exact, broken = data.solve(*case)
    assert broken is None
    target = data.problem.answer.target(exact, group.tolerance)
    assert data.accepts(answer(programs.ENTRIES[name], case), target, case, group)
    assert not data.accepts(answer(partial(programs.ENTRIES[name], **wrong), case), target, case, group)
