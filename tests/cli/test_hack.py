"""`judge hack`: what its wrong programs are, what is kept of them, and a terminal that asks for cases.

What it says is in the transcripts of `hack/`.
"""

from __future__ import annotations

import ast
import statistics

import pytest
from cli_support import ROOT
from sampling import daily
from terminals import on_a_terminal

from judge.data.load import load_data
from judge.mistakes.computed import ComputedProgram, Computer
from judge.mistakes.killing import Jury
from judge.mistakes.puzzles import HACKED, read_puzzles
from judge.practice.events import Hack, Outcome
from judge.practice.history import History
from judge.practice.syllabus import read_checklist
from judge.problem.find import find_problem, problem_folders

pytestmark = pytest.mark.slow

SHIPPED = sorted(
    folder.name
    for folder in problem_folders()
    if folder.parent.parent == ROOT and find_problem(folder.name).parameters
)


@pytest.mark.parametrize("name", daily(SHIPPED, ("diameter",)))
def test_what_is_shown_is_the_wrong_program(name):
    problem = find_problem(name)
    computer = Computer(load_data(problem))
    for puzzle in read_puzzles(problem, read_checklist().drilled())[:HACKED]:
        if puzzle.trusted:
            known = computer.behaviour(ComputedProgram(puzzle.known.encode(), "known", trusted=True))
            shown = computer.behaviour(ComputedProgram(puzzle.source, "shown", trusted=True))
            assert shown == known, puzzle.mistake
            assert any(each.wrong for each in shown.values()), puzzle.mistake


@pytest.mark.parametrize(("name", "lines"), [("count", 15), ("segment", 26), ("ray-nearest", 33)])
def test_what_is_shown_is_short_and_of_the_topics_first(name, lines):
    drilled = read_checklist().drilled()
    puzzles = read_puzzles(find_problem(name), drilled)
    topical = [each.mistake in drilled for each in puzzles]
    assert topical[0]
    assert topical == sorted(topical, reverse=True)
    assert statistics.median(each.source.count(b"\n") for each in puzzles[:HACKED]) <= lines


def test_twelve_are_asked_and_all_if_that_is_said(judge):
    assert "wrong program 1 of 12, 0 broken" in judge("hack", "count").out
    names = [each.mistake for each in read_puzzles(find_problem("count"), read_checklist().drilled())]
    with History() as history:
        for name in names[:HACKED]:
            history.keep(Hack("count", name, "", Outcome.WON))
    assert f"All are broken. {len(names) - HACKED} more: judge hack count --all" in judge("hack", "count").out
    assert f"wrong program 13 of {len(names)}, 12 broken" in judge("hack", "count", "--all").out
    assert judge("hack", "count", "14").out == judge("hack", "count", names[13]).out


@pytest.mark.parametrize("name", daily(SHIPPED, ("diameter",)))
def test_a_shipped_problem_has_its_puzzles(name):
    problem = find_problem(name)
    puzzles = read_puzzles(problem)
    assert len(puzzles) >= 10
    assert [puzzle.number for puzzle in puzzles] == list(range(1, len(puzzles) + 1))
    for puzzle in puzzles:
        text = puzzle.source.decode()
        bodies = [node.body for node in ast.walk(ast.parse(text)) if isinstance(node, ast.FunctionDef)]
        assert not any(isinstance(each, ast.Pass) for body in bodies if len(body) > 1 for each in body)
        blocks = [getattr(node, "body", None) for node in ast.walk(ast.parse(text))]
        above = [each for block in blocks if isinstance(block, list) for each in block[:-1]]
        assert not any(isinstance(each, ast.Return | ast.Raise | ast.Continue) for each in above), text
        assert "#" not in text.replace("'#'", "")
        assert puzzle.mistake not in text
        assert "right_way" not in text
        assert f"def {problem.entry}(" in text or "input(" in text or "stdin" in text


def test_a_terminal_asks_until_it_is_broken():
    status, written = on_a_terminal("hack", "middle", "1", typed="nonsense\n1 1\n1 2\n", NO_COLOR="1")
    assert status == 0
    for part in ("case> ", "not a value of a", "LOST  the program", "WON  broken, 1 of 1"):
        assert part in written


# -- the jury of `test-writer`: which wrong programs a list of cases breaks ---------------------------------


@pytest.fixture(scope="module")
def jury():
    return Jury(find_problem("segment"), {"ends": ["no-clamp", "open-interval"], "one": ["zero-radius"]})


INSIDE = (0, 0, 5, (0, 0), (9, 1))
ON_AN_END = (0, 0, 5, (3, 4), (9, 12))


@pytest.mark.parametrize(
    ("cases", "family", "why"),
    [
        ([INSIDE, ON_AN_END], "ends", None),
        ([INSIDE], "ends", "1 of 2 wrong programs found out, 2 needed; not "),
        ([INSIDE, ON_AN_END], "one", "0 of 1 wrong programs found out, 1 needed; not zero-radius"),
        ([(0, 0, -1, (0, 0), (9, 1))], "no family", "case 1 is not a case of segment: r has -1"),
        ([INSIDE, (0, 0, 1, (-2, 1 + 1e-9), (2, 1 + 1e-9))], "ends", "case 2 is not a case of segment: "),
    ],
)
def test_what_the_jury_says(jury, cases, family, why):
    said = jury.why_not(cases, family)
    assert said is None if why is None else why in said
