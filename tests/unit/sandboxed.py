"""Limits for tests of the sandbox, and a short way to call one function in it."""

from __future__ import annotations

from dataclasses import replace

from judge.sandbox import Limits, open_box

LIMITS = Limits(cpu_seconds=5.0, wall_seconds=20.0, memory_bytes=256 << 20, output_bytes=1 << 20)


def limits(**changes):
    return replace(LIMITS, **changes)


def call(source, calls, within=LIMITS, entry="f"):
    with open_box(source.encode(), "my.py") as box:
        return box.call_many(entry, calls, within)


def run(source, stdin=b"", within=LIMITS):
    with open_box(source.encode(), "my.py") as box:
        return box.run_program(stdin, within)
