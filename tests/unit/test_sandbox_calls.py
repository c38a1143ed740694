"""Calls and programs behind the boundary: what comes back. What holds at every level: tests/security."""

from __future__ import annotations

import math
import os
import signal
import sys
import tempfile
from pathlib import Path

import pytest
from sandboxed import LIMITS, call, children, require, run

from judge.errors import JudgeError, ShortageError
from judge.sandbox import LEVELS, Stop, holder, open_box
from judge.values.decode import number

NUMBERS = [(n,) for n in range(5)]
on_linux = pytest.mark.skipif(
    sys.platform != "linux", reason="processes are told by /proc or die as on Linux"
)


def stops(result):
    return [reply.stop for reply in result.replies]


def test_answers_come_back_in_order_and_exactly():
    values = [1, -7, 10**30, 0.1, -0.0, 5e-324, 1.7976931348623157e308, math.pi]
    result = call("def f(x): return (x, [x])", [(value,) for value in values])
    assert set(stops(result)) == {Stop.ANSWERED}
    for value, reply in zip(values, result.replies, strict=True):
        first, (second,) = reply.answer
        assert number(first) == number(second) == value
        assert type(number(first)) is type(value)
    assert math.copysign(1, result.replies[4].answer[0]) == -1


def test_a_series_has_one_module_and_the_next_finds_nothing_of_it():
    source = b"""
import math
calls = []
def f(n):
    calls.append(n)
    math.pi += 1
    return len(calls), math.pi
"""
    with open_box(source, "my.py") as box:
        first, second = (box.call_many("f", NUMBERS[:2], LIMITS) for _ in range(2))
        assert box.call_many("f", [], LIMITS).replies == ()
    assert [reply.answer for reply in first.replies] == [reply.answer for reply in second.replies]
    assert [reply.answer[0] for reply in second.replies] == [1, 2]
    assert second.replies[0].answer[1] == math.pi + 1


@pytest.mark.parametrize(
    ("body", "detail"),
    [
        ("sys.exit(4)", "SystemExit: 4 (line 4)"),
        ("raise ValueError('a\\nb' + 'x' * 9999)", "ValueError: a b" + "x" * 497 + " (line 4)"),
        ("return f(n)", "RecursionError: maximum recursion depth exceeded"),
        ("raise E", "E: (its text cannot be shown) (line 4)"),
    ],
)
def test_exceptions_are_told_in_one_line(body, detail):
    source = f"import sys\ndef f(n):\n    if n == 3:\n        {body}\n    return n\n"
    source += "class E(Exception):\n    def __str__(self): raise self\n"
    result = call(source, NUMBERS)
    assert stops(result) == [Stop.ANSWERED] * 3 + [Stop.EXCEPTION, Stop.ANSWERED]
    assert result.replies[3].detail.startswith(detail)


def test_a_call_that_closes_every_descriptor_loses_nothing():
    result = call("import os\ndef f(n):\n    if n == 1: os.closerange(0, 100)\n    return n", NUMBERS)
    assert [reply.answer for reply in result.replies] == [0, 1, 2, 3, 4]


@pytest.mark.slow
@on_linux
def test_an_interrupt_leaves_nothing_behind():
    def interrupt(*_):
        raise KeyboardInterrupt

    before = children()
    handler = signal.signal(signal.SIGALRM, interrupt)
    try:
        with open_box(b"import time\ndef f(n): time.sleep(n); return n", "my.py") as box:
            box.call_many("f", [(0,)], LIMITS)
            assert children() > before
            signal.setitimer(signal.ITIMER_REAL, 0.1)
            with pytest.raises(KeyboardInterrupt):
                box.call_many("f", [(60,)], LIMITS)
            assert children() == before
            assert box.call_many("f", [(0,)], LIMITS).replies[0].answer == 0
        assert children() == before
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, handler)


@pytest.mark.slow
@on_linux
def test_a_container_that_ends_by_itself_is_no_fault_of_the_submission():
    before = children()

    def kill_it():
        for pid in children() - before:
            os.kill(int(pid), signal.SIGKILL)
            os.waitid(os.P_PID, int(pid), os.WEXITED | os.WNOWAIT)

    with open_box(b"def f(n): return n", "my.py", level="limits") as box:
        box.inspect()
        kill_it()  # before it is made ready for calls
        assert stops(box.call_many("f", NUMBERS, LIMITS)) == [Stop.ANSWERED] * 5
        kill_it()
        with pytest.raises(ShortageError, match="the process that watches it has ended"):
            box.call_many("f", NUMBERS, LIMITS)
        assert stops(box.call_many("f", NUMBERS, LIMITS)) == [Stop.ANSWERED] * 5


