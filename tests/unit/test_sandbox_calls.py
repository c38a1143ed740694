"""Function mode behind the boundary: replies, losses and limits of a series of calls."""

from __future__ import annotations

import math
import os
import signal
import sys

import pytest
from sandboxed import LIMITS, call, children, limits, lost_at_3

from judge.errors import ShortageError
from judge.sandbox import Stop, open_box
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


def test_inner_sequences_arrive_as_tuples():
    source = "def f(p, q): return [type(p) is tuple, type(q[0]) is tuple, len(q)] and p + q[0]"
    assert call(source, [([1, 2], [[3, 4], 5])]).replies[0].answer == [1, 2, 3, 4]


def test_the_module_is_imported_once_for_a_series():
    with open_box(b"calls = []\ndef f(n):\n    calls.append(n)\n    return len(calls)", "my.py") as box:
        box.inspect()
        assert box.call_many("f", NUMBERS, LIMITS).replies[-1].answer == 5
        assert box.call_many("f", [], LIMITS).replies == ()


def test_nothing_is_kept_from_one_series_to_the_next():
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
    assert [reply.answer for reply in first.replies] == [reply.answer for reply in second.replies]
    assert second.replies[0].answer == [1, math.pi + 1]


def test_an_exception_costs_only_its_own_call():
    result = call("def f(n):\n    return 6 // n", NUMBERS)
    assert stops(result) == [Stop.EXCEPTION] + [Stop.ANSWERED] * 4
    assert result.replies[0].detail == "ZeroDivisionError: integer division or modulo by zero (line 2)"


@pytest.mark.parametrize(
    ("body", "detail"),
    [
        ("sys.exit(4)", "SystemExit: 4 (line 4)"),
        ("raise KeyboardInterrupt", "KeyboardInterrupt (line 4)"),
        ("raise ValueError('a\\nb' + 'x' * 9999)", "ValueError: a b" + "x" * 497 + " (line 4)"),
        ("raise RecursionError('too deep')", "RecursionError: too deep (line 4)"),
    ],
)
def test_exceptions_are_told_in_one_line(body, detail):
    source = f"import sys\ndef f(n):\n    if n == 3:\n        {body}\n    return n"
    result = call(source, NUMBERS)
    assert stops(result) == [Stop.ANSWERED] * 3 + [Stop.EXCEPTION, Stop.ANSWERED]
    assert result.replies[3].detail == detail


def test_endless_recursion_is_an_exception():
    result = call("def f(n): return f(n) if n == 3 else n", NUMBERS)
    assert stops(result) == [Stop.ANSWERED] * 3 + [Stop.EXCEPTION, Stop.ANSWERED]
    assert result.replies[3].detail.startswith("RecursionError: maximum recursion depth exceeded")


def test_an_exception_whose_text_raises_is_told_too():
    source = "class E(Exception):\n    def __str__(self): raise self\ndef f(n): raise E"
    assert call(source, [(1,)]).replies[0].detail == "E: (its text cannot be shown) (line 3)"


@pytest.mark.parametrize(
    ("body", "detail"),
    [
        ("os._exit(0)", "exit status 0"),
        ("os._exit(7)", "exit status 7"),
        ("os.kill(os.getpid(), 11)", "killed by SIGSEGV (did it call itself too deeply?)"),
        ("os.kill(os.getpid(), 9)", "killed by SIGKILL"),
    ],
)
def test_a_call_that_ends_its_process_costs_itself_and_ends_the_series(body, detail):
    reply = lost_at_3(body)
    assert (reply.stop, reply.detail) == (Stop.EXITED, detail)


@pytest.mark.parametrize(
    "body",
    ["os.closerange(0, 100)", "sys.stdout.close(); sys.stderr.close()", "sys.stdout = sys.stderr = None"],
)
def test_a_call_that_closes_every_descriptor_loses_nothing(body):
    result = call(f"import os, sys\ndef f(n):\n    if n == 1: {body}\n    return n", NUMBERS)
    assert [reply.answer for reply in result.replies] == [0, 1, 2, 3, 4]


def test_after_a_loss_the_next_series_runs_in_a_new_process():
    source = b"import os\ndef f(n):\n    if n == 3: os._exit(0)\n    return os.getpid()"
    with open_box(source, "my.py") as box:
        first = box.call_many("f", NUMBERS, LIMITS)
        second = box.call_many("f", NUMBERS[4:], LIMITS)
    assert stops(second) == [Stop.ANSWERED]
    assert second.replies[0].answer != first.replies[0].answer


def test_cpu_limit():
    reply = lost_at_3("while True: pass", limits(cpu_seconds=0.3))
    assert (reply.stop, reply.detail) == (Stop.CPU, "used more than 0.3 s of CPU time (line 4)")


