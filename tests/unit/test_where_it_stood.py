"""A submission whose time is up is told where it stood, and how much of it was work; neither decides."""

from __future__ import annotations

import os
import re
import subprocess
import sys

import pytest
from sandboxed import LIMITS, require

from judge.sandbox import LEVELS, Stop, open_box
from judge.sandbox.inside import wire
from judge.sandbox.inside.server import Clocks

FUNCTION = b"def helper():\n    while True:\n        pass\n\n\ndef f(n):\n    return helper()\n"
PROGRAM = b"import sys\nsys.stdin.read()\nwhile True:\n    pass\n"
SHORT = LIMITS._replace(cpu_seconds=0.2, wall_seconds=20.0)

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform != "linux", reason="asks the kernel for another process's clock"),
]


def ended(source, bounds, level=None):
    with open_box(source, "mine.py", level=level) as box:
        box.inspect()
        if source is PROGRAM:
            result = box.run_program(b"1\n", bounds)
            return result.stop, result.detail
        reply = box.call("f", [(1,)], bounds).replies[-1]
        return reply.stop, reply.detail


@pytest.mark.parametrize("level", LEVELS)
@pytest.mark.parametrize(("source", "lines"), [(FUNCTION, "23"), (PROGRAM, "34")])
def test_an_endless_loop_says_its_line_at_every_level(source, lines, level):
    require(level)
    stop, detail = ended(source, SHORT, level)
    assert stop is Stop.CPU
    assert detail in [f"used more than 0.2 s of CPU time (line {line})" for line in lines]


def test_who_waits_is_said_to_wait_and_where():
    source = b"import time\ndef f(n):\n    time.sleep(99)\n"
    stop, detail = ended(source, LIMITS._replace(wall_seconds=0.3))
    assert stop is Stop.WALL
    assert re.fullmatch(r"took more than 0\.3 s, with 0\.0\d s of CPU time \(line 3\)", detail)
    stop, detail = ended(source, LIMITS._replace(waiting_seconds=0.3))
    assert stop is Stop.WAITING
    assert re.fullmatch(r"took 0\.\d\d s, with 0\.0\d s of CPU time \(line 3\)", detail)


@pytest.mark.skipif(not hasattr(os, "sched_setaffinity"), reason="needs processes kept to one core")
def test_what_a_busy_core_left_it_is_told():
    """Other processes have most of the core that all of this is kept to."""
    before = os.sched_getaffinity(0)
    burners = []
    try:
        os.sched_setaffinity(0, {min(before)})
        burners = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(3)]
        bounds = LIMITS._replace(cpu_seconds=60.0, wall_seconds=2.0)
        stop, detail = ended(FUNCTION, bounds)
    finally:
        for burner in burners:
            burner.kill()
            burner.wait()
        os.sched_setaffinity(0, before)
    assert stop is Stop.WALL
    used = re.fullmatch(r"took more than 2 s, with (\d\.\d\d) s of CPU time \(line [23]\)", detail)
    assert used is not None
    assert 0 < float(used[1]) < 2


@pytest.mark.parametrize(
    ("worked", "reason"), [(3.0, wire.NOT_KILLED), (2.0, wire.FOR_WAITING), (10.0, wire.FOR_CPU)]
)
def test_a_busy_core_is_not_waiting(worked, reason):
    """Of 3.5 s only those without CPU time count; 1 s of them may be."""
    second = 10**9
    request = wire.REQUEST.pack(wire.PROGRAM, 10 * second, 60 * second, second, 0, 0, 0, 0)
    clocks = Clocks(wire.Request(request, []), 0, 1)
    clocks.start(0)
    assert clocks.limit(round(worked * second), round(3.5 * second))[0] == reason


@pytest.mark.parametrize(
    "trick",
    [
        "signal.signal(signal.SIGUSR1, signal.SIG_IGN)",
        "signal.signal(signal.SIGUSR1, lambda *_: os.kill(os.getpid(), signal.SIGSTOP))",
        "sys.setrecursionlimit(60)",
    ],
)
def test_no_trick_with_the_signal_changes_how_it_ended(trick):
    source = f"import os, signal, sys\ndef f(n):\n    {trick}\n    while True: pass\n".encode()
    stop, detail = ended(source, SHORT)
    assert stop is Stop.CPU
    assert detail.startswith("used more than 0.2 s of CPU time")


def test_what_sleeps_is_stopped_whatever_its_handler_does():
    handler = "lambda *_: sum(range(10**6))"
    source = (
        f"import signal, time\ndef f(n):\n    signal.signal(signal.SIGUSR1, {handler})\n    time.sleep(99)\n"
    )
    stop, detail = ended(source.encode(), LIMITS._replace(wall_seconds=0.3))
    assert stop is Stop.WALL
    assert detail.startswith("took more than 0.3 s, with ")


@pytest.mark.parametrize(("line", "told"), [(7, ""), (10**9, ""), (6, " (line 6)")])
def test_a_line_that_is_not_there_is_not_told(line, told):
    """Any other is its own word, which decides nothing."""
    source = (
        b"""import signal, sys
def f(n):
    frame = sys._getframe()
    while "region" not in frame.f_locals: frame = frame.f_back
    signal.signal(signal.SIGUSR1, signal.SIG_IGN)
    while True: frame.f_locals["region"].words[3] = %d"""
        % line
    )
    assert ended(source, SHORT) == (Stop.CPU, f"used more than 0.2 s of CPU time{told}")


def test_an_answer_in_the_last_moment_comes_too_late():
    """The handler's own call returns: what it answers is not taken."""
    source = b"""
import signal
class Up(BaseException): pass
def up(*_): raise Up
def f(n):
    signal.signal(signal.SIGUSR1, up)
    try:
        while True: pass
    except Up:
        return 1
"""
    assert ended(source, SHORT)[0] is Stop.CPU
