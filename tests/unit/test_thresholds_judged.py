"""Thresholds of contained submissions: they are in the result, cost nothing, and never change a verdict."""

from __future__ import annotations

import pytest
from msgspec.structs import replace
from sampling import nightly

import judge
from judge.data import load_data
from judge.judging import diagnosis
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.run.result import GroupResult, Mode, Result, Timing

RIGHT = """
from math import hypot

def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == dy == 0:
        return None
    ax, ay, bx, by = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    extent = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    gap = abs(dx * ay - dy * ax) / hypot(dx, dy) - r
    if 1e-11 * extent < abs(gap) < 1e-8 * extent:  # no case is there
        IN_THE_GAP
    return 1 if abs(gap) <= 1e-10 * extent else 2 if gap < 0 else 0
"""


pytestmark = pytest.mark.slow


def judged(source, **options):
    return judge.judge("count", source, timed=False, named=False, **options)


def test_an_accepted_submission_is_told_of_one_border():
    (found,) = judged(RIGHT.replace("IN_THE_GAP", "pass")).thresholds
    assert (found.decision, found.mistake, found.follows_its_size) == ("a tangency", None, True)
    assert len(found.figures) == 9
    assert all(flip.low <= 1e-10 * flip.size <= flip.high for flip in found.figures)


@pytest.mark.parametrize(
    "harm",
    [
        nightly("raise SystemExit"),
        "import os; os._exit(0)",
        nightly("import time; time.sleep(60)"),
        nightly("while True: pass"),
        nightly("x = 'x' * (1 << 40)"),
        nightly("print('x' * (1 << 24))"),
        nightly("return 'one'"),
        "import random; return random.choice((0, 1, 2))",
    ],
)
def test_harm_in_the_gap_changes_no_verdict(harm):
    result = judged(RIGHT.replace("IN_THE_GAP", harm))
    assert (result.verdict, result.score, result.thresholds, result.notes) == (Verdict.AC, 100, (), ())


def test_without_the_search_for_a_smaller_case_nothing_is_measured():
    assert judged(RIGHT.replace("IN_THE_GAP", "pass"), diagnosed=False).thresholds == ()


def test_a_fault_of_ours_leaves_the_result_as_it_is(monkeypatch):
    def fails(*_, **__):
        raise RuntimeError("a fault")

    monkeypatch.setattr("judge.mistakes.thresholds.measured", fails)
    result = judged(RIGHT.replace("IN_THE_GAP", "pass"))
    assert (result.verdict, result.thresholds, result.notes) == (Verdict.AC, (), ())


def outcome(verdict=Verdict.AC, cpu_seconds=0.001):
    groups = (GroupResult("grid", verdict, 100, 100, None, cpu_seconds),)
    return Result("count", "a.py", Mode.FUNCTION, verdict, groups, time=Timing(cpu_seconds, cpu_seconds))


@pytest.mark.parametrize("result", [outcome(cpu_seconds=1.0), outcome(Verdict.TLE), outcome(Verdict.RTE)])
def test_a_slow_or_crashing_submission_is_not_asked(result, monkeypatch):
    monkeypatch.setattr("judge.mistakes.thresholds.measured", lambda *_, **__: pytest.fail("it was asked"))
    data = load_data(find_problem("count"))
    assert diagnosis.with_thresholds(result, data, None, None) is result
    asked = []
    monkeypatch.setattr("judge.mistakes.thresholds.measured", lambda *_, **__: asked.append(1) or ())
    assert diagnosis.with_thresholds(outcome(), data, None, None) == replace(outcome(), thresholds=())
    assert asked == [1]