def test_wall_limit_for_a_sleeper():
    reply = lost_at_3("time.sleep(60)", limits(wall_seconds=0.5))
    assert reply.stop is Stop.WALL


@pytest.mark.parametrize("body", ["x = bytes(1 << 40)", "x = [0] * 10**9"])
def test_an_uncaught_memory_error_is_the_memory_limit(body):
    assert lost_at_3(body).stop is Stop.MEMORY


def test_a_hog_that_grows_is_stopped_at_the_memory_limit():
    body = "x = []\n        while True: x.append(bytearray(b'x' * 10**6))"
    assert lost_at_3(body, limits(memory_bytes=64 << 20)).stop is Stop.MEMORY


def test_a_peak_over_the_limit_counts_though_it_was_freed():
    source = "def f(n):\n    x = bytearray(b'x') * (100 << 20)\n    return n"
    result = call(source, [(1,)], limits(memory_bytes=64 << 20))
    assert stops(result) == [Stop.MEMORY]


def test_what_is_only_seen_at_the_end_is_said_of_the_last_call():
    source = "import sys\ndef f(n):\n    sys.stdout.write('x' * 3000)\n    return n"
    result = call(source, NUMBERS, limits(output_bytes=14_000))
    assert stops(result) == [Stop.ANSWERED] * 4 + [Stop.OUTPUT]
    assert result.replies[4].detail == "wrote more than 14000 bytes, in this call or one before it"


def test_printing_without_end_is_the_output_limit():
    assert lost_at_3("while True: print('x' * 1000)").stop is Stop.OUTPUT


def test_printing_does_not_reach_the_answers():
    source = "import sys\nprint('A1')\ndef f(n):\n    print('A7', file=sys.stderr)\n    return n"
    assert [reply.answer for reply in call(source, NUMBERS).replies] == [0, 1, 2, 3, 4]


def test_a_module_that_fails_to_import_answers_every_call_with_the_reason():
    result = call("x = 1\n1 / 0\ndef f(n): return n", NUMBERS)
    assert set(stops(result)) == {Stop.EXCEPTION}
    assert (
        result.replies[4].detail
        == "ZeroDivisionError: division by zero (line 2), while the module was imported"
    )


def test_an_entry_that_is_gone_after_the_import_is_told():
    result = call("def f(n): return n\ndel f", NUMBERS)
    assert result.replies[0].detail == "the module has no f once it is imported"


def test_the_module_is_not_main_and_its_classes_work():
    source = """
from dataclasses import dataclass
@dataclass
class P:
    x: float
if __name__ == "__main__":
    raise SystemExit
def f(n): return P(n).x
"""
    assert call(source, NUMBERS).replies[4].answer == 4


def test_modules_of_the_judges_own_side_are_not_importable():
    source = """
import sys
def f(n):
    found = 0
    for name in ("judge", "judge.sandbox", "judge.sandbox.inside.server", "encode", "child", "wire"):
        found += name in sys.modules
        try: __import__(name)
        except ImportError: continue
        found += 100
    return found
"""
    assert call(source, NUMBERS[:1]).replies[0].answer == 0


def test_a_submission_may_be_called_like_a_module_of_the_standard_library():
    source = b"from fractions import Fraction\ndef f(n): return int(Fraction(n))"
    with open_box(source, "fractions.py") as box:
        assert box.call_many("f", NUMBERS, LIMITS).replies[4].answer == 4


def test_usage_is_measured_from_outside_and_without_start_up():
    quick = call("def f(n): return n", NUMBERS).usage
    assert 0 <= quick.cpu_seconds < 0.1
    assert quick.memory_bytes > 1 << 20
    source = """
import time
until, clock = time.process_time() + 0.2, time.process_time
time.process_time = time.thread_time = lambda: 0.0
def f(n):
    while clock() < until: pass
"""
    busy = call(source, NUMBERS).usage
    assert 0.15 < busy.cpu_seconds <= busy.wall_seconds


@on_linux
def test_what_a_call_leaves_behind_is_gone_when_it_is_answered():
    source = """
import os, time
def f(n):
    mine, theirs = os.pipe()
    child = os.fork()
    if child == 0:
        grandchild = os.fork()
        if grandchild: os.write(theirs, str(grandchild).encode())
        else: os.setsid()
        time.sleep(60)
    return child, int(os.read(mine, 20))
"""
    with open_box(source.encode(), "my.py", level="limits") as box:
        for pid in box.call_many("f", [(1,)], LIMITS).replies[0].answer:
            with pytest.raises(ProcessLookupError):
                os.kill(pid, 0)


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
