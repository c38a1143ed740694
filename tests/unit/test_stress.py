"""Judging on fresh cases: what ends it, what it has counted, and that it comes out the same again."""

from __future__ import annotations

from itertools import count

import pytest

from judge.data import ProblemData
from judge.data.fresh import Fresh
from judge.data.module import load_module
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.report.stress import stress_lines
from judge.run.result import Mode
from judge.run.stress import stress
from judge.sandbox import open_box

pytestmark = pytest.mark.slow

EXACT = (find_problem("count").solutions / "accepted" / "exact.py").read_text()
PROGRAM = (find_problem("count").solutions / "accepted" / "program.py").read_text()
RENAMED = EXACT.replace("def line_count(", "def right(")
assert RENAMED != EXACT


def ticking():
    """A clock that goes on by a tenth of a second whenever it is looked at."""
    ticks = count()
    return lambda: next(ticks) / 10


def stressed(source, *, seconds=2.0, seed=1, groups=("grid", "tangent", "axis-parallel"), **options):
    problem = find_problem("count")
    module = load_module(problem)
    fresh = Fresh(problem, module, [problem.group(each) for each in groups], seed)
    data = ProblemData(problem, (), module=module)
    text = source.encode()
    with open_box(text, "my.py") as box:
        return stress(data, fresh, box, text, "my.py", seconds=seconds, clock=ticking(), **options)


def text_of(found, width=80):
    return "\n".join("".join(span.text for span in line) for line in stress_lines(found, width, 60))


@pytest.mark.parametrize(("source", "mode"), [(EXACT, Mode.FUNCTION), (PROGRAM, Mode.PROGRAM)])
def test_a_right_one_goes_on_until_the_time_is_up(source, mode):
    found = stressed(source)
    assert (found.result.verdict, found.result.mode, found.result.failure) == (Verdict.AC, mode, None)
    assert found.broken is None
    assert not found.interrupted
    assert found.cases == sum(group.cases for group in found.result.groups)
    assert found.cases == sum(group.passed for group in found.result.groups)
    assert found.cases >= 96
    assert [group.name for group in found.result.groups] == ["grid", "tangent", "axis-parallel"]
    assert "nothing broke" in text_of(found)
    assert "again with --seed 1" in text_of(found, 200)


WRONG = (
    RENAMED
    + """
def line_count(cx, cy, r, A, B):
    return 0 if A[0] == B[0] != cx else right(cx, cy, r, A, B)
"""
)


def test_what_breaks_ends_it_and_the_seed_repeats_it():
    found = stressed(WRONG)
    assert found.result.verdict is Verdict.WA
    failure, local = found.result.failure, found.broken.failure
    assert failure.group == "grid"
    assert all(len(line) <= width for width in (40, 80) for line in text_of(found, width).splitlines())
    assert found.broken.series.data.cases[local.case - 1][0] == failure.input["cx"]
    again = stressed(WRONG)
    assert again.result.failure == failure
    assert again.cases == found.cases
    assert stressed(WRONG, seed=2).result.failure != failure


def test_a_failures_case_is_counted_in_all_cases_of_its_group():
    found = stressed(
        RENAMED + "seen = set()\ndef line_count(*case):\n    return 7 if case[2] == 3 and case[0] == -3 "
        "and case[3] == (-3, 3) else right(*case)\n",
        seconds=1000.0,
        groups=("grid",),
    )
    failure = found.result.failure
    assert failure.got == "7"
    assert failure.case > found.broken.failure.case
    assert failure.case <= found.cases


@pytest.mark.parametrize(
    ("body", "verdict", "words"),
    [
        ("return 1 // 0", Verdict.RTE, "ZeroDivisionError"),
        ("import os; os._exit(3)", Verdict.RTE, "exit status 3"),
    ],
)
def test_a_call_that_gives_no_answer_breaks_it(body, verdict, words):
    found = stressed(f"def line_count(*case):\n    {body}\n")
    assert found.result.verdict is verdict
    assert words in found.result.failure.message
    assert found.result.failure.case == 1
    assert found.cases >= 1
