"""What a routine does to the state of the process, `judge.testing` undoes after each test group."""

import decimal
import random
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest

from judge.judging.inprocess import InProcess
from judge.sandbox.boundary import Limits, Stop
from judge.testing import judge_problem

PACK = Path(__file__).parents[1] / "fixtures" / "pack" / "problems"
GROUPS = {"examples": 2, "whole": 20, "half": 30}


def low_recursion():
    """So low that a few more calls fail."""
    frame, depth = sys._getframe(), 0
    while frame := frame.f_back:
        depth += 1
    sys.setrecursionlimit(depth + 20)


CONTEXT = (decimal.getcontext, lambda: repr(decimal.getcontext()))
# A change, and the state that it changes: the object where there is one, and its value.
CHANGES = {
    "another context": (lambda: decimal.setcontext(decimal.Context(prec=2, traps=[])), *CONTEXT),
    "recursion": (low_recursion, None, sys.getrecursionlimit),
    "draw": (random.random, None, random.getstate),
    "numpy's seed": (lambda: np.random.seed(7), None, lambda: repr(np.random.get_state())),
    "numpy's errors": (lambda: np.seterr(all="raise"), None, np.geterr),
    "filters": (
        lambda: warnings.filters.insert(0, ("ignore", None, Warning, None, 0)),
        lambda: warnings.filters,
        lambda: list(warnings.filters),
    ),
}


@pytest.fixture
def middle(tmp_path, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path))
    found = judge_problem("middle", problems=[PACK])
    assert found.groups == tuple(GROUPS)
    assert found.data  # building them draws from no shared state, but is not what is looked at here
    return found


@pytest.mark.parametrize("name", CHANGES)
def test_the_callers_state_is_as_it_was_whatever_is_raised(name, middle):
    change, thing, value = CHANGES[name]
    for fault in (None, ValueError, KeyboardInterrupt):
        before = thing and thing(), value()

        def routine(a, b, fault=fault):
            change()
            if fault:
                raise fault
            return (a + b) / 2

        if fault is None:
            middle.check(routine)
        else:
            with pytest.raises(AssertionError if issubclass(fault, Exception) else fault):
                middle.check(routine)
        assert (thing and thing()) is before[0]
        assert value() == before[1]


def test_within_a_group_it_lasts_and_each_begins_with_the_callers(middle):
    """As in `judge run`, where the calls of a group share a process: a generator that is seeded once."""
    before, drawn, states = random.getstate(), [], []

    def routine(a, b):
        states.append(random.getstate())
        if states[-1] == before:
            random.seed(7)
        drawn.append(random.random())
        return (a + b) / 2

    middle.check(routine)  # all groups at once
    generator = random.Random(7)
    once = [generator.random() for _ in range(30)]
    assert drawn == [*once[:2], *once[:20], *once]
    assert [place for place, state in enumerate(states) if state == before] == [0, 2, 22]


def test_the_judge_does_not_compare_in_the_state_that_a_routine_leaves(middle):
    """Nor are a routine's right answers lost by it."""

    def routine(a, b):
        low_recursion()
        decimal.setcontext(decimal.Context(prec=1, traps=[decimal.Inexact]))
        warnings.simplefilter("error")
        np.seterr(all="raise")
        return (a + b) / 2

    middle.check(routine)


LIMITS = Limits(1.0, 1.0, 1 << 28, 1 << 20)


def test_a_box_in_this_process_is_a_whole_one():
    source = b"import random\nrandom.seed(7)\nasked = []\ndef f(x):\n    asked.append(x)\n    return 1 // x\n"
    box, before = InProcess(source, "f.py"), random.getstate()
    assert box.inspect().defines("f")
    assert [each.name for each in box.inspect().functions] == ["f"]
    first, second = box.call("f", [(1,), (0,), (2,)], LIMITS), box.call("f", [(1,)], LIMITS)
    assert [reply.stop for reply in first.replies] == [Stop.ANSWERED, Stop.EXCEPTION, Stop.ANSWERED]
    assert first.replies[1].detail.endswith("zero (line 6)")
    assert [reply.answer for reply in second.replies] == [1]
    assert random.getstate() == before
    assert InProcess(b"1 +", "f.py").inspect().fault.line == 1


@pytest.mark.parametrize(
    ("source", "stop", "detail"),
    [
        (b"print(int(input()) + 1)", Stop.ANSWERED, ""),
        (b"print(int(input()) + 1); exit(3)", Stop.EXITED, "exit status 3"),
        (b"print(int(input()) + 1); 1 / 0", Stop.EXCEPTION, "ZeroDivisionError: division by zero (line 1)"),
    ],
)
def test_a_box_in_this_process_runs_whole_programs(source, stop, detail):
    stdin, stdout = sys.stdin, sys.stdout
    done = InProcess(source, "p.py").run_program(b"41\n", LIMITS)
    assert (done.stop, done.stdout, done.detail) == (stop, b"42\n", detail)
    assert (sys.stdin, sys.stdout) == (stdin, stdout)
