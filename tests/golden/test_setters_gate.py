"""Every problem that comes with the judge passes the setter's gate, whatever was added beside it."""

from __future__ import annotations

from pathlib import Path

import pytest

from judge.data import load_data
from judge.mistakes.verified import verify_choices
from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.run import run_submission
from judge.run.verify import verify_problem
from judge.sandbox import Boxes

pytestmark = pytest.mark.slow

PROBLEMS = Path(__file__).parents[2] / "problems"


@pytest.fixture(scope="module", params=sorted(path.parent.name for path in PROBLEMS.glob("*/problem.toml")))
def problem(request):
    return load_problem(PROBLEMS / request.param)


def test_everything_the_setters_gate_asks(problem):
    found = verify_choices(problem, load_data(problem), Boxes())
    report = verify_problem(found.problem, made=found.made)
    assert [str(fault) for fault in (*report.faults, *found.faults)] == []
    assert report.pins == "matching"


def test_accepted_solutions_pass_with_another_seed(problem):
    data = load_data(problem, seed=20261120, cache=False)
    for path in sorted((problem.solutions / "accepted").glob("*.py")):
        result = run_submission(problem, data, path.read_bytes(), path.name, groups=None, on_progress=None)
        assert result.verdict is Verdict.AC, path.name