def test_numpy_numbers_and_arrays_are_the_numbers_they_hold():
    pytest.importorskip("numpy")
    source = "import numpy as np\ndef f(n): return np.array([[n, 0.5]]), np.float64(n), np.int32(n)"
    reply = call(source, NUMBERS[:2]).replies[1]
    assert reply.answer == [[[1.0, 0.5]], 1.0, 1]


# -- whole programs ------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("ending", "stop", "detail"),
    [
        ("sys.exit(0)", Stop.ANSWERED, ""),
        ("sys.exit('no')", Stop.EXITED, "exit status 1"),
        ("import os; os._exit(9)", Stop.EXITED, "exit status 9"),
        ("import os; os.abort()", Stop.EXITED, "killed by SIGABRT"),
    ],
)
def test_a_program_ends_well_or_says_how(ending, stop, detail):
    result = run(f"import sys\nprint(1, flush=True)\n{ending}")
    assert (result.stop, result.stdout, result.detail) == (stop, b"1\n", detail)


def test_an_uncaught_exception_has_its_line_and_only_the_submissions_frames():
    result = run("def f():\n    return 1 / 0\nprint(5, flush=True)\nf()")
    assert (result.stop, result.detail) == (Stop.EXCEPTION, "ZeroDivisionError: division by zero (line 2)")
    assert result.stdout == b"5\n"
    assert b"child.py" not in result.stderr
    assert result.stderr.startswith(
        b'Traceback (most recent call last):\n  File "/dev/fd/4", line 4, in <module>'
    )


# -- what a source is: names, lines and faults; and how a box opens and closes -------------------------------


def inspect(source):
    with open_box(source, "my.py") as box:
        return box.inspect()


def test_names_of_every_kind_of_binding_with_their_lines():
    source = (
        b"import os.path, sys as system\ndef f(): inner = 1\nclass C: member = 1\n(a, b), *c = [1, 2], 3\n"
    )
    source += b"for i in range(3):\n    if (w := i): j = w\nwith open('x') as h: pass\nf = None\n"
    assert dict(inspect(source).names) == {
        "os": 1, "system": 1, "f": 2, "C": 3, "a": 4, "b": 4, "c": 4, "i": 5, "w": 6, "j": 6, "h": 7,
    }  # fmt: skip


def test_inspecting_runs_nothing(tmp_path):
    proof = tmp_path / "ran"
    inspection = inspect(f"open({str(proof)!r}, 'w').close()\ndef f(): pass".encode())
    assert inspection.defines("f")
    assert not inspection.defines("g")
    assert not proof.exists()


def test_a_syntax_error_has_its_place_and_an_empty_source_none():
    assert (inspect(b"").fault, inspect(b"").names) == (None, ())
    fault = inspect(b"x = 1\ndef f(:\n    pass\n").fault
    assert fault.message == "SyntaxError: invalid syntax"
    assert (fault.line, fault.text) == (2, "def f(:")


@on_linux
@pytest.mark.parametrize("level", LEVELS)
def test_nothing_is_left_when_a_box_closes(level, tmp_path, monkeypatch):
    require(level)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    descriptors, processes = len(list(Path("/dev/fd").iterdir())), children()
    with open_box(b"def f(): return 1", "my.py", level=level) as box:
        assert box.call_many("f", [()], LIMITS).replies[0].answer == 1
        assert box.run_program(b"", LIMITS).detail == ""
        assert children() > processes
        assert not list(tmp_path.iterdir())
    assert children() == processes
    assert len(list(Path("/dev/fd").iterdir())) == descriptors
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("python", "what"),
    [
        ("/nowhere/python", "no container can be started: "),
        ("/bin/false", "no container could be started: it ended without a word"),  # which may pass
    ],
)
def test_an_interpreter_that_does_not_start_is_one_clear_error(python, what, monkeypatch):
    before = children()
    monkeypatch.setattr(sys, "executable", python)
    monkeypatch.setattr(holder, "PAUSES", (0.0,) * len(holder.PAUSES))
    with pytest.raises(JudgeError) as caught, open_box(b"", "my.py"):
        pass
    assert caught.value.what.startswith(what)
    assert "\n" not in caught.value.what
    assert children() == before
