"""Results as compilers write them: one line each, at the place, whatever a submission is called or says."""

from __future__ import annotations

import re

import pytest

from judge.problem import Verdict
from judge.report.editor import editor_lines
from judge.run import Failure, GroupResult, Mode, Pitfall, Result

PLACED = re.compile(r"^(.+?):(\d+):(\d+): (error|note): (.*)$")
SOURCE = b"import math\n\ndef solve(a):\n    return 1 / a\n"
SMALLEST = {"input": {"a": 0}, "expected": "1", "got": "2", "message": "off by 1", "replay": "x:y:z"}


def result(verdict: Verdict, message: str, **changes) -> Result:
    groups = () if verdict is Verdict.CE else (GroupResult("grid", verdict, 2, 1, None, 0.0),)
    failure = Failure(message, "grid" if groups else None, 7 if groups else None)
    return Result("count", changes.pop("name", "mine.py"), Mode.FUNCTION, verdict, groups, failure, **changes)


def lines(found: Result) -> list[str]:
    return list(editor_lines(found, SOURCE, "solve"))


def test_an_accepted_one_has_no_place():
    (said,) = lines(Result("count", "mine.py", Mode.FUNCTION, Verdict.AC))
    assert said.startswith("mine.py: AC  accepted")
    assert not PLACED.match(said)


def test_a_wrong_answer_is_at_the_function_with_the_smallest_case_and_the_mistake():
    mistakes = Pitfall(("one", "other"), 0.9, ("Do this.", "Do that."))
    found = lines(result(Verdict.WA, "2 wanted, 1 given", counterexample=SMALLEST, pitfall=mistakes))
    assert found == [
        "mine.py:3:1: error: WA in grid, case 7: 2 wanted, 1 given",
        "mine.py:3:1: note: smallest case found: a=0: 1 wanted, 2 given; judge replay x:y:z",
        "mine.py:3:1: note: likely one: Do this.",
        "mine.py:3:1: note: likely other: Do that.",
    ]
    assert all(PLACED.match(row) for row in found)


@pytest.mark.parametrize(
    ("verdict", "message", "place"),
    [
        (Verdict.RTE, "ZeroDivisionError: division by zero (line 4)", "4:1"),
        (Verdict.CE, "SyntaxError: expected ':' (line 2, column 5): def", "2:5"),
    ],
)
def test_a_fault_is_at_its_own_line(verdict, message, place):
    (said,) = lines(result(verdict, message))
    assert said.startswith(f"mine.py:{place}: error: {verdict.value}")


def test_nothing_of_a_submission_begins_a_line_or_steers_the_terminal():
    (said,) = lines(result(Verdict.WA, "a\nother.py:1:1: error: b\x1b[2J", name="-x\n.py"))
    assert said.startswith("./-x\\n.py:3:1: error: ")
    assert said.isprintable()
