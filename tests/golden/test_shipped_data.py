"""The shipped problems' data: pinned, and good for another seed. The gate proves each case."""

from __future__ import annotations

from pathlib import Path

import pytest
from sampling import daily

from judge.data.load import load_data
from judge.data.pins import differences, pins_of, read_pins
from judge.languages import language_of
from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.run.execute import judge_submission
from judge.run.settings import Settings

pytestmark = pytest.mark.slow

PROBLEMS = Path(__file__).parent.parent.parent / "problems"
NAMES = sorted(path.parent.name for path in PROBLEMS.glob("*/problem.toml"))
# Of each kind the cheapest; by night the pins of all.
BY_DAY = ["circle-side", "exact-count", "on-circle", "stable-roots", "test-writer"]


@pytest.mark.parametrize("name", daily(NAMES, BY_DAY))
def test_every_group_is_as_it_was_pinned_and_another_seed_gives_full_groups_of_other_cases(name):
    problem = load_problem(PROBLEMS / name)
    data = load_data(problem, store=None)
    pins = read_pins(problem)
    assert pins is not None
    kills = {group.name: group.kills for group in problem.groups}
    assert differences(pins, pins_of(data.groups, kills)) == []
    for group in data.groups:
        assert len(group.cases) == len(group.targets) == group.group.count
    least = 400 if problem.parameters else len(problem.groups)  # of what is asked for nothing, one a group
    # a case of a given size asks as many questions
    assert sum(len(group.cases) * (group.group.size or 1) for group in data.groups) >= least
    assert sum(group.points for group in problem.groups) == 100
    assert problem.examples
    other = load_data(problem, seed=2**70, store=None)
    assert [len(group.cases) for group in other.groups] == [group.count for group in problem.groups]
    changed = sum(a.cases != b.cases for a, b in zip(data.groups, other.groups, strict=True))
    assert changed == (len(problem.groups) - 1 if problem.parameters else 0)  # all but the examples


@pytest.mark.nightly
@pytest.mark.parametrize("name", NAMES)
def test_accepted_solutions_pass_the_data_of_another_seed(name):
    """By their answers: their time is measured on the pinned data, by the gate."""
    problem = load_problem(PROBLEMS / name)
    other = load_data(problem, seed=20261120, store=None)
    for path in sorted((problem.solutions / "accepted").glob("*.py")):
        if not language_of(path):
            judged = judge_submission(other, path.read_bytes(), path.name, Settings(measured=False))
            assert judged.result.verdict is Verdict.AC, path.name
