"""The plainest containment: a child process of its own session, bounded by resource limits ("limits").

It bounds time, memory and output and keeps the judge's data out of reach of the submission's process memory
and working folder. It does not hide the file system or the network.
"""

from __future__ import annotations

import json
import re
import shutil
import tempfile
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from judge.sandbox.boundary import (
    CallsResult,
    Inspection,
    Limits,
    ProgramResult,
    Reply,
    SourceFault,
    Stop,
    Usage,
)
from judge.sandbox.worker import HangupError, Worker, describe_status, limits_tuple

STDERR_BYTES = 4096
FRAME_SECONDS = 1.0  # for a short frame whose first byte is there
END_SECONDS = 0.5  # for a process that has hung up to end by itself
INSPECT_LIMITS = Limits(cpu_seconds=10.0, wall_seconds=30.0, memory_bytes=1 << 30, output_bytes=1 << 20)


class ProcessBox:
    """A `Box` of plain child processes: one for all calls while it lives, one for each program run."""

    isolation = "limits"

    def __init__(self, source: bytes, name: str, python: str) -> None:
        self._source = source
        self._name = name
        self._python = python
        self._folder = ""
        self._worker: Worker | None = None
        self._bounds: tuple[int, int] | None = None  # memory and output limits the worker has taken on
        self._inspection: Inspection | None = None

    def __enter__(self) -> ProcessBox:
        self._folder = tempfile.mkdtemp(prefix="judge-")
        return self

    def __exit__(self, *exc: object) -> None:
        try:
            self._drop()
        finally:
            shutil.rmtree(self._folder, ignore_errors=True)

    def inspect(self) -> Inspection:
        """Parse and compile the source in a child, without running it."""
        if self._inspection is None:
            if self._bounds:
                self._drop()  # foreign code has run in this one
            self._inspection = self._inspect(self._worker or self._spawn())
        return self._inspection

    def _inspect(self, worker: Worker) -> Inspection:
        worker.send(b"I", ())
        stop = worker.watch(INSPECT_LIMITS, program=False)
        try:
            if stop:
                raise HangupError
            _, payload = worker.receive(INSPECT_LIMITS.wall_seconds)
        except HangupError:
            if stop is None:
                worker.ended(END_SECONDS)
            status = worker.end()
            self._drop()
            return Inspection(SourceFault(_compiler_end(stop, status)))
        worker.used()
        found = json.loads(payload)
        fault = SourceFault(*found["fault"]) if found["fault"] else None
        return Inspection(fault, tuple((name, line) for name, line in found["names"]))

    def call_many(self, entry: str, calls: Sequence[Sequence[Any]], limits: Limits) -> CallsResult:
        """Make the calls in one child; see `Box.call_many`."""
        if not calls:
            return CallsResult((), Usage())
        worker = self._for_calls(limits)
        stop: Stop | None = None
        done = False
        try:
            worker.send(b"C", (entry, limits_tuple(limits), [_plain(arguments) for arguments in calls]))
            stop = worker.watch(limits, program=False)
            if stop is None:
                done = worker.receive(FRAME_SECONDS) == (b"D", b"%d" % len(calls)) and worker.silent()
                stop = None if done else Stop.TAMPERED
        except HangupError:
            stop = None if worker.ended(END_SECONDS) else Stop.TAMPERED  # alive, but it took its channel away
        status = 0 if done and worker.reusable else worker.end()
        usage = worker.used()
        replies = _replies(worker.answers.head(limits.output_bytes + 1))
        stop = _overrun(worker, usage, limits) or stop
        if len(replies) > len(calls) or (done and len(replies) < len(calls)):
            stop = Stop.TAMPERED
        if not _ends(replies) and (stop or len(replies) < len(calls)):
            last = _last(stop, status, usage, limits, worker.errors.tail(STDERR_BYTES))
            if len(replies) >= len(calls) > 1:
                last = replace(last, detail=f"{last.detail}, in this call or one before it")
            replies = [*replies[: len(calls) - 1], last]
        if _ends(replies) or not worker.reusable:
            self._drop()
        return CallsResult(tuple(replies), usage)

    def run_program(self, stdin: bytes, limits: Limits) -> ProgramResult:
        """Run the source as `__main__` in a process of its own; see `Box.run_program`."""
        worker = Worker(self._python, self._folder, stdin)
        try:
            worker.send(b"S", (self._name, self._source))
            worker.send(b"P", (limits_tuple(limits),))
            stop = worker.watch(limits, program=True)
            status = worker.end()
            usage = worker.used()
            stderr = worker.errors.tail(STDERR_BYTES)
            last = _last(_overrun(worker, usage, limits) or stop, status, usage, limits, stderr)
            if last.stop is Stop.EXITED and (error := _uncaught(stderr, self._name)):
                last = Reply(Stop.EXCEPTION, detail=error)
            elif last.stop is Stop.EXITED and status == 0:
                last = Reply(Stop.ANSWERED)
            stdout = worker.output.head(limits.output_bytes)
            return ProgramResult(last.stop, stdout, stderr, last.detail, usage)
        finally:
            worker.close()

    def _spawn(self) -> Worker:
        self._worker = Worker(self._python, self._folder)
        self._bounds = None
        self._worker.send(b"S", (self._name, self._source))
        return self._worker

    def _for_calls(self, limits: Limits) -> Worker:
        bounds = (limits.memory_bytes, limits.output_bytes)
        worker = self._worker
        used = self._bounds is not None
        if worker and ((used and (self._bounds != bounds or not worker.reusable)) or not worker.silent()):
            self._drop()
            worker = None
        worker = worker or self._spawn()
        self._bounds = bounds
        for capture in (worker.answers, worker.output, worker.errors):
            capture.clear()
        return worker

    def _drop(self) -> None:
        if self._worker:
            self._worker.close()
        self._worker = None
        self._bounds = None


