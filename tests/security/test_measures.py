"""CPU time, memory and output as seen from outside, whatever the submission does to look better."""

from __future__ import annotations

import resource

import pytest

from judge.sandbox import open_box
from judge.sandbox.boundary import Limits, Stop

LIMITS = Limits(cpu_seconds=5.0, wall_seconds=20.0, memory_bytes=256 << 20, output_bytes=1 << 20)
SPIN = """
import threading, time
def spin(seconds):
    end = time.thread_time() + seconds
    while time.thread_time() < end:
        pass
"""
BACKGROUND = f"""{SPIN}
def f(x):
    if x == 1:
        threading.Thread(target=spin, args=(0.2,)).start()
    else:
        threading.enumerate()[-1].join()
    return x
"""
LIES = f"""{SPIN}
import builtins, resource, sys
def f(x):
    spin(0.15)
    for name in list(vars(time)):
        if not name.startswith("_"):
            setattr(time, name, lambda *_: 0)
    resource.getrusage = lambda *_: None
    frame = sys._getframe(1)
    while frame:
        for name, value in list(frame.f_locals.items()):
            if isinstance(value, (int, float)):
                frame.f_locals[name] = 0
        frame = frame.f_back
    return x
"""


def test_a_loop_is_charged_what_it_takes(level: str) -> None:
    with open_box((SPIN + "def f(x):\n    spin(0.2)\n    return x\n").encode(), "f.py", level=level) as box:
        usage = box.call("f", [[1]], LIMITS).usage
        assert 0.19 < usage.cpu_seconds < 0.4  # a busy machine takes its share


def test_a_thread_that_works_between_the_calls_is_charged(level: str) -> None:
    with open_box(BACKGROUND.encode(), "f.py", level=level) as box:
        assert box.call("f", [[1], [2]], LIMITS).usage.cpu_seconds > 0.18
        tight = LIMITS._replace(cpu_seconds=0.1)
        assert box.call("f", [[1], [2]], tight).replies[-1].stop is Stop.CPU


def test_patched_clocks_and_rewritten_frames_change_nothing(level: str) -> None:
    with open_box(LIES.encode(), "f.py", level=level) as box:
        result = box.call("f", [[1]], LIMITS)
        assert result.usage.cpu_seconds > 0.14


def test_sleeping_is_not_working(level: str) -> None:
    with open_box(b"import time\ndef f(x):\n    time.sleep(0.2)\n    return x\n", "f.py", level=level) as box:
        usage = box.call("f", [[1]], LIMITS).usage
        assert usage.cpu_seconds < 0.1
        assert usage.wall_seconds >= 0.2


def test_a_cpu_limit_is_kept_closely(level: str) -> None:
    tight = LIMITS._replace(cpu_seconds=0.1)
    with open_box(b"while True: pass", "f.py", level=level) as box:
        runs = [box.run_program(b"", tight) for _ in range(3)]
        assert {run.stop for run in runs} == {Stop.CPU}
        assert min(run.usage.cpu_seconds for run in runs) <= 0.2


@pytest.mark.parametrize("make", ["[0] * (12 << 20)", "bytearray(b'x') * (96 << 20)", "numpy.ones(12 << 20)"])
def test_memory_is_what_was_touched(level: str, make: str) -> None:
    if "numpy" in make:
        pytest.importorskip("numpy")
    preface = "import numpy\n" if "numpy" in make else ""
    with open_box(f"{preface}x = {make}\n".encode(), "f.py", level=level) as box:
        inside = box.run_program(b"", LIMITS)
        assert inside.stop is Stop.ANSWERED, inside
        assert 96 << 20 < inside.usage.memory_bytes < 200 << 20
        small = LIMITS._replace(memory_bytes=64 << 20)
        assert box.run_program(b"", small).stop is Stop.MEMORY


def test_output_up_to_the_limit_is_fine_and_one_more_is_not(level: str) -> None:
    with open_box(b"import sys\nsys.stdout.write('x' * int(input()))\n", "f.py", level=level) as box:
        full = box.run_program(b"1048576\n", LIMITS)
        assert (full.stop, len(full.stdout)) == (Stop.ANSWERED, 1 << 20)
        assert box.run_program(b"1048577\n", LIMITS).stop is Stop.OUTPUT


def test_named_modules_are_imported_ahead_and_not_charged(level: str) -> None:
    pytest.importorskip("numpy")
    with open_box(
        b"import numpy as np\ndef f(x):\n    return float(np.sum([x]))\n", "f.py", level=level
    ) as box:
        result = box.call("f", [[2]], LIMITS)
        assert result.replies[0].answer == 2.0
        assert min(box.call("f", [[2]], LIMITS).usage.cpu_seconds for _ in range(3)) < 0.1


def test_blas_does_not_start_threads(level: str) -> None:
    pytest.importorskip("numpy")
    source = (
        b"import os, numpy\nprint(os.environ['OPENBLAS_NUM_THREADS'], numpy.eye(9).dot(numpy.eye(9))[0, 0])\n"
    )
    with open_box(source, "f.py", level=level) as box:
        assert box.run_program(b"", LIMITS).stdout == b"1 1.0\n"


def test_threads_that_allocate_leave_the_memory_to_the_rest(level: str) -> None:
    """Each would reserve 64 MB of the address space for itself."""
    source = b"""
import threading
on = threading.Event()
kept = []
threads = [threading.Thread(target=lambda: (kept.append(bytes(1000)), on.wait())) for _ in range(24)]
for thread in threads: thread.start()
more = bytearray(200 << 20)
on.set()
"""
    with open_box(source, "f.py", level=level) as box:
        ended = box.run_program(b"", LIMITS)
    assert ended.stop is Stop.ANSWERED, ended


def test_the_order_of_a_set_is_the_same_in_each_box(level: str) -> None:
    printed = set()
    for _ in range(2):
        with open_box(b"print({'a', 'b', 'c', 'd', 'e', 'f', 'g'})", "f.py", level=level) as box:
            printed.add(box.run_program(b"", LIMITS).stdout)
    assert len(printed) == 1


def test_an_ordinary_program_meets_no_surprise(level: str) -> None:
    source = (
        b"import asyncio, decimal, fractions, heapq, sys, tempfile, threading\n"
        b"threads = [threading.Thread(target=int) for _ in range(20)]\n"
        b"for thread in threads: thread.start()\n"
        b"for thread in threads: thread.join()\n"
        b"async def main(): await asyncio.sleep(0.001); return 5\n"
        b"sys.setrecursionlimit(20000)\n"
        b"def deep(n): return n and 1 + deep(n - 1)\n"
        b"print(asyncio.run(main()), deep(15000), __name__, len(sys.argv), open(0).read().strip())\n"
        b"exit()\n"
    )
    with open_box(source, "f.py", level=level) as box:
        result = box.run_program(b"in\n", LIMITS)
        assert result.stdout == b"5 15000 __main__ 1 in\n", result


HARD = resource.getrlimit(resource.RLIMIT_STACK)[1]


@pytest.mark.skipif(HARD != resource.RLIM_INFINITY, reason="the stack is bounded here")
def test_the_stack_may_grow_beyond_what_it_is_at_first(level: str) -> None:
    """Through C each level of a recursion needs some of it, 8 MB in all as most systems begin."""
    source = b"""
import sys
sys.setrecursionlimit(10**6)
def deep(n): return n and 1 + max(map(deep, [n - 1]))
print(deep(40_000))
"""
    with open_box(source, "f.py", level=level) as box:
        ended = box.run_program(b"", LIMITS)
    assert (ended.stop, ended.stdout) == (Stop.ANSWERED, b"40000\n"), ended.detail
