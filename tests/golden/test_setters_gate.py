"""Every problem that comes with the judge passes the setter's gate, whatever was added beside it."""

from __future__ import annotations

from pathlib import Path

import pytest

from judge.data import load_data
from judge.languages import language_of
from judge.mistakes.verified import verify_choices
from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.run import Settings, run_submission
from judge.run.verify import fresh_data, verify_problem
from judge.sandbox import Boxes

pytestmark = pytest.mark.slow

PROBLEMS = Path(__file__).parents[2] / "problems"


@pytest.fixture(scope="module", params=sorted(path.parent.name for path in PROBLEMS.glob("*/problem.toml")))
def problem(request):
    return load_problem(PROBLEMS / request.param)


def test_everything_the_setters_gate_asks(problem):
    data = fresh_data(problem)
    found = verify_choices(problem, data, Boxes())
    report = verify_problem(found.problem, made=found.made, data=data)
    assert [str(fault) for fault in (*report.faults, *found.faults)] == []
    assert report.pins == "matching"


def test_accepted_solutions_pass_with_another_seed(problem):
    """By their answers: their time is measured on the pinned data, by the gate."""
    settings = Settings(measured=False)
    data = load_data(problem, seed=20261120, cache=False)
    for path in sorted((problem.solutions / "accepted").glob("*.py")):
        if language_of(path):
            continue
        result = run_submission(problem, data, path.read_bytes(), path.name, settings=settings)
        assert result.verdict is Verdict.AC, path.name
