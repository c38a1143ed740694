"""The shipped problems' data: pinned, and good for any seed. The gate asks whether each case is proved."""

from __future__ import annotations

from pathlib import Path

import pytest

from judge.data import load_data
from judge.data.pins import differences, read_pins
from judge.languages import language_of
from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.run import Settings, run_submission

pytestmark = pytest.mark.slow

PROBLEMS = Path(__file__).parent.parent.parent / "problems"
NAMES = sorted(path.parent.name for path in PROBLEMS.glob("*/problem.toml"))


@pytest.fixture(scope="module", params=NAMES)
def problem(request):
    return load_problem(PROBLEMS / request.param)


@pytest.fixture(scope="module")
def data(problem):
    return load_data(problem, cache=False)


def test_every_group_is_as_it_was_pinned(problem, data):
    pins = read_pins(problem)
    assert pins is not None
    assert differences(pins, data.groups) == []
    for group in data.groups:
        assert len(group.cases) == len(group.targets) == group.group.count


def test_there_are_cases_and_points_enough(problem, data):
    least = 400 if problem.parameters else len(problem.groups)  # of what is asked for nothing, one a group
    # a case of a given size asks as many questions
    assert sum(len(group.cases) * (group.group.size or 1) for group in data.groups) >= least
    assert sum(group.points for group in problem.groups) == 100
    assert problem.examples


@pytest.mark.nightly
@pytest.mark.parametrize("seed", [0, 20261120, 2**70])
def test_any_seed_gives_full_groups_of_other_cases_that_accepted_solutions_pass(problem, data, seed):
    """By their answers: their time is measured on the pinned data, by the gate."""
    other = load_data(problem, seed=seed, cache=False)
    assert [len(group.cases) for group in other.groups] == [group.count for group in problem.groups]
    changed = sum(a.cases != b.cases for a, b in zip(data.groups, other.groups, strict=True))
    assert changed == (len(problem.groups) - 1 if problem.parameters else 0)  # all but the examples
    for path in sorted((problem.solutions / "accepted").glob("*.py")):
        if seed == 20261120 and not language_of(path):
            settings = Settings(measured=False)
            result = run_submission(problem, other, path.read_bytes(), path.name, settings=settings)
            assert result.verdict is Verdict.AC, path.name
