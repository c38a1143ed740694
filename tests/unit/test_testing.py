"""What `judge.testing` gives an author of a library beside `check`: results, cases, a strategy."""

from __future__ import annotations

import pytest
from hypothesis import given, settings

from judge.errors import UsageError
from judge.problem import Verdict
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
    assert result.verdict is Verdict.WA
    assert result.counterexample is not None
    short = COUNT.judge(lambda *_: 2, seconds=0)
    assert [each.run for each in short.groups] == [True] + [False] * (len(short.groups) - 1)


def test_hypothesis_finds_a_case_and_makes_it_small():
    seen = []

    @settings(max_examples=200, database=None, deadline=None)
    @given(COUNT.strategy("grid"))
    def holds(case):
        seen.append(case)
        assert case.accepts(0)

    with pytest.raises(AssertionError):
        holds()
    assert max(map(abs, (*seen[-1].A, *seen[-1].B, seen[-1].r))) <= 2
    with pytest.raises(UsageError, match="are not drawn"):
        COUNT.strategy("examples")
