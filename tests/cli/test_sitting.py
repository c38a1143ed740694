"""What is kept between two saves of a watched file, and when nothing is."""

from __future__ import annotations

import shutil
from contextlib import closing

import pytest

from judge.cli.judging import Sitting
from judge.cli.submissions import Submission
from judge.cli.wish import Wish
from judge.errors import ProblemError
from judge.judging.job import Terms
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.problem.load import load_problem
from judge.sandbox import factory

pytestmark = pytest.mark.slow

WISH = Wish(Terms(), kept=False)


@pytest.fixture
def started(monkeypatch):
    """The names of the files whose containers were started."""
    names = []
    usual = factory.Boxes.__call__

    def start(self, source, name):
        names.append(name)
        return usual(self, source, name)

    monkeypatch.setattr(factory.Boxes, "__call__", start)
    return names


@pytest.fixture
def problem(tmp_path):
    """A problem of one's own, with its solutions."""
    shipped = find_problem("which-side", [])
    shutil.copytree(shipped.folder, tmp_path / "problems" / "which-side")
    shutil.copytree(shipped.solutions, tmp_path / "solutions" / "which-side")
    return load_problem(tmp_path / "problems" / "which-side")


def solution(problem, name):
    return (problem.solutions / "accepted" / name).read_bytes()


def verdict(sitting, source):
    return sitting.judged(Submission("mine.py", source)).result.verdict


def test_the_reference_is_started_once_and_the_data_are_read_once(problem, started):
    reference = problem.time.function
    right = solution(problem, reference)
    with closing(Sitting(problem, WISH)) as sitting:
        first = sitting.judged(Submission("mine.py", right))
        assert (started.count("mine.py"), started.count(reference)) == (1, 1)
        second = sitting.judged(Submission("mine.py", right + b"#"))
        assert (started.count("mine.py"), started.count(reference)) == (2, 1)
    assert first.data is second.data
    assert first.result.verdict is second.result.verdict is Verdict.AC


def test_a_problem_that_has_changed_is_read_again(problem):
    right = solution(problem, problem.time.function)
    with closing(Sitting(problem, WISH)) as sitting:
        before = sitting.judged(Submission("mine.py", right)).data
        (problem.folder / "problem.py").write_text("raise RuntimeError('half written')\n")
        with pytest.raises(ProblemError, match="half written"):
            verdict(sitting, right)
        shutil.copy(find_problem("which-side", []).folder / "problem.py", problem.folder)
        after = sitting.judged(Submission("mine.py", right))
    assert after.data is not before
    assert after.result.verdict is Verdict.AC