def _plain(arguments: Sequence[Any]) -> tuple[Any, ...]:
    """The arguments as plain values of the interpreter; inner sequences become tuples."""
    return tuple([_plain(item) if type(item) in (tuple, list) else item for item in arguments])


def _no_constant(name: str) -> float:
    raise ValueError(f"{name} is not JSON")


_FORGED = Reply(Stop.TAMPERED, detail="an answer that is not in the judge's own form")
_DECODER = json.JSONDecoder(parse_constant=_no_constant)


def _replies(text: bytes) -> list[Reply]:
    """The replies in the lines of an answers file, up to the first that ends the series."""
    replies: list[Reply] = []
    *lines, _unfinished = text.split(b"\n")
    for line in lines:
        replies.append(_reply(line))
        if _ends(replies):
            break
    return replies


def _reply(line: bytes) -> Reply:
    try:
        text = line.decode("ascii")
        value, end = _DECODER.raw_decode(text, 1)
    except (ValueError, RecursionError):
        return _FORGED
    if end != len(text):
        return _FORGED
    if line.startswith(b"A"):
        return Reply(Stop.ANSWERED, value)
    if not isinstance(value, str) or line[:1] not in (b"E", b"M"):
        return _FORGED
    return Reply(Stop.EXCEPTION if line.startswith(b"E") else Stop.MEMORY, detail=value)


def _ends(replies: Sequence[Reply]) -> bool:
    return bool(replies) and replies[-1].stop not in (Stop.ANSWERED, Stop.EXCEPTION)


def _overrun(worker: Worker, usage: Usage, limits: Limits) -> Stop | None:
    """The limit that was passed, looked at when all is over."""
    if worker.flooded(limits):
        return Stop.OUTPUT
    if usage.memory_bytes > limits.memory_bytes:
        return Stop.MEMORY
    return Stop.CPU if usage.cpu_seconds > limits.cpu_seconds else None


def _last(stop: Stop | None, status: int, usage: Usage, limits: Limits, stderr: bytes) -> Reply:
    """The end of what did not answer, with its reason for a person."""
    if stop is None and status and _last_line(stderr).startswith("MemoryError"):
        stop = Stop.MEMORY  # the address space ended before the resident size was seen to pass the limit
    if stop is Stop.CPU:
        return Reply(stop, detail=f"used more than {limits.cpu_seconds:g} s of CPU time")
    if stop is Stop.WALL:
        return Reply(stop, detail=f"took more than {limits.wall_seconds:g} s, waiting most of it")
    if stop is Stop.MEMORY:
        peak = f", {usage.memory_bytes >> 20} MB seen" if usage.memory_bytes > limits.memory_bytes else ""
        return Reply(stop, detail=f"used more than {limits.memory_bytes >> 20} MB{peak}")
    if stop is Stop.OUTPUT:
        return Reply(stop, detail=f"wrote more than {_size(limits.output_bytes)}")
    if stop is Stop.TAMPERED:
        return Reply(stop, detail="wrote on the judge's own channel")
    return Reply(Stop.EXITED, detail=describe_status(status))


def _size(count: int) -> str:
    return f"{count >> 20} MB" if count >= 1 << 20 else f"{count} bytes"


def _last_line(stderr: bytes) -> str:
    lines = stderr.decode("utf-8", errors="replace").strip().splitlines()
    return lines[-1] if lines else ""


def _uncaught(stderr: bytes, name: str) -> str:
    """The uncaught exception that a program's stderr ends with, with its line, or nothing."""
    text = stderr.decode("utf-8", errors="replace")
    *_, last = [None, *re.finditer(rf'^  File "{re.escape(name)}", line (\d+)', text, re.MULTILINE)]
    # Below the frames, which are indented, stands the exception; its own text may have several lines.
    found = re.search(r"^[^\W\d][\w.]*(: .*)?$", text[last.end() :], re.MULTILINE) if last else None
    return f"{found[0][:500]} (line {last[1]})" if last and found else ""


def _compiler_end(stop: Stop | None, status: int) -> str:
    if stop is None:
        return f"the compiler did not survive it: {describe_status(status)}"
    return "it takes too much memory to compile" if stop is Stop.MEMORY else "it takes too long to compile"
