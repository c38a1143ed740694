"""The table of a class at any width, and the line that says how far it is."""

from __future__ import annotations

import io
import sys

import msgspec
import pytest

from judge.batch.model import Done, Row, Student
from judge.batch.outcome import Outcome, counting
from judge.batch.table import table_lines
from judge.cli.classroom import clock
from judge.errors import ExitCode
from judge.report.layout import cells
from judge.report.live import Live


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


def test_signs_say_what_a_cell_does_not():
    rows = (
        row("ada", "a", "AC", 100, busy="load 9.0 on 2 cores"),
        row("ada", "b", copied="bob/b.py"),
        row("bob", "a", "WA", 0),
        row("bob", "a", "TLE", 60, at=2.0, where=("lab2", "strong")),
        row("bob", "b", "JE", 0, where=("", "")),
    )
    outcome = Outcome((Student("ada"), Student("bob", known=False), Student("cy")), ("a", "b"), rows, left=2)
    lines = text(outcome)
    assert [line.split() for line in lines[:4]] == [
        ["a", "b", "solved", "points"],
        ["ada", "AC", "100~", "WA", "40=", "1", "of", "2", "140"],
        ["bob?", "TLE", "60+a", "JE", "0", "of", "2", "60"],
        ["cy", "–", "–", "0", "of", "2", "0"],
    ]
    heads = zip(lines[:4], ("solved", "1 of", "0 of", "0 of"), strict=True)
    assert len({line.index(word) for line, word in heads}) == 1
    assert "judged with full isolation on lab1" in lines
    assert "a strong isolation on lab2" in lines
    assert "bob/b-1.py: why" in lines
    assert lines[-1] == "1 of 4 accepted, 3 students, 2 problems; 2 files left to judge"
    assert outcome.exit_code is ExitCode.FAULT


def test_the_best_counts_and_the_newest_of_equals():
    rows = [row("a", "p", "WA", 70), row("a", "p", "JE", 0, at=3.0), row("a", "p", "RTE", 70, at=2.0)]
    assert counting(rows)["a", "p"] == rows[2]
    accepted = row("a", "p", "AC", 60, at=0.5)
    assert counting([accepted, *rows])["a", "p"] == accepted
    assert Outcome((), ("p",), (accepted, *rows)).exit_code is ExitCode.ACCEPTED
    assert Outcome((), ("p",), tuple(rows)).exit_code is ExitCode.NOT_ACCEPTED
    assert Outcome((), ("p",), (accepted,), left=1).exit_code is ExitCode.NOT_ACCEPTED
    assert text(Outcome((), (), ())) == ["0 of 0 accepted, 0 students, 0 problems"]


class Terminal(io.StringIO):
    def isatty(self):
        return True


def shown(stream, monkeypatch, ticks, texts, **settings):
    monkeypatch.setattr(sys, "stderr", stream)
    for name, value in settings.items():
        monkeypatch.setenv(name, value)
    times = iter(ticks)
    with Live(clock=lambda: next(times)) as live:
        for each in texts:
            live.show(lambda each=each: each)
    return stream.getvalue()


def test_a_terminal_has_one_line_that_goes(monkeypatch):
    written = shown(
        Terminal(), monkeypatch, [0, 0.01, 1], ["one", "soon", "x" * 60], COLUMNS="20", TERM="xterm"
    )
    assert written == "\r\x1b[Kone" + "\r\x1b[K" + "x" * 18 + "…" + "\r\x1b[K"


@pytest.mark.parametrize(("stream", "term"), [(io.StringIO, "xterm"), (Terminal, "dumb")])
def test_a_log_has_a_line_now_and_then(monkeypatch, stream, term):
    written = shown(stream(), monkeypatch, [0, 1, 31, 32, 90], ["a", "b", "c", "d"], TERM=term, NO_COLOR="1")
    assert written == "judge: b\njudge: d\n"
    assert [clock(each) for each in (0.4, 32, 725, 3850)] == ["0:00", "0:32", "12:05", "1:04:10"]
