"""Judging a submission that reads a whole group and prints a line a case."""

from __future__ import annotations

import pytest
from judging import CASES, judged, make_data

from judge.problem import Verdict
from judge.report.places import fault_place
from judge.run import Mode, budget, program
from judge.run.program import answer_lines, render_group

PROGRAM = """
import sys
lines = sys.stdin.read().splitlines()
assert len(lines) == 1 + int(lines[0])
for line in lines[1:]:
    n, x, y = map(float, line.split())
    print(int(n + x + y))
"""


PROBLEM = make_data("one").problem


def test_a_group_as_standard_input():
    assert render_group(PROBLEM, CASES) == b"4\n1 0 0\n0 0.5 0.5\n2 -1 1\n0 0 0\n"
    assert render_group(PROBLEM, [(10**40, (5e-324, -0.0))]) == b"1\n" + b"1" + b"0" * 40 + b" 5e-324 -0.0\n"


@pytest.mark.parametrize(
    ("stdout", "complete", "lines"),
    [
        (b"1\n2\n", True, ["1", "2"]),
        (b"1\r\n2", True, ["1", "2"]),
        (b"1\n2", False, ["1"]),
        (b"1\n\n2\n \n\n", True, ["1", "", "2"]),
        (b"", True, []),
        (b"\xff\n", True, ["\ufffd"]),
    ],
)
def test_lines_of_an_output(stdout, complete, lines):
    assert answer_lines(stdout, complete=complete) == lines


def test_too_few_and_too_many_lines():
    few = judged(PROGRAM.replace("lines[1:]", "lines[1:3]"))
    assert (few.verdict, few.failure.case, few.groups[0].passed) == (Verdict.WA, 3, 2)
    assert few.failure.message.startswith("2 lines printed, 4 wanted: one for each case")
    many = judged(PROGRAM + "print('done')")
    assert (many.verdict, many.failure.case, many.groups[0].passed) == (Verdict.WA, 4, 3)
    assert many.failure.got == "more lines: 'done'"


@pytest.mark.parametrize(
    ("source", "case", "message"),
    [
        (PROGRAM.replace("    print", "    1 / (n - 2)\n    print"), 3, "float division by zero (line 7)"),
        ("print(1, flush=True)\n1 / 0", 2, "division by zero (line 2), after 1 line of 4"),
    ],
)
def test_a_program_that_breaks_is_shown_the_case_it_breaks_at_or_the_line_it_came_to(source, case, message):
    result = judged(source)
    assert (result.verdict, result.failure.case) == (Verdict.RTE, case)
    assert result.failure.message.startswith(f"ZeroDivisionError: {message}")


def test_the_search_for_the_case_has_an_end(monkeypatch):
    """It breaks at once when all cases are there, and takes its time when it is run on fewer."""
    monkeypatch.setattr(budget, "SEARCH_SECONDS", 0.2)
    rendered = []
    monkeypatch.setattr(
        program, "render_group", lambda *given: rendered.append(given) or render_group(*given)
    )
    body = "import time\ncount = int(input())\nwhile count < 4 and time.process_time() < 0.4: pass\n1 / 0\n"
    result = judged(body, make_data(*"abcdefgh"))
    assert {group.verdict for group in result.groups} == {Verdict.RTE}
    assert len(rendered) == 8 + 1


READ = "0 lines printed, 4 wanted: one for each case"
TAKEN = f"{READ}; it was run as a program because it defines no answer"


@pytest.mark.parametrize(
    ("source", "message"),
    [
        ("\n\ndef anwser(n, P):\n    return 1\n", f"{TAKEN}; is anwser (line 3) meant to be it?"),
        ("anwser = 7", f"{TAKEN}; is anwser (line 1) meant to be it?"),
        ("anwser = input()", READ),  # a program that reads is not told about functions
        ("pass", TAKEN),
        (
            "class Solution:\n    def answer(self, n, P):\n        return 1\n",
            f"{TAKEN} at its top level: move it out of the class or function it stands in",
        ),
    ],
)
def test_what_prints_nothing_is_told_what_it_was_taken_for(source, message):
    result = judged(source)
    assert (result.verdict, result.mode, result.failure.message) == (Verdict.WA, Mode.PROGRAM, message)


def test_a_flood_of_lines_is_a_flood_whatever_the_lines_are():
    result = judged("input()\nwhile True: print(1)")
    assert (result.verdict, result.failure.message) == (Verdict.OLE, "wrote more than 1 MB")


FORM = "; its input is a line with the number of cases, then one line each: n px py, here "


@pytest.mark.parametrize(
    ("reading", "what"),
    [
        ("n = int(input())", "ValueError: invalid literal for int() with base 10: "),
        ("n, x = input().split()", "ValueError: too many values to unpack"),
        ("n, x, y, z = input().split()", "ValueError: not enough values to unpack"),
        ("x, y = float(input()), 0", "ValueError: could not convert string to float: "),
        ("[input() for _ in range(9)]", "EOFError: "),
    ],
)
def test_a_program_that_chokes_on_its_input_is_shown_the_line_and_the_form(reading, what):
    result = judged(f"for _ in range(int(input())):\n    {reading}\n    print(1)\n")
    message = result.failure.message
    assert result.verdict is Verdict.RTE
    assert message.startswith(what)
    _, _, row = message.partition(FORM)
    n, (x, y) = result.failure.input["n"], result.failure.input["P"]
    assert row == f"{n} {x} {y}"
    assert fault_place(result).line == 2


def test_another_exception_says_nothing_of_the_input():
    source = "import math\nfor _ in range(int(input())):\n    input()\n    print(math.sqrt(-1))\n"
    assert "its input" not in judged(source).failure.message
