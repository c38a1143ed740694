"""Fresh cases: what a seed stands for and whose they are."""

from __future__ import annotations

from itertools import islice
from pathlib import Path

import pytest

from judge.data.build import Fresh
from judge.errors import ProblemError, UsageError
from judge.problem.find import find_problem
from judge.problem.load import load_problem
from judge.problem.model import EXAMPLES
from judge.problem.module import load_module

FIXTURES = Path(__file__).parent.parent / "fixtures"


def fresh(name, seed=1, groups=None):
    problem = find_problem(name)
    chosen = problem.groups if groups is None else [problem.group(each) for each in groups]
    return Fresh(problem, load_module(problem), chosen, seed)


def cases(source, series):
    return [(each.group.name, each.cases) for each in islice(source.series(), series)]


def test_the_groups_take_turns_and_every_round_is_new():
    names = [each.name for each in find_problem("count").groups if each.name != EXAMPLES]
    found = cases(fresh("count"), 2 * len(names))
    assert found[:3] == cases(fresh("count"), 3)
    assert found[:1] != cases(fresh("count", 6), 1)
    assert [name for name, _ in found] == 2 * names
    assert found[1][1] != found[1 + len(names)][1]


def test_the_examples_have_no_fresh_ones():
    with pytest.raises(UsageError, match="name one of grid"):
        fresh("count", groups=["examples"])


def test_a_builder_that_never_gives_a_case_is_blamed(tmp_path):
    problem = load_problem(FIXTURES / "pack" / "problems" / "middle")
    module = load_module(problem)

    def never(draw):
        draw.reject()

    stubborn = type(module)(module.solve, {group.name: never for group in problem.groups})
    source = Fresh(problem, stubborn, problem.groups, 1)
    with pytest.raises(ProblemError, match="'whole': its draw gives no case 1"):
        next(source.series())
