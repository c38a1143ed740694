"""Function mode behind the boundary: replies, losses, limits, and what a hostile module can do to them."""

from __future__ import annotations

import math
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest
from sandboxed import LIMITS, call, limits, run

from judge.compare.decode import number
from judge.sandbox import Stop, measure, open_box

ROOT = Path(__file__).parents[2]
NUMBERS = [(n,) for n in range(5)]


def stops(result):
    return [reply.stop for reply in result.replies]


def lost_at_3(body, within=LIMITS):
    """The reply of call 3, whose body is given; the calls before it must have been answered."""
    source = f"import os, sys, time\ndef f(n):\n    if n == 3:\n        {body}\n    return n\n"
    result = call(source, NUMBERS, within)
    assert [reply.answer for reply in result.replies[:3]] == [0, 1, 2]
    assert len(result.replies) == 4
    return result.replies[3]


def gone(pid):
    """Whether the process is dead within 10 s; whoever is init may still have to reap it."""
    deadline = time.monotonic() + 10
    while time.monotonic() < deadline:
        try:
            if Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "Z":
                return True
        except (FileNotFoundError, ProcessLookupError):
            return True
        time.sleep(0.01)
    return False


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
        ("os.closerange(3, 100)", "exit status 1"),
    ],
)
def test_a_call_that_ends_its_process_costs_itself_and_ends_the_series(body, detail):
    reply = lost_at_3(body)
    assert (reply.stop, reply.detail) == (Stop.EXITED, detail)


def test_after_a_loss_the_next_series_runs_in_a_new_process():
    source = b"import os\ndef f(n):\n    if n == 3: os._exit(0)\n    return os.getpid()"
    with open_box(source, "my.py") as box:
        first = box.call_many("f", NUMBERS, LIMITS)
        second = box.call_many("f", NUMBERS[4:], LIMITS)
    assert stops(second) == [Stop.ANSWERED]
    assert second.replies[0].answer != first.replies[0].answer


def test_cpu_limit():
    reply = lost_at_3("while True: pass", limits(cpu_seconds=0.3))
    assert (reply.stop, reply.detail) == (Stop.CPU, "used more than 0.3 s of CPU time")


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


@pytest.mark.parametrize("forgery", ["D\\x01\\0\\0\\0005", "x", "I\\0\\0\\0\\0", "D\\xff\\xff\\xff\\x7f"])
def test_writing_on_the_judges_channel_is_tampering(forgery):
    source = f"""
import os
def f(n):
    if n == 3:
        for fd in range(3, 40):
            try: os.write(fd, b"{forgery}")
            except OSError: pass
    return n
"""
    with open_box(source.encode(), "my.py") as box:
        result = box.call_many("f", NUMBERS, LIMITS)
        assert result.replies[-1].stop is Stop.TAMPERED
        assert box.call_many("f", NUMBERS[:1], LIMITS).replies[0].answer == 0


@pytest.mark.parametrize("forgery", ["x", "D\\x01\\0\\0\\0005"])
def test_more_on_the_channel_than_the_childs_own_frame_is_tampering(forgery):
    source = f"""
import os
def f(n):
    if n == 3:
        os.write(int(open("/proc/self/cmdline").read().split(chr(0))[7]), b"{forgery}")
    return n
"""
    assert call(source, NUMBERS).replies[-1].stop is Stop.TAMPERED


def test_extra_answers_are_tampering():
    source = """
import os
def f(n):
    os.write(int(open("/proc/self/cmdline").read().split(chr(0))[8]), b"A1" + bytes([10]))
    return n
"""
    result = call(source, NUMBERS)
    assert len(result.replies) == 5
    assert result.replies[-1].stop is Stop.TAMPERED


@pytest.mark.parametrize("line", ["A[[[", "A" + "[" * 10**5, "ANaN", "Q1", "A\xff", "", "E1"])
def test_a_line_in_another_form_is_tampering(line):
    text = (line + "\n").encode("latin-1")
    source = f"""
import os
def f(n):
    os.write(int(open("/proc/self/cmdline").read().split(chr(0))[8]), {text!r})
    return n
"""
    result = call(source, NUMBERS)
    assert [reply.stop for reply in result.replies] == [Stop.TAMPERED]


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
    for name in ("judge", "encode", "child", "boundary", "worker"):
        if name in sys.modules: found += 1
    return found
