"""How a program in another language ended, in an order that it cannot bend.

Output comes first: some languages print on after the kernel has refused a write, and end as if nothing were.
Then what was measured, limits of memory before those of time; last what the program itself says.
"""

from __future__ import annotations

import os
import re
import signal

from judge.sandbox import outcome
from judge.sandbox.boundary import Limits, Stop, Usage
from judge.sandbox.container import Done
from judge.sandbox.inside import wire
from judge.sandbox.recipe import Recipe, Sources

_SHOWN = 200
_WORDS = re.compile(r"panic|Exception|[Ee]rror|terminate|what\(\)|fatal|Assertion")
_LINE = re.compile(r" \(line (\d{1,9})\)$")
_DEEP = " (did it call itself too deeply, or read past an array?)"


def end_of(
    done: Done, limits: Limits, idle: Usage, printed: int, stderr: bytes, recipe: Recipe
) -> tuple[Stop, str]:
    """Why it ended; `printed` is the longer of stdout and stderr, `idle` what its empty program costs."""
    signalled = os.WTERMSIG(done.status) if os.WIFSIGNALED(done.status) else 0
    allowed = f"{limits.memory_bytes >> 20} MB"
    if printed > limits.output_bytes or signalled == signal.SIGXFSZ:
        return Stop.OUTPUT, f"wrote more than {limits.output_bytes >> 20} MB"
    if done.peak_bytes > limits.memory_bytes + idle.memory_bytes:
        own = f", {idle.memory_bytes >> 20} of them {recipe.name}'s own" if idle.memory_bytes else ""
        return Stop.MEMORY, f"used more than {allowed}, {done.peak_bytes >> 20} MB seen{own}"
    spent = done.cpu_ns / 1e9 - idle.cpu_seconds
    if done.reason == wire.FOR_CPU or spent > limits.cpu_seconds or signalled == signal.SIGXCPU:
        return Stop.CPU, f"used more than {limits.cpu_seconds:g} s of CPU time"
    if done.reason == wire.FOR_BEING_SLOW:
        took = f"took {done.wall_ns / 1e9:.3g} s for {done.cpu_ns / 1e9:.2g} s of CPU time"
        return Stop.WALL, f"{took}: it was working, on a busy machine"
    if done.reason == wire.FOR_WALL:
        return Stop.WALL, f"took more than {limits.wall_seconds:g} s, waiting at the end"
    if done.reason == wire.FOR_WAITING:
        return Stop.WAITING, f"waited more than {limits.waiting_seconds:.3g} s"
    if os.WIFSTOPPED(done.status):
        return Stop.EXITED, outcome.STOPPED
    said = stderr.decode(errors="replace")
    if done.status and recipe.out_of_memory and recipe.out_of_memory in said:
        return Stop.MEMORY, f"asked for more memory than {allowed} allow"
    return _own_end(done, signalled, last_words(stderr))


def _own_end(done: Done, signalled: int, words: str) -> tuple[Stop, str]:
    more = f": {words}" if words else ""
    if signalled:
        try:
            name = signal.Signals(signalled).name
        except ValueError:
            name = f"signal {signalled}"
        return Stop.EXITED, f"killed by {name}{_DEEP if signalled == signal.SIGSEGV else ''}{more}"
    code = os.waitstatus_to_exitcode(done.status)
    return (Stop.EXITED, f"exit status {code}{more}") if code else (Stop.ANSWERED, "")


def last_words(stderr: bytes) -> str:
    """The line of its stderr that most likely says what went wrong, with what belongs to it; or ""."""
    lines = [wire.printable(line) for line in stderr.decode(errors="replace").splitlines()]
    place = next((at for at, line in enumerate(lines) if _WORDS.search(line)), None)
    if place is None:
        return ""
    found, *after = lines[place : place + 2]
    if after and (found.endswith(":") or after[0].startswith("what()")):
        found = f"{found} {after[0]}"
    return found[:_SHOWN]


def placed(detail: str, stderr: bytes, sources: Sources) -> str:
    """How it ended, with the line of the submission that its stderr tells.

    That is the first one in a trace that begins where it ended, and the last in one of Python's.
    """
    place = re.compile(rf'\b{re.escape(sources.own)}(?::|(", line ))(\d{{1,9}})')
    found = place.findall(stderr.decode(errors="replace"))
    if not found:
        return detail
    return within(f"{detail} (line {found[-1 if found[0][0] else 0][1]})", sources)


def within(detail: str, sources: Sources) -> str:
    """The same without a line at its end that the submission has not."""
    found = _LINE.search(detail)
    lines = dict(sources.files)[sources.own].count(b"\n") + 1
    return detail[: found.start()] if found and int(found[1]) > lines else detail
