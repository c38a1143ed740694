"""The path has katas and skills by the dozen: what `judge progress` and `judge practice` show of it."""

from __future__ import annotations

from datetime import UTC, datetime

from judge.kata.history import History
from judge.kata.sets import find_set
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.run.result import GroupResult, Mode, Result

START = datetime(2026, 11, 20, tzinfo=UTC)
SETS = ["first-steps", "junior", "middle", "senior", "professional"]


def every(name):
    """The groups of a problem."""
    return find_problem(name).groups


def keep(*problems, without=()):
    """A run of each that passed all its groups but these."""
    with History.open(clock=lambda: START) as history:
        for name in problems:
            verdicts = [(group, Verdict.WA if group.name in without else Verdict.AC) for group in every(name)]
            groups = tuple(
                GroupResult(group.name, verdict, 9, 9, None, 0.0, group.points) for group, verdict in verdicts
            )
            worst = Verdict.WA if without else Verdict.AC
            history.add(Result(name, "a.py", Mode.FUNCTION, worst, groups), name.encode(), f"/{name}.py")


def table(lines):
    """The rows of the sets, by name, as words."""
    rows = [line.split() for line in lines if line.split()[:1] and line.split()[0] in SETS]
    return {row[0]: " ".join(row[1:]) for row in rows}


def test_progress_of_the_path_is_a_row_a_set(judge):
    steps = len(find_set("first-steps").problems)
    shown = judge("progress")
    assert [*table(shown.lines)] == SETS
    assert table(shown.lines)["first-steps"] == f"0 of {steps} 0 of 6"
    assert "close the loop" not in shown.out  # a skill
    assert "judge progress SET lists its skills and katas" in shown.out
    assert len(shown.lines) < 36
    keep("diameter", "chord")
    rows = table(judge("progress").lines)
    assert rows["first-steps"] == f"1 of {steps} 1 of 6"
    katas = len(find_set("junior").problems)
    assert rows["junior"].startswith(f"1 of {katas} 1 of {katas} 1 of {katas} ")


def test_a_lost_skill_stands_out(judge):
    keep("diameter")
    first = find_problem("diameter").groups[-1].name
    keep("diameter", without=(first,))
    (said,) = [line for line in judge("progress").lines if line.startswith("  lost  ")]
    assert f"fails diameter {first}" in said


def test_all_of_it_is_there_for_the_asking(judge):
    shown = judge("progress", "--all")
    assert "close the loop" in shown.out
    assert "interview level" in shown.out
    assert len(judge("progress", "junior").lines) > len(table(judge("progress").lines))


def test_practice_shows_what_is_near(judge, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    keep("distance-squared", "which-side", "csg")
    keep("adaptive", without=("examples",))
    shown = judge("practice")
    rows = [line.split()[0] for line in shown.lines if " new" in line or "tried" in line]
    assert rows[0] == "circle-side"
    assert (len(rows), rows[-1]) == (9, "adaptive")
    assert "  passed  distance-squared, which-side, csg" in shown.lines
    count = len(find_set("path").problems) - 3 - 9
    assert f"  later   {count} more katas; judge list has them all" in shown.lines
    assert len(shown.lines) <= 23


def test_a_short_set_is_shown_whole(judge, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shown = judge("practice", "junior")
    names = [problem.id for problem in find_set("junior").problems]
    assert all(any(line.startswith(f"  {name} ") for line in shown.lines) for name in names)
    assert "later" not in shown.out


def test_columns_without_anything_are_left_out(judge, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert "since" not in judge("practice").out + judge("progress").out
    keep("diameter")
    keep("crossings", without=("examples",))
    (head,) = [line.split() for line in judge("practice").lines if line.startswith("  kata ")]
    assert head == ["kata", "state", "since", "tries", "best", "title"]


def test_why_explains_a_mistake_once(judge):
    lines = judge("why", "test-writer").lines
    assert sum("An empty list is returned." in line for line in lines) == 1
    again = [line for line in lines if line.startswith("    again  ")]
    assert len(again) == len(find_problem("test-writer").groups) - 1
    assert all("no-tests" in line for line in again)
    alone = judge("why", "test-writer", "scale").out
    assert "An empty list is returned." in alone
    assert "again" not in alone
    assert len(lines) < 60