"""
    assert call(source, NUMBERS[:1]).replies[0].answer == 0


def test_a_submission_may_be_called_like_a_module_of_the_standard_library():
    source = b"from fractions import Fraction\ndef f(n): return int(Fraction(n))"
    with open_box(source, "fractions.py") as box:
        assert box.call_many("f", NUMBERS, LIMITS).replies[4].answer == 4


def test_usage_is_measured_from_outside_and_without_start_up():
    quick = call("def f(n): return n", NUMBERS).usage
    assert 0 < quick.cpu_seconds < 1
    assert quick.memory_bytes > 1 << 20
    source = "import time\ntime.process_time = lambda: 0.0\ndef f(n):\n    sum(range(10**6))"
    busy = call(source, NUMBERS).usage
    assert busy.cpu_seconds > quick.cpu_seconds


def test_what_a_call_leaves_behind_dies_with_the_box():
    source = """
import os, time
def f(n):
    pid = os.fork()
    if pid == 0:
        while True: time.sleep(1)
    return pid
"""
    with open_box(source.encode(), "my.py") as box:
        pid = box.call_many("f", [(1,)], LIMITS).replies[0].answer
        os.kill(pid, 0)
    assert gone(pid)


def test_an_interrupt_leaves_nothing_behind(monkeypatch):
    def watch(*args, **options):
        raise KeyboardInterrupt

    workers = []

    def interrupted():
        with box:
            box.inspect()
            workers.append(box._worker)
            monkeypatch.setattr(box._worker, "watch", watch)
            box.call_many("f", NUMBERS, LIMITS)

    box = open_box(b"def f(n): return n", "my.py")
    with pytest.raises(KeyboardInterrupt):
        interrupted()
    with pytest.raises(ProcessLookupError):
        os.kill(workers[0].pid, 0)
    assert not Path(box._folder).exists()


KILLED_JUDGE = """
import sys, threading, time
from judge.sandbox import Limits, open_box
source = b"import os, time\\ndef f():\\n    print(os.getpid(), flush=True)\\n    time.sleep(60)"
with open_box(source, "my.py") as box:
    box.inspect()
    print(box._worker.pid, flush=True)
    box.call_many("f", [()], Limits(60.0, 60.0, 1 << 28, 1 << 20))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux kills a child with its parent")
def test_a_killed_judge_takes_its_child_with_it(tmp_path):
    command = [sys.executable, "-c", KILLED_JUDGE]
    environment = {**os.environ, "TMPDIR": str(tmp_path)}
    with subprocess.Popen(command, stdout=subprocess.PIPE, cwd=ROOT, env=environment) as judge:
        pid = int(judge.stdout.readline())
        judge.kill()
    assert gone(pid)


def test_numpy_numbers_and_arrays_are_the_numbers_they_hold():
    pytest.importorskip("numpy")
    source = "import numpy as np\ndef f(n): return np.array([[n, 0.5]]), np.float64(n), np.int32(n)"
    reply = call(source, NUMBERS[:2]).replies[1]
    if "No module named" in reply.detail:
        pytest.skip("numpy is not where an isolated interpreter finds it")
    assert reply.answer == [[[1.0, 0.5]], 1.0, 1]


@pytest.fixture
def portable(monkeypatch):
    """A system without other processes' clocks, pidfd and memfd."""
    monkeypatch.setattr(measure, "HAS_CLOCK", False)
    for name in ("pidfd_open", "memfd_create"):
        monkeypatch.delattr(os, name, raising=False)


@pytest.mark.usefixtures("portable")
def test_without_linux_every_series_has_a_process_of_its_own():
    with open_box(b"import os\ndef f(n): return os.getpid()", "my.py") as box:
        assert box.inspect().defines("f")
        pids = {box.call_many("f", NUMBERS, LIMITS).replies[-1].answer for _ in range(3)}
    assert len(pids) == 3


@pytest.mark.usefixtures("portable")
@pytest.mark.parametrize(
    ("body", "wall", "stop"),
    [
        ("while True: pass", 20.0, Stop.CPU),
        ("time.sleep(60)", 0.5, Stop.WALL),
        ("os._exit(0)", 20.0, Stop.EXITED),
        ("bytes(1 << 40)", 20.0, Stop.MEMORY),
        ("while True: print('x' * 999)", 20.0, Stop.OUTPUT),
    ],
)
def test_without_linux_every_limit_holds(body, wall, stop):
    assert lost_at_3(body, limits(cpu_seconds=0.2, wall_seconds=wall)).stop is stop


@pytest.mark.usefixtures("portable")
def test_without_linux_programs_run_too():
    result = run("print(input())\nsum(range(10**6))", b"hello")
    assert (result.stop, result.stdout) == (Stop.ANSWERED, b"hello\n")
    assert result.usage.cpu_seconds > 0
    assert run("while True: pass", within=limits(cpu_seconds=0.2)).stop is Stop.CPU
    assert run("import time\ntime.sleep(60)", within=limits(wall_seconds=0.3)).stop is Stop.WALL
    assert run("1 / 0").detail == "ZeroDivisionError: division by zero (line 1)"
