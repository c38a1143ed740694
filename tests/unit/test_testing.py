"""What `judge.testing` gives an author of a library beside `check`: results, cases, a strategy."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import given, settings

from judge.errors import UsageError
from judge.problem import Verdict
from judge.report.tell import tell
from judge.testing import judge_problem

COUNT = judge_problem("count")


def test_a_case_has_its_arguments_by_name_and_decides_as_the_judge_does():
    case = COUNT.cases("examples")[0]
    assert (case.cx, case.A, case.expected) == (0, (-6, 3), "2")
    assert case.accepts(2)
    assert not case.accepts(1)
    assert not case.accepts(object())
    assert repr(case) == "Case(cx=0, cy=0, r=5, A=(-6, 3), B=(-5, 3))"
    for each in COUNT.cases("examples"):
        assert each.accepts(None if each.expected == "None" else int(each.expected))
    assert len(COUNT.cases()) == sum(len(each.cases) for each in COUNT.data.groups)
    with pytest.raises(AttributeError, match="radius"):
        case.radius  # noqa: B018
    with pytest.raises(UsageError, match="no group"):
        COUNT.cases("nowhere")


def test_a_result_says_all_of_it_or_what_there_was_time_for():
    result = COUNT.judge(lambda *_: 2)
    assert (result.verdict, result.cut_short) == (Verdict.WA, False)
    assert result.counterexample is not None
    short = COUNT.judge(lambda *_: 2, seconds=0)
    assert (short.verdict, short.cut_short) == (Verdict.TLE, True)
    assert not [each for each in short.groups if each.run]
    with pytest.raises(AssertionError, match=r"is not done with 27 of 27 groups\n\nnot run: 0 s are over$"):
        COUNT.check(stands, seconds=0)


def sleeps(*_):
    while True:
        time.sleep(60)


def stands(*_):
    sum(range(10**18))


def insists(*_):
    while True:
        with suppress(BaseException):
            time.sleep(60)


def test_a_call_that_does_not_come_back_is_ended_where_it_stands():
    timer = signal.getitimer(signal.ITIMER_REAL)[0]
    handler = signal.getsignal(signal.SIGALRM)
    result = COUNT.judge(sleeps, seconds=0.5)
    assert (result.verdict, result.cut_short) == (Verdict.TLE, True)
    assert result.failure.message.startswith(f"0.5 s are over ({__file__}:")
    assert result.failure.case == 1
    assert [each.run for each in result.groups] == [True] + [False] * (len(result.groups) - 1)
    with pytest.raises(AssertionError, match="fails 1 of 27 groups, 1 of"):
        COUNT.check(sleeps, seconds=0.5)
    assert (signal.getitimer(signal.ITIMER_REAL)[0] > 0) == (timer > 0)  # another's goes on
    assert signal.getsignal(signal.SIGALRM) is handler


def test_neither_the_search_nor_the_name_goes_beyond_the_end():
    """The search asks for a case that is called only then, and the routine does not come back from it."""
    seen = {case for group in COUNT.data.groups for case in group.cases}

    def waits(*case):
        if case not in seen:
            sleeps()
        return 2

    result = COUNT.judge(waits, seconds=5)
    assert (result.verdict, result.cut_short, result.pitfall) == (Verdict.WA, True, None)
    assert all(each.run for each in result.groups)


@pytest.mark.parametrize("name", ["stands", "insists"])
def test_a_process_that_cannot_be_interrupted_ends_and_says_so(name):
    script = "import test_testing as t\nfrom judge.judging import clock\nclock.GRACE = 0.5\n"
    script += f"t.COUNT.judge(t.{name}, seconds=0.5)"
    ended = subprocess.run(
        [sys.executable, "-c", script], cwd=Path(__file__).parent, capture_output=True, text=True, check=False
    )
    assert ended.returncode == -signal.SIGKILL
    assert ended.stderr.startswith(f"judge: {name} has not come back 0.5 s after its 0.5 s were over")
    assert ended.stderr.count("\n") == 1


def test_a_routine_that_ends_the_process_fails_its_cases():
    result = COUNT.judge(lambda *_: sys.exit(3))
    assert result.verdict is Verdict.RTE
    assert result.failure.message.startswith("SystemExit: 3")
    assert all(each.run for each in result.groups)


def test_of_a_library_the_answers_alone_are_known():
    """This file imports pytest: nothing of its text says what is done elsewhere."""
    names = {}
    exec((COUNT.problem.solutions / "accepted" / "tolerant.py").read_text(), names)

    def from_a_library(cx, cy, r, A, B):  # noqa: N803
        return names["line_count"](cx, cy, r, A, (A[0] + B[0], A[1] + B[1]))

    result = COUNT.judge(from_a_library)
    assert tell(COUNT.problem, result).mistake == "It answers like point-for-direction"
    assert result.pitfall.library


def test_hypothesis_finds_a_case_and_makes_it_small():
    from first_draw import first_draw  # another test imports this file from elsewhere

    first_draw()
    seen = []

    @settings(max_examples=200, database=None, deadline=None, derandomize=True)
    @given(COUNT.strategy("grid"))
    def holds(case):
        seen.append(case)
        assert case.accepts(0)

    with pytest.raises(AssertionError):
        holds()
    assert max(map(abs, (*seen[-1].A, *seen[-1].B, seen[-1].r))) <= 2
    with pytest.raises(UsageError, match="are not drawn"):
        COUNT.strategy("examples")
