"""Several series of calls in one process: each measured by itself, one lost call costs only itself."""

from __future__ import annotations

import sys

import pytest

from judge.sandbox import Limits, Stop, open_box

pytestmark = pytest.mark.slow

LIMITS = Limits(cpu_seconds=2.0, wall_seconds=10.0, memory_bytes=256 << 20, output_bytes=1 << 20)
SERIES = [[(1,), (2,)], [(3,)], [(4,), (5,), (6,)]]


def run(body, series=SERIES, limits=LIMITS, on_series=None):
    with open_box(body.encode(), "my.py") as box:
        return box.call_series("f", series, limits, on_series)


def answers(results):
    return [[reply.answer for reply in result.replies] for result in results]


def test_the_answers_come_series_by_series_and_each_but_the_last_is_told_of():
    told = []
    results = run("def f(n): return n * n", [[], *SERIES], on_series=lambda: told.append(len(told)))
    assert answers(results) == [[], [1, 4], [9], [16, 25, 36]]
    assert told == [0, 1, 2]


def test_each_series_is_measured_by_itself():
    body = "from time import process_time as t\ndef f(n):\n    end = t() + (0.5 if n == 3 else 0)\n"
    first, second, third = run(body + "    while t() < end: pass\n    return n")
    assert second.usage.cpu_seconds > 0.49
    assert max(first.usage.cpu_seconds, third.usage.cpu_seconds) < 0.25  # a busy machine takes its share
    assert second.usage.wall_seconds > 0.4


def test_the_time_limit_is_each_series_own():
    body = "from time import process_time as t\ndef f(n):\n    end = t() + 0.1\n    while t() < end: pass\n"
    limits = LIMITS._replace(cpu_seconds=0.2)
    results = run(body, [[(1,)], [(2,)], [(3,)], [(4,)]], limits)
    assert [result.replies[-1].stop for result in results] == [Stop.ANSWERED] * 4
    results = run(body, [[(1,)], [(2,), (3,), (4,)], [(5,)]], limits)
    assert [result.replies[-1].stop for result in results] == [Stop.ANSWERED, Stop.CPU]


def test_a_process_finds_nothing_of_the_one_before_it():
    body = """
import sys
def f(n):
    frame = sys._getframe()
    while "region" not in frame.f_locals:
        frame = frame.f_back
    memory = frame.f_locals["region"].memory
    found = memory.find(b"left by " + b"the last")
    if n == 1:
        memory[64 << 20 : (64 << 20) + 16] = b"left by " + b"the last"
    return found
"""
    with open_box(body.encode(), "my.py") as box:
        first, second, third = (
            box.call_many("f", calls, LIMITS).replies for calls in ([(0,), (1,), (0,)], [(0,)], [(0,)])
        )
    assert [reply.answer for reply in first] == [-1, -1, 64 << 20]
    assert [reply.answer for reply in (*second, *third)] == [-1, -1]


@pytest.mark.skipif(sys.platform != "linux", reason="a process a series elsewhere")
def test_the_series_that_takes_the_memory_is_blamed_for_it():
    results = run("def f(n):\n    if n == 3: bytearray(b'1') * (300 << 20)\n    return n")
    assert answers(results) == [[1, 2], [None]]
    assert results[1].replies[0].stop is Stop.MEMORY
    assert results[0].usage.memory_bytes < 100 << 20
    assert results[1].usage.memory_bytes > 300 << 20


@pytest.mark.skipif(sys.platform != "linux", reason="a process a series elsewhere")
def test_a_series_that_has_answered_all_and_is_too_slow_is_blamed_itself():
    body = "import time\ndef f(n):\n    if n == 3:\n        import os, threading\n"
    body += "        threading.Thread(target=lambda: [0 for _ in iter(int, 1)], daemon=True).start()\n"
    body += "        while time.process_time() < 0.3: time.sleep(0.01)\n    return n"
    results = run(body, limits=LIMITS._replace(cpu_seconds=0.1))
    assert [result.replies[-1].stop for result in results] == [Stop.ANSWERED, Stop.CPU]
