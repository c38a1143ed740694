"""`judge hack`: a wrong program, a case that breaks it, and what is kept of it."""

from __future__ import annotations

import ast
import io
import json
import os
import subprocess
import sys

import pytest
from cli_support import ROOT

from judge.kata.hacks import Hack, HackState, Outcome, broken, hack_shares, hack_states
from judge.kata.history import History
from judge.mistakes.makers import read_makers
from judge.mistakes.puzzles import read_puzzles, without_pass
from judge.problem.find import find_problem, problem_folders
from judge.sandbox import levels

BEST = next(level.name for level in levels() if level.available)
SHOWN = """\
count  wrong program 2 of 41, 0 broken

from math import hypot


def line_count(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    bx, by = B[0] - cx, B[1] - cy
    extent = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    near = 1e-10 * extent
    dx, dy = B[0] - A[0], B[1] - A[1]
    length = hypot(dx, dy)
    if length == 0:
        return None
    k = dx * ay - dy * ax
    d = k / length
    if d > r + near:
        return 0
    return 1 if d >= r - near else 2

It answers some case wrongly. Give one that keeps the statement's bounds and
promise:
  judge hack count 2 "cx, cy, r, A, B"
"""
WON = """\
  input       cx=0, cy=0, r=1, A=(-1, -1), B=(1, -1)
  as a line   0 0 1 -1 -1 1 -1
  wanted      1
  got         2
  why         1 wanted, 2 given

  forgotten-abs
    The distance is a cross product with its sign, and on one side of the line
    it is negative: every circle there is met. Take its absolute value before
    you compare it with the radius.

WON  broken, 1 of 41 programs of count; next: judge hack count 1
"""
LOST = """\
  input       cx=0, cy=0, r=1, A=(-1, 1), B=(1, 1)
  as a line   0 0 1 -1 1 1 1
  wanted      1
  got         1

LOST  not broken: the program answers this case rightly
  more        judge hack count 2 shows it again, with --give-up a case and its
              name
"""
BREAKS = "0, 0, 1, (-1, -1), (1, -1)"


