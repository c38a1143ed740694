"""Limits for tests of the sandbox, and a short way to call one function in it."""

from __future__ import annotations

import os
from functools import cache
from pathlib import Path

import pytest

from judge.sandbox import Limits, open_box
from judge.sandbox.available import levels_here

LIMITS = Limits(cpu_seconds=5.0, wall_seconds=20.0, memory_bytes=256 << 20, output_bytes=1 << 20)


def limits(**changes):
    return LIMITS._replace(**changes)


def call(source, calls, within=LIMITS, entry="f", level=None):
    with open_box(source.encode(), "my.py", level=level) as box:
        return box.call(entry, calls, within)


def run(source, stdin=b"", within=LIMITS, level=None):
    with open_box(source.encode(), "my.py", level=level) as box:
        return box.run_program(stdin, within)


def lost_at_3(body, within=LIMITS, level=None):
    """The reply of call 3, whose body is given; the calls before and after it must be answered."""
    source = (
        f"import os, signal, sys, threading, time\ndef f(n):\n    if n == 3:\n        {body}\n    return n\n"
    )
    with open_box(source.encode(), "my.py", level=level) as box:
        before = box.call("f", [(n,) for n in range(6)], within).replies
        after = box.call("f", [(n,) for n in range(len(before), 6)], within).replies
    assert [reply.answer for reply in before[:3]] == [0, 1, 2]
    assert [reply.answer for reply in after] == [4, 5]
    return before[3]


def children():
    """The pids of this process's children, whichever thread started them."""
    mine = str(os.getpid())
    return {path.name for path in Path("/proc").iterdir() if path.name.isdecimal() and _parent(path) == mine}


def _parent(path):
    try:
        return (path / "stat").read_text().rpartition(")")[2].split()[1]
    except OSError:
        return ""  # it has just ended


@cache
def _levels_here():
    return {level.name: level for level in levels_here()}


def require(level):
    """Skip the test where this machine does not give the level."""
    found = _levels_here()[level]
    if not found.available:
        pytest.skip(found.why_not)
