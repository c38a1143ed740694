"""The table of a class at any width, and the line that says how far it is."""

from __future__ import annotations

import msgspec
import pytest

from judge.batch.model import Done, Row, Student
from judge.batch.outcome import Outcome, counting
from judge.batch.table import table_lines
from judge.errors import ExitCode
from judge.report.layout import cells


def row(student, problem, verdict="WA", score=40, where=("lab1", "full"), at=1.0, copied="", **done):
    file = f"{student}/{problem}-{at:g}.py"
    plain = msgspec.json.encode(Done({"failure": {"message": "why"}}, **done)).decode()
    key = f"{file}{verdict}"
    return Row(key, student, problem, file, "d", verdict, score, 100, "", *where, at, copied, plain)


def text(outcome, width=80):
    return ["".join(span.text for span in line) for line in table_lines(outcome, width)]


@pytest.mark.parametrize("width", [40, 80, 200])
def test_thirty_students_and_twenty_problems_fit_any_screen(width):
    students = [Student(f"student-with-a-long-name-{at:02}") for at in range(30)]
    problems = [f"problem-number-{at:02}" for at in range(20)]
    rows = [row(each.id, problem, "AC", 100) for each in students for problem in problems]
    outcome = Outcome(tuple(students), tuple(problems), tuple(rows))
    lines = text(outcome, width)
    assert max(map(cells, lines)) <= width
    assert sum(line.count("AC 100") for line in lines) == 600
    assert all(sum(f"{at:02}" in line for line in lines) for at in range(20))
    assert sum("20 of 20  2000" in line for line in lines) == 30
    assert max(line.count("AC 100") for line in text(outcome, None)) == 20


def test_the_best_counts_and_the_newest_of_equals():
    rows = [row("a", "p", "WA", 70), row("a", "p", "JE", 0, at=3.0), row("a", "p", "RTE", 70, at=2.0)]
    assert counting(rows)["a", "p"] == rows[2]
    accepted = row("a", "p", "AC", 60, at=0.5)
    assert counting([accepted, *rows])["a", "p"] == accepted
    assert Outcome((), ("p",), (accepted, *rows)).exit_code is ExitCode.ACCEPTED
    assert Outcome((), ("p",), tuple(rows)).exit_code is ExitCode.NOT_ACCEPTED
    assert Outcome((), ("p",), (accepted,), left=1).exit_code is ExitCode.NOT_ACCEPTED
    assert text(Outcome((), (), ())) == ["0 of 0 accepted, 0 students, 0 problems"]