@pytest.fixture(autouse=True)
def _eighty(monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")


def test_the_screens_fit_24_rows(judge):
    ended = judge("hack", "count", "2")
    assert (ended.status, ended.out, ended.err) == (0, SHOWN, "")
    assert len(ended.lines) <= 23
    ended = judge("hack", "count", "2", "0 0 1 -1 1 1 1")
    assert (ended.status, ended.out, ended.err) == (1, LOST, "")
    ended = judge("hack", "count", "2", BREAKS)
    assert (ended.status, ended.out, ended.err) == (0, WON, "")


@pytest.mark.parametrize(
    "words",
    [
        ("2", BREAKS),
        ("2", *["0", "0", "1", "-1", "-1", "1", "-1"]),
        ("forgotten-abs", "line_count(0, 0, 1, A=(-1, -1), B=(1, -1))"),
        ("2", "-"),
    ],
)
def test_a_case_in_every_form(judge, words, monkeypatch):
    monkeypatch.setattr(sys, "stdin", io.StringIO(f"{BREAKS}\n"))
    (line,) = judge("hack", "count", *words, "--json").lines
    found = json.loads(line)
    assert (found["outcome"], found["state"], found["mistake"]) == ("won", "broken", "forgotten-abs")
    assert found["case"] == {
        "input": {"cx": 0, "cy": 0, "r": 1, "A": [-1, -1], "B": [1, -1]},
        "line": "0 0 1 -1 -1 1 -1",
        "expected": "1",
        "got": "2",
        "message": "1 wanted, 2 given",
        "verdict": "WA",
        "isolation": BEST,
    }


def test_a_line_that_begins_like_a_number_of_a_program(judge):
    (line,) = judge("hack", "count", *["2", "0", "1", "-1", "1", "1", "1"], "--json").lines
    assert (json.loads(line)["number"], json.loads(line)["case"]["line"]) == (1, "2 0 1 -1 1 1 1")


@pytest.mark.parametrize(
    ("case", "why"),
    [
        ("0 0 -1 0 0 1 1", "this is no case of count: r has -1, outside 0 to 1073741824"),
        ("0, 0, 1, (-1, 1.00000001), (1, 1.00000001)", "inside the forbidden band"),
    ],
)
def test_a_case_against_bounds_or_promise_is_lost_and_says_where(judge, own_history, case, why):
    found = json.loads(judge("hack", "count", "2", case, "--json").out)
    assert (found["outcome"], found["state"], found["case"], found["mistake"]) == ("lost", "open", None, None)
    assert why in found["why"]
    assert not own_history.exists()  # it says nothing of the person


def test_nothing_is_told_of_the_mistake_before_it_is_broken(judge):
    puzzles = read_puzzles(find_problem("count"))
    listed = judge("hack", "count", "--list").out
    assert not [puzzle.mistake for puzzle in puzzles if puzzle.mistake in listed]
    for words in (["2"], ["2", "0 0 1 -1 1 1 1"]):
        ended = judge("hack", "count", *words, "--json")
        assert "abs-distance" not in ended.out
        assert "forgotten" not in ended.out
    judge("hack", "count", "2", BREAKS)
    listed = judge("hack", "count", "--list").lines
    assert listed[3].split() == ["2", "broken", "forgotten-abs"]
    assert [line.split() for line in listed[5:]] == [
        ["open", "1,", "3", "to", "41"],
        ["next", *["judge", "hack", "count", "1", "shows", "the", "first", "of", "them"]],
    ]


def test_given_up_it_shows_a_case_which_then_does_not_count(judge):
    ended = judge("hack", "count", "2", "--give-up")
    assert (ended.status, ended.err) == (1, "")
    assert "  forgotten-abs" in ended.lines
    shown = next(row for row in ended.lines if "as a line" in row).split("line")[1].strip()
    again = json.loads(judge("hack", "count", "2", shown, "--json").out)
    assert (again["outcome"], again["state"]) == ("lost", "given-up")
    assert again["why"] == "this is the case that was shown when it was given up"
    another = json.loads(judge("hack", "count", "2", BREAKS, "--json").out)
    assert (another["outcome"], another["state"]) == ("won", "broken")


def test_progress_shows_the_share(judge):
    assert "hacks" not in judge("progress").out
    judge("hack", "count", "2", BREAKS)
    judge("hack", "count", "3", BREAKS)
    assert "  hacks     wrong programs broken: count 1 of 41" in judge("progress").lines
    (share,) = json.loads(judge("progress", "--json").out)["hacks"]
    assert (share["problem"], share["programs"], list(share["broken"])) == ("count", 41, ["forgotten-abs"])


def test_the_api_for_the_checklist(own_history):
    problem = find_problem("count")
    with History.open() as history:
        history.add_hack("count", "forgotten-abs", "a", Outcome.GIVEN_UP)
        history.add_hack("count", "forgotten-abs", "a", Outcome.WON)
        history.add_hack("count", "equality", "b", Outcome.LOST)
        history.add_hack("count", "no-such-mistake", "c", Outcome.WON)
        hacks = history.hacks("count")
        assert history.hacks("segment") == []
        assert broken(hacks) == {"no-such-mistake": hacks[-1].when}
        assert hack_states(["forgotten-abs", "equality"], hacks) == {
            "forgotten-abs": HackState.GIVEN_UP,
            "equality": HackState.OPEN,
        }
        assert [dict(share.broken) for share in hack_shares([problem], hacks)] == [{}]
        history.add_hack("count", "forgotten-abs", "d", Outcome.WON)
        (share,) = hack_shares([problem], history.hacks())
        assert list(share.broken) == ["forgotten-abs"]
    assert isinstance(hacks[0], Hack)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("count", "nothing"), "count has no wrong program 'nothing'; they are numbered from 1 to 41"),
        (("count", "forgoten-abs"), "did you mean 'forgotten-abs'?"),
        (("count", "42", BREAKS), "count has no wrong program '42'"),
        (("count", "2", "0 0 1"), "this is no case of count: the line ends before A is whole"),
        (("count", "2", "--lst"), "no such option '--lst'; see 'judge hack --help'"),
        (("cuont",), "did you mean 'count'?"),
    ],
)
def test_what_cannot_be_done_is_one_line(judge, words, told):
    ended = judge("hack", *words)
    assert (ended.status, ended.out, len(ended.err.splitlines())) == (2, "", 1), ended
    assert told in ended.err


