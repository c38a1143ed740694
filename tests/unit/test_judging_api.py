"""Judging from Python: results without a word printed, jobs that travel, and the executors that do them."""

from __future__ import annotations

import doctest
import pickle
import re
import shutil
from pathlib import Path

import pytest

import judge
from judge import Job, RunOptions, Session
from judge.errors import JudgeError, ProblemError, UsageError
from judge.judging.api import run
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.run import execute

PACK = Path(__file__).parents[1] / "fixtures" / "pack"
GOOD = "def middle(a, b):\n    return (a + b) / 2\n"
FLOOR = "def middle(a, b):\n    return (a + b) // 2\n"


@pytest.fixture(autouse=True)
def _own_cache(tmp_path_factory, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path_factory.getbasetemp() / "api-cache"))
    monkeypatch.setenv("JUDGE_PROBLEMS", str(PACK / "problems"))


@pytest.fixture
def problem():
    return find_problem("middle")


def test_the_example_of_the_package_is_true():
    ended = doctest.testmod(judge)
    assert (ended.failed, ended.attempted > 5) == (0, True)


@pytest.mark.parametrize(
    ("arguments", "more", "told"),
    [
        (("middle", "alice.py"), {}, "'alice.py' is a file's name, not a program"),
        (("middle", Path("nobody.py")), {}, "cannot be read"),
        (
            ("middle", GOOD),
            {"options": RunOptions(groups=("exampels",))},
            "no group 'exampels'; did you mean 'examples'",
        ),
    ],
)
def test_a_wrong_use_is_told_in_one_line(arguments, more, told):
    with pytest.raises(UsageError, match=told) as fault:
        judge.judge(*arguments, **more)
    assert "\n" not in str(fault.value)


def test_a_notebook_shows_a_result_with_its_drawing_and_nothing_that_runs():
    failed = judge.judge("middle", FLOOR, name="<script>.py", options=RunOptions(timed=False))._repr_html_()
    assert "WA  Wrong answer" in failed
    assert "Smallest failing case" in failed
    assert "&lt;script&gt;.py" in failed
    assert "<script" not in failed
    html = judge.Result(problem="gone", submission="a.py", verdict=Verdict.AC)._repr_html_()
    assert "AC  Accepted" in html
    assert "<svg" not in html


def test_a_notebook_shows_the_drawing_of_a_case(monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS")
    two = "def line_count(cx, cy, r, A, B):\n    return 2\n"
    assert "<svg" in judge.judge("count", two, options=RunOptions(timed=False))._repr_html_()


# -- jobs ------------------------------------------------------------------------------------------------


def test_a_job_and_its_result_can_be_sent_anywhere(problem):
    job = Job.of(problem, FLOOR.encode(), "mine.py", RunOptions(named=False))
    again = pickle.loads(pickle.dumps(job))
    assert (again, again.digest) == (job, job.digest)
    here, there = run(job), run(again)
    assert (there.verdict, there.failure, there.counterexample) == (
        here.verdict,
        here.failure,
        here.counterexample,
    )


@pytest.fixture
def elsewhere(tmp_path):
    """The same problem in another folder."""
    shutil.copytree(PACK, tmp_path / "pack")
    return find_problem("middle", [tmp_path / "pack" / "problems"])


def test_a_digest_stands_for_all_that_the_outcome_depends_on(problem, elsewhere):
    job = Job.of(problem, GOOD.encode(), "mine.py")
    assert Job.of(elsewhere, GOOD.encode(), "mine.py").digest == job.digest
    others = [
        Job.of(problem, FLOOR.encode(), "mine.py"),
        Job.of(problem, GOOD.encode(), "yours.py"),
        Job.of(problem, GOOD.encode(), "mine.py", RunOptions(seed=1)),
        Job.of(problem, GOOD.encode(), "mine.py", RunOptions(("examples",))),
    ]
    with (elsewhere.folder / "statement.md").open("a") as statement:
        statement.write("\nOne more line.\n")
    others.append(Job.of(elsewhere, GOOD.encode(), "mine.py"))
    assert len({job.digest, *(other.digest for other in others)}) == 6


def test_a_job_is_not_done_on_another_version_of_its_problem(elsewhere):
    job = Job.of(elsewhere, GOOD.encode(), "mine.py")
    next((elsewhere.solutions / "wrong").iterdir()).unlink()
    with pytest.raises(JudgeError, match="is not the problem that this job was made for"):
        run(job)


# -- sessions and executors ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("fault", "told"),
    [
        (ProblemError("the reference fails", where="middle/problem.py:9"), "middle/problem.py:9: the ref"),
        (MemoryError(), "there is no memory left; use a smaller -j"),
    ],
)
def test_a_fault_costs_one_submission(fault, told, problem, monkeypatch):
    real = execute.judge_submission

    def faulty(data, source, name, *how, **more):
        if name == "b.py":
            raise fault
        return real(data, source, name, *how, **more)

    monkeypatch.setattr(execute, "judge_submission", faulty)
    with Session(problem, RunOptions(timed=False)) as session:
        results = [session.judge(GOOD.encode(), name) for name in ("a.py", "b.py", "c.py")]
    assert [result.verdict for result in results] == [Verdict.AC, Verdict.JE, Verdict.AC]
    assert results[1].failure.message.startswith(told)


def test_a_level_that_was_had_is_demanded(problem, tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))  # without bubblewrap
    with Session(problem, RunOptions(timed=False), had="full") as session:
        result = session.judge(GOOD.encode(), "mine.py")
    assert result.verdict is Verdict.JE
    assert result.failure.message.startswith("isolation full was had and is now refused: ")


def test_a_submission_sees_neither_problem_nor_solutions_nor_cache(tmp_path, monkeypatch):
    site = tmp_path / "site-packages"
    pack, cache = site / "pack", site / "cache"
    shutil.copytree(PACK, pack)
    (site / "beside.py").write_text("")
    monkeypatch.syspath_prepend(site)  # whose modules a submission may import
    monkeypatch.setenv("JUDGE_CACHE", str(cache))
    files = [pack / "problems/middle/problem.py", pack / "solutions/middle/accepted/mean.py", cache / "data"]
    source = f"""
import os, beside
def seen(path):
    try:  # what is there may be asked for at some levels, what it holds at none
        return bool(os.listdir(path) if os.path.isdir(path) else open(path).read())
    except OSError:
        return False
def middle(a, b):
    return (a + b) / 2, [path for path in {[*map(str, files)]} if seen(path)]
"""
    problem = find_problem("middle", [pack / "problems"])
    with Session(problem, RunOptions(timed=False, named=False)) as session:
        result = session.judge(source.encode(), "mine.py")
    if result.isolation == "limits":
        pytest.skip("there is no sandbox on this machine")
    assert all(file.exists() for file in files)
    assert result.failure.given[1] == []


def test_a_result_is_one_line_where_it_is_shown():
    result = judge.judge("middle", FLOOR, name="mine.py", options=RunOptions(timed=False, diagnosed=False))
    told = r"<Result middle mine\.py: WA, \d+ of 100 points, in \w+, floor-division>"
    assert re.fullmatch(told, repr(result))


def test_the_package_offers_what_it_says():
    assert all(getattr(judge, name) is not None for name in judge.__all__)
    assert {*judge.__all__} >= {"Job", "Result", "RunOptions", "Session", "find_problem", "judge"}
