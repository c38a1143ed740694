"""The history keeps what it was given, and gives it back."""

from __future__ import annotations

import hashlib
import os
from pathlib import Path

import pytest
from past_runs import START, StoppedClock, past_result

from judge.errors import UsageError
from judge.kata.history import Current, History
from judge.problem import Verdict
from judge.run.result import Mode, judge_fault


@pytest.fixture
def history():
    with History.open(clock=StoppedClock()) as history:
        yield history


def test_a_run_comes_back_whole(history):
    result = past_result(passed=("grid",), failed=("tangent",), mistake="no-clamp", ratio=1.25)
    number = history.add(result, b"x = 1\n", "/home/me/mine.py")
    run = history.run(number)
    assert (run.id, run.when, run.problem) == (1, START, "segment")
    assert (run.submission, run.path) == ("mine.py", "/home/me/mine.py")
    assert (run.verdict, run.score, run.mode) == (Verdict.WA, 50, Mode.FUNCTION)
    assert (run.passed, run.failed) == (("grid",), ("tangent",))
    assert (run.mistake, run.ratio) == ("no-clamp", 1.25)
    assert run.source_hash == hashlib.sha256(b"x = 1\n").hexdigest()
    assert run.result == result
    assert history.source(number) == b"x = 1\n"


def test_the_last_runs_are_listed_on_demand_and_names_are_as_the_system_has_them(history):
    for problem in ("count", "segment", "count", "count"):
        history.add(past_result(problem), b"", "")
    assert [run.id for run in history.runs("count", limit=2)] == [3, 4]
    assert history.runs(limit=0) == []
    assert len(history.runs(limit=10**30)) == 4
    history.take_up("segment", os.fsdecode(b"/home/me/\xff.py"))
    assert history.current() == Current("segment", os.fsdecode(b"/home/me/\xff.py"))
    history.see_hints("count", 2)
    history.see_hints("count", 1)
    history.give_up("count")
    assert (history.hints_seen("count"), history.gave_up("count"), history.hints_seen("segment")) == (
        2,
        True,
        0,
    )
    assert [(each.hints, each.gave_up) for each in history.helps("count")] == [
        (2, False),
        (1, False),
        (0, True),
    ]


@pytest.mark.parametrize("number", [0, 2, 2**63])
def test_a_run_that_is_not_there(number, history):
    with pytest.raises(UsageError, match="there are none yet"):
        history.run(number)
    history.add(past_result(), b"", "")
    with pytest.raises(UsageError, match="from 1 to 1"):
        history.source(number)


def test_names_that_no_text_can_hold(history):
    name = os.fsdecode(b"caf\xe9 \x1b[31m\n\xff.py")
    run = history.run(history.add(past_result(name=name), b"\xff\x00", f"/tmp/{name}"))
    assert (run.submission, run.path, run.result.submission) == (name, f"/tmp/{name}", name)


def test_only_a_whole_problem_is_solved(history):
    part = history.add(past_result(passed=("grid",)), b"", "")  # as with --group
    whole = history.add(past_result(), b"", "")
    fault = history.add(judge_fault("segment", "a.py", "?"), b"", "")
    assert [history.run(number).solved for number in (part, whole, fault)] == [False, True, False]
    assert [history.run(number).counts for number in (part, whole, fault)] == [True, True, False]


@pytest.mark.parametrize(
    ("path", "counts"),
    [("", True), ("/judge/solutions/segment/accepted/a.py", False), ("/judge/solutions/segment/a.py", True)],
)
def test_a_problems_own_solution_says_nothing_of_the_person(path, counts, history):
    run = history.run(history.add(past_result("segment"), b"", path))
    assert (run.counts, run.solved, run.whole) == (counts, counts, True)


def test_it_is_where_the_settings_say(monkeypatch, tmp_path, own_history):
    with History.open() as history:
        assert history.path == own_history
    with History.open(tmp_path / "a" / "b" / "other ?#%.db") as history:
        history.add(past_result(), b"", "")
    assert (tmp_path / "a" / "b" / "other ?#%.db").is_file()
    monkeypatch.delenv("JUDGE_DB")
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    with History.open() as history:
        assert history.path.is_relative_to(tmp_path)
        assert history.path.name == "history.sqlite3"
        assert history.path.is_file()


def test_reading_makes_no_file(own_history):
    with History.open(reading=True) as history:
        assert history.runs() == []
        assert history.current() is None
    assert not Path(own_history).parent.exists()