@pytest.mark.parametrize(
    "name",
    sorted(
        folder.name
        for folder in problem_folders()
        if folder.parent.parent == ROOT and find_problem(folder.name).parameters
    ),
)
def test_every_shipped_problem_has_its_puzzles(name):
    problem = find_problem(name)
    if not problem.parameters:
        pytest.skip("there is no case to give")
    puzzles = read_puzzles(problem)
    makers = read_makers(problem).all
    assert len(puzzles) >= 10
    assert [puzzle.number for puzzle in puzzles] == list(range(1, len(puzzles) + 1))
    for puzzle in puzzles:
        text = puzzle.source.decode()
        shown = ast.dump(ast.parse(text))
        bodies = [node.body for node in ast.walk(ast.parse(text)) if isinstance(node, ast.FunctionDef)]
        assert not any(isinstance(each, ast.Pass) for body in bodies if len(body) > 1 for each in body)
        assert "#" not in text.replace("'#'", "")
        assert puzzle.mistake not in text
        assert "right_way" not in text
        assert f"def {problem.entry}(" in text or "input(" in text or "stdin" in text
        if puzzle.source.count(b"def ") == 1:  # the function is that of the mistake, but for its docstring
            named = [maker for maker in makers if maker.name == puzzle.mistake]
            whole = [ast.parse(without_pass(maker.program.source.decode())) for maker in named]
            assert any(_entry(tree, problem.entry) in shown for tree in whole)


@pytest.mark.parametrize("words", [[], ["1"], ["1", ""], ["1", "0"], ["--list"]])
def test_what_is_called_with_nothing_has_no_case_to_give(judge, words):
    told = judge("hack", "test-writer", *words)
    assert (told.status, told.out) == (2, "")
    assert told.err.startswith("judge: test-writer has no wrong programs to break")


def _entry(tree, name):
    (function,) = [node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == name]
    if isinstance(function.body[0], ast.Expr):
        del function.body[0]
    return ast.dump(function)


def test_a_terminal_asks_until_it_is_broken(process, own_history):
    from test_run_screen import _everything

    pty = pytest.importorskip("pty")
    ours, theirs = pty.openpty()
    environment = {**os.environ, "TERM": "xterm-256color", "PYTHONPATH": str(ROOT), "NO_COLOR": "1"}
    command = [sys.executable, "-m", "judge", "hack", "count", "2"]
    with subprocess.Popen(command, stdin=theirs, stdout=theirs, stderr=theirs, env=environment) as running:
        os.close(theirs)
        os.write(ours, b"nonsense\n0 0 1 -1 1 1 1\n0 0 1 -1 -1 1 -1\n")
        written = _everything(ours)
        assert running.wait(timeout=60) == 0
    os.close(ours)
    for part in ("case> ", "this is no case of count", "LOST  not broken", "WON  broken, 1 of 41"):
        assert part in written


def test_given_up_the_case_is_drawn_on_a_screen(own_history):
    from test_run_screen import on_a_terminal

    status, written = on_a_terminal("hack", "segment", "3", "--give-up", NO_COLOR="1")
    assert status == 1
    assert "o wanted" in written
    assert "x got" in written
    shown = written[written.index("  input  ") :]  # where data are built, a bar was drawn and taken away
    assert len(shown.splitlines()) <= 23


def test_every_program_is_broken_by_a_case_of_the_data(judge):
    """Of one small problem here; `judge verify` holds all mistakes against their groups."""
    problem = find_problem("diameter")
    for puzzle in read_puzzles(problem):
        found = json.loads(judge("hack", "diameter", str(puzzle.number), "--give-up", "--json").out)
        assert found["case"]["verdict"] != "AC", puzzle.mistake
        assert found["mistake"] == puzzle.mistake
