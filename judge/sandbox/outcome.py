"""From what was measured and what the child said to how it ended, in an order that a submission cannot bend.

What the fork server and the kernel measured comes first: output, then memory, then time. What the child
itself says (a note, replies, an exit status) only decides between ends that are equally its own fault.
"""

from __future__ import annotations

import contextlib
import gc
import json
import os
import signal
from collections.abc import Callable, Iterator
from functools import partial
from itertools import repeat
from typing import Any

from judge.sandbox.boundary import Limits, Reply, Stop, Usage
from judge.sandbox.container import ChildEnd
from judge.sandbox.inside import wire

DETAIL_LENGTH = 1000
STOPPED = "stopped itself"
_TOO_DEEP, _TOO_DEEP_OR_FAR = (
    f" (did it call itself too deeply{more}?)" for more in ("", ", or read past an array")
)
_NOTHING = Usage()
LONG = 1 << 18  # bytes of replies that are parsed line by line: what is forged need not be parsed twice


_CRASHES = (
    *(signal.SIGSEGV, signal.SIGABRT, signal.SIGBUS, signal.SIGILL, signal.SIGFPE, signal.SIGTRAP),
    *(signal.SIGSYS, signal.SIGXCPU, signal.SIGXFSZ),
)


def is_from_outside(done: ChildEnd) -> bool:
    """Whether a signal has ended it that is no crash of its own: in trusted code, no fault of a source."""
    return os.WIFSIGNALED(done.status) and os.WTERMSIG(done.status) not in _CRASHES


def overrun(
    done: ChildEnd, limits: Limits, printed: int, lines: int = 0, idle: Usage = _NOTHING, name: str = ""
) -> tuple[Stop, str] | None:
    """The limit that was passed, if one was; `printed` is the longer of stdout and stderr.

    `lines` are those of its source; `idle` is what the empty program of its language, called so, costs.
    """
    signalled = os.WTERMSIG(done.status) if os.WIFSIGNALED(done.status) else 0
    kind, text = done.note
    place = f" (line {done.stood_at})" if 0 < done.stood_at <= lines else ""
    # Before all else: some print on after the kernel has refused a write, and end as if nothing were.
    if printed > limits.output_bytes or signalled == signal.SIGXFSZ:
        return Stop.OUTPUT, f"wrote more than {_size(limits.output_bytes)}"
    if done.peak_bytes > limits.memory_bytes + idle.memory_bytes:  # before the clock: filling takes time too
        own = f", {_size(idle.memory_bytes)} of them {name}'s own" if idle.memory_bytes else ""
        return Stop.MEMORY, f"used more than {_size(limits.memory_bytes)}, {_size(done.peak_bytes)} seen{own}"
    over_time = done.reason == wire.FOR_CPU or done.cpu_ns / 1e9 - idle.cpu_seconds > limits.cpu_seconds
    if over_time or signalled == signal.SIGXCPU:
        return Stop.CPU, f"used more than {limits.cpu_seconds:g} s of CPU time{place}"
    used = f"{done.cpu_ns / 1e9:.2f} s of CPU time"  # whether it waited, or a busy machine let it wait
    if done.reason == wire.FOR_WALL:
        return Stop.WALL, f"took more than {limits.wall_seconds:g} s, with {used}{place}"
    if done.reason == wire.FOR_WAITING:
        return Stop.WAITING, f"took {done.wall_ns / 1e9:.2f} s, with {used}{place}"
    if kind == wire.NO_MEMORY:
        return Stop.MEMORY, text or f"asked for more memory than {_size(limits.memory_bytes)} allow"
    return (Stop.OUTPUT, text) if kind == wire.TOO_MUCH else None


def end_of(done: ChildEnd, words: str | None = None) -> tuple[Stop, str]:
    """How a process that kept its limits ended; `words` are the last of one that is no Python."""
    kind, text = done.note
    more = f": {words}" if words else ""
    if os.WIFSIGNALED(done.status):
        number = os.WTERMSIG(done.status)
        deep = _TOO_DEEP if words is None else _TOO_DEEP_OR_FAR
        return (
            Stop.EXITED,
            f"killed by {_signal_name(number)}{deep if number == signal.SIGSEGV else ''}{more}",
        )
    if os.WIFSTOPPED(done.status):
        return Stop.EXITED, STOPPED
    code = os.waitstatus_to_exitcode(done.status)
    if kind == wire.RAISED:
        return Stop.EXCEPTION, text
    return Stop.EXITED if code else Stop.ANSWERED, f"exit status {code}{more}"


def parse_replies(data: bytes, most: int) -> tuple[list[Reply], bool]:
    """The replies in a child's own words, and whether it kept to the form: `most` JSON texts or fewer."""
    if len(data) > LONG:
        with _no_collections():
            return _one_by_one(data, most)
    try:
        rows = _parsed(b"[" + data[:-2] + b"]")
    except (ValueError, RecursionError):
        return _one_by_one(data, most)
    replies = _replies(rows)
    kept_form = len(replies) == len(rows) == data.count(b"\n") <= most
    return (replies, True) if kept_form else _one_by_one(data, most)


@contextlib.contextmanager
def _no_collections() -> Iterator[None]:
    """Millions of fresh lists, as only a flood holds, take several times as long where each is looked at."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


def _replies(rows: list[Any]) -> list[Reply]:
    """The rows as replies, up to the first that is none."""
    if set(map(type, rows)) == {list} and set(map(len, rows)) == {2}:
        kinds, values = zip(*rows, strict=True)
        if set(map(type, kinds)) == {int} and not any(kinds):  # all have answered, as nearly always
            return list(map(_reply, zip(repeat(Stop.ANSWERED), values, repeat(""))))
    replies: list[Reply] = []
    add, answered = replies.append, Stop.ANSWERED
    for row in rows:
        if type(row) is not list or len(row) != 2:
            break
        kind, value = row
        if kind == 0:
            add(Reply(answered, value))
        elif kind == 1 and type(value) is str:
            replies.append(Reply(Stop.EXCEPTION, None, wire.printable(value[:DETAIL_LENGTH])))
        else:
            break
    return replies


def _one_by_one(data: bytes, most: int) -> tuple[list[Reply], bool]:
    """The replies up to the first that is none."""
    replies: list[Reply] = []
    *lines, rest = data.split(b"\n", most + 1)
    for line in lines:
        try:
            found = _replies([_parsed(line.removesuffix(b","))])
        except (ValueError, RecursionError):
            return replies, False
        if len(replies) == most or not found:
            return replies, False
        replies += found
    return replies, not rest


def _refuse(name: str) -> Any:
    raise ValueError(f"{name} is not JSON")


_reply: Callable[[tuple[Any, ...]], Reply] = partial(tuple.__new__, Reply)
_decode = json.JSONDecoder(parse_constant=_refuse).decode


def _parsed(data: bytes) -> Any:
    """A JSON text. Raises ValueError, RecursionError."""
    return _decode(data.decode(errors="surrogatepass"))


def _signal_name(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


def _size(count: int) -> str:
    return f"{count >> 20} MB" if count >= 1 << 20 else f"{count} bytes"
