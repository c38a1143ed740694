"""What a routine does to the state of the process, `judge.testing` undoes after each test group."""

from __future__ import annotations

import decimal
import inspect
import random
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest

from judge.testing import judge_problem

PACK = Path(__file__).parents[1] / "fixtures" / "pack" / "problems"
GROUPS = ("examples", "whole", "half")


def _precision():
    decimal.getcontext().prec = 3


def _another_context():
    decimal.setcontext(decimal.Context(prec=2, rounding=decimal.ROUND_UP, traps=[]))


def _flag():
    decimal.Decimal(1) / 3


def _trap():
    decimal.getcontext().traps[decimal.Inexact] = True


def _recursion():
    sys.setrecursionlimit(sys.getrecursionlimit() + 5000)


def _little_room():
    sys.setrecursionlimit(len(inspect.stack(0)) + 20)


def _digits():
    sys.set_int_max_str_digits(0)


def _seed():
    random.seed(7)


def _draw():
    random.random()


def _numpy_seed():
    np.random.seed(7)


def _numpy_errors():
    np.seterr(all="raise")


def _filters():
    warnings.simplefilter("ignore")


def _filters_in_place():
    warnings.filters.insert(0, ("ignore", None, Warning, None, 0))


def _silence():
    warnings.showwarning = lambda *_: None


def context():
    now = decimal.getcontext()
    return id(now), repr(now)


CHANGES = [
    (_precision, context),
    (_another_context, context),
    (_flag, context),
    (_trap, context),
    (_recursion, sys.getrecursionlimit),
    (_little_room, sys.getrecursionlimit),
    (_digits, sys.get_int_max_str_digits),
    (_seed, random.getstate),
    (_draw, random.getstate),
    (_numpy_seed, lambda: repr(np.random.get_state())),
    (_numpy_errors, np.geterr),
    (_filters, lambda: (id(warnings.filters), list(warnings.filters))),
    (_filters_in_place, lambda: (id(warnings.filters), list(warnings.filters))),
    (_silence, lambda: warnings.showwarning),
]
every = pytest.mark.parametrize(("change", "state"), CHANGES, ids=lambda each: each.__name__)


@pytest.fixture
def middle(tmp_path, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path))
    found = judge_problem("middle", problems=[PACK])
    assert found.groups == GROUPS
    assert found.data  # building them draws from no shared state, but is not what is looked at here
    return found


@every
def test_the_callers_state_is_as_it_was(change, state, middle):
    before = state()

    def routine(a, b):
        change()
        return (a + b) / 2

    middle.check(routine)
    assert state() == before


@every
def test_each_group_begins_with_the_callers_state(change, state, middle):
    """With its values: Decimal's context is a copy of the caller's, as is the list of filters."""
    seen = []
    first = True

    def value():
        found = state()
        return (
            found[1] if isinstance(found, tuple) and isinstance(found[0], int) and len(found) == 2 else found
        )

    def routine(a, b):
        nonlocal first
        if first:
            seen.append(value())
            first = False
        change()
        return (a + b) / 2

    before = value()
    for name in GROUPS:
        first = True
        middle.group(name).check(routine)
    assert seen == [before] * len(GROUPS)

    seen.clear()
    calls = {"n": 0}
    starts = {0, 2, 22}  # of the groups, when all are judged at once

    def counting(a, b):
        if calls["n"] in starts:
            seen.append(value())
        calls["n"] += 1
        change()
        return (a + b) / 2

    middle.check(counting)
    assert calls["n"] == 52
    assert seen == [before] * len(GROUPS)


@every
@pytest.mark.parametrize("fault", [ValueError, AssertionError, KeyboardInterrupt, SystemExit])
def test_so_it_is_after_an_exception(change, state, fault, middle):
    before = state()

    def routine(a, b):
        change()
        raise fault

    with pytest.raises(AssertionError if issubclass(fault, Exception) else fault):
        middle.check(routine)
    assert state() == before


def test_within_a_group_it_lasts(middle):
    """As in `judge run`, where the calls of a group share a process: a generator that is seeded once."""
    drawn = []

    def routine(a, b):
        if not drawn:
            random.seed(7)
        drawn.append(random.random())
        return (a + b) / 2

    middle.group("half").check(routine)
    generator = random.Random(7)
    assert drawn == [generator.random() for _ in drawn]
    assert len(drawn) == 30


def test_the_judge_does_not_compare_in_the_state_that_a_routine_leaves(middle):
    """Nor are a routine's right answers lost by it."""

    def routine(a, b):
        sys.setrecursionlimit(len(inspect.stack(0)) + 20)
        decimal.setcontext(decimal.Context(prec=1, traps=[decimal.Inexact]))
        warnings.simplefilter("error")
        np.seterr(all="raise")
        return (a + b) / 2

    middle.check(routine)


def test_a_wrong_answer_before_the_first_exception_is_the_failure(middle):
    calls = []

    def routine(a, b):
        calls.append(a)
        if len(calls) == 1:
            return 0
        raise ValueError("too late")

    with pytest.raises(AssertionError, match="wanted") as caught:
        middle.group("examples").check(routine)
    assert caught.value.__cause__ is None
