"""A submission in one container after the other, and how its processes ended; the box of Python.

A container is started at once or when it is needed, tried again, and replaced where it has ended. Once
foreign code runs nothing that it says is believed: what was measured comes first; see `outcome`.
"""

from __future__ import annotations

import contextlib
import errno
import json
import os
import signal
from abc import ABC, abstractmethod
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from judge.errors import LIMIT_ON_TASKS, NO_THREAD, JudgeError, ShortageError, shortage_of
from judge.sandbox import launch, outcome, parcels, room
from judge.sandbox.boundary import (
    IMPORTING,
    CallsResult,
    Inspection,
    Limits,
    ProgramResult,
    Reply,
    SourceFault,
    Stop,
    Talk,
    Usage,
)
from judge.sandbox.calls import packed
from judge.sandbox.container import ChildEnd, Container, Lost
from judge.sandbox.inside import wire
from judge.sandbox.levels import StartError

if TYPE_CHECKING:
    from judge.sandbox.dialogue import Dialogue
    from judge.sandbox.factory import Containment

BUSY = "judge it again, with a smaller -j if the machine is busy"
_PATIENCE = 5.0  # seconds, with a talk whose program is gone
LOST = "it stopped the process that watches it"
PRINTED_BYTES = 4 << 10  # of what a function prints that are kept
_INSPECTION = Limits(cpu_seconds=10.0, wall_seconds=30.0, memory_bytes=1 << 30, output_bytes=1 << 22)
_ADDRESS_SPACE = 256 << 20  # beyond twice the memory limit: honest numpy reserves far more than it touches
_TRUSTED_TRIES = 2
_FAILED = "the container failed"


class ContainerBox(ABC):
    """A submission in a container; a context manager that ends it all.

    One thread at a time may use it, whichever opened it.
    """

    stderr_bytes = 4096  # of its end

    def __init__(self, boxes: Containment) -> None:
        """`boxes` says at which level it is held, and what it may have."""
        self._boxes = boxes
        self.isolation = ""  # the level that holds it, as long as no container was made none
        self._prepared = False  # whether the container has compiled the source
        self._inspection: Inspection | None = None
        self._oom_kills = room.oom_kills()
        self._closed = False
        self._container: Container | None = None
        self._dialogue: Dialogue | None = None  # with the program that is run

    def __exit__(self, *exc: object) -> None:
        self._closed = True
        self._drop()

    def inspect(self) -> Inspection:
        """Parse and compile the source, without running it."""
        if self._inspection is None:
            self._inspection = self._inspect()
        return self._inspection

    def run_program(self, stdin: bytes | Talk, limits: Limits) -> ProgramResult:
        """Run the source as a program, in a process of its own; see `Box.run_program`."""
        if fault := self._prepare():
            return ProgramResult(Stop.EXCEPTION, b"", b"", fault, Usage())
        try:
            with parcels.files(stdin if isinstance(stdin, bytes) else b"", b"", b"") as stdio:
                if isinstance(stdin, bytes):
                    done = self._run(stdio, limits)
                    printed, out = parcels.size(stdio[1]), parcels.part(stdio[1], 0, limits.output_bytes)
                else:
                    done, printed, out = self._talked(stdin, stdio[2], limits)
                printed = max(printed, parcels.size(stdio[2]))
                err = parcels.tail(stdio[2], self.stderr_bytes)
        except Lost:
            return ProgramResult(Stop.TAMPERED, b"", b"", LOST, Usage())
        done, words = self._said(done, err)
        stop, detail = self._overrun(done, limits, printed) or outcome.end_of(done, words)
        detail = "" if stop is Stop.ANSWERED else detail
        return ProgramResult(stop, out, err, self._with_threads(detail), done.usage)

    def _talked(self, talk: Talk, stderr: int, limits: Limits) -> tuple[ChildEnd, int, bytes]:
        """Run the program while it is talked with: how much it wrote, and what nobody has heard."""
        from judge.sandbox.dialogue import Dialogue  # few programs are talked with

        self._dialogue = dialogue = Dialogue(talk, limits.output_bytes)
        try:
            done = self._run((*dialogue.ends, stderr), limits)
        finally:
            self._dialogue = None
            dialogue.end(max(_PATIENCE, limits.wall_seconds))
        if dialogue.fault is not None:
            raise dialogue.fault
        return done, dialogue.printed, dialogue.unheard

    @abstractmethod
    def _inspect(self) -> Inspection:
        """Look at the source."""

    @abstractmethod
    def _prepare(self) -> str:
        """Make ready for runs; the source's fault, or nothing."""

    @abstractmethod
    def _run(self, stdio: Sequence[int], limits: Limits) -> ChildEnd:
        """Run the program. Raises Lost."""

    def _said(self, done: ChildEnd, stderr: bytes) -> tuple[ChildEnd, str]:  # noqa: ARG002
        """Its end with what a program says of that, and words."""
        return done, ""

    # -- the container

    @abstractmethod
    def _start(self, level: str) -> Container:
        """Start a container. Raises StartError."""

    def _here(self) -> Container:
        """The running container, ready for a request. Raises as `Levels.open`, and Lost once it is closed."""
        return self._boxes.levels.open(self._ready)

    def _ready(self, level: str) -> Container:
        if self._closed:
            raise Lost
        if self._container is None or self.isolation != level:
            self._drop()
            self.isolation = level
            self._container = self._start(level)
        try:
            self._container.await_ready()
        except JudgeError:
            self._container = None
            raise
        return self._container

    def _drop(self) -> None:
        """End the container; the next request starts another."""
        container, self._container = self._container, None
        self._prepared = False
        if container is not None:
            container.close()

    def _ask(
        self, kind: bytes, stdio: Sequence[int], payload: bytes, limits: Limits, memory: int, what: str
    ) -> ChildEnd:
        """One request; whatever goes wrong on this side of it, Ctrl-C included, ends the container.

        `memory` is what the process may have in all; `what` is said where trusted code has failed.
        """
        runs = kind in (wire.CALLS, wire.PROGRAM, wire.EXECUTE)
        if runs:
            room.check_memory(memory)
        try:
            container = self._here()
            begun = partial(self._dialogue.begin, container.stop) if self._dialogue else None
            if kind == wire.INSPECT:  # which it was asked when it was started
                done = container.answer(limits)
            else:
                done = container.ask(kind, stdio, payload, limits, memory, begun)
        except BaseException as fault:
            self._drop()
            if isinstance(fault, Lost):
                self._check_kills()
                if runs and (not fault.asked or self.isolation != "limits"):  # beyond its reach
                    raise ShortageError("the process that watches it has ended", remedy=BUSY) from None
            raise
        note, text = done.note
        # Once foreign code runs, notes are its own; what is no Python has no way to write any.
        if note == wire.BROKEN_BOX and (done.stage == wire.NOT_STARTED or kind == wire.EXECUTE):
            self._drop()
            raise shortage_of(done.code, what) if done.code else ShortageError(f"{what}: {text}", remedy=BUSY)
        killed = os.WIFSIGNALED(done.status) and os.WTERMSIG(done.status) == signal.SIGKILL
        if killed and not self._overrun(done, limits, 0):
            self._check_kills()
        return done

    def _check_kills(self) -> None:
        """Raise ShortageError if the kernel has killed anything for want of memory since this was opened."""
        if room.oom_kills() != self._oom_kills:
            raise shortage_of(errno.ENOMEM, "the kernel has killed the submission's process")

    # -- how it ended

    @abstractmethod
    def _overrun(self, done: ChildEnd, limits: Limits, printed: int) -> tuple[Stop, str] | None:
        """The limit that was passed, if one was; see `outcome.overrun`."""

    def _with_threads(self, detail: str) -> str:
        """What it says of its own end, with how many threads it may have where that is fewer than elsewhere.

        Whether it wanted more is its own word, which decides nothing.
        """
        share = self._boxes.share
        if not share.short or NO_THREAD not in detail:
            return detail
        most = f"it may have {share.each} threads at once here, and not {room.THREADS} as elsewhere"
        return f"{detail}; {most}: {LIMIT_ON_TASKS}"


class PythonBox(ContainerBox):
    """The container is started at once, where the source is looked at and its modules are imported, and
    awaited on entering, so that a judge may do other things meanwhile.
    """

    def __init__(self, boxes: Containment, source: bytes, name: str) -> None:
        """Start a container ahead; what goes wrong with that shows when it is asked for."""
        super().__init__(boxes)
        self._source, self._name = source, name
        self._lines = len(source.splitlines())
        self.isolation = boxes.levels.level
        with contextlib.suppress(StartError):
            self._container = self._start(self.isolation)

    def _start(self, level: str) -> Container:
        plan = partial(launch.plan, level, self._name, self._boxes.visible(), self._boxes.share)
        return Container(level, self._source, plan, self._boxes.seeds, _INSPECTION)

    def __enter__(self) -> PythonBox:
        self._here()
        return self

    def _inspect(self) -> Inspection:
        done = self._opened()
        replies = self._here().replies()
        over = self._overrun(done, _INSPECTION, 0)
        if done.reason not in (wire.NOT_KILLED, wire.FOR_CPU):  # no compiler waits
            self._drop()
            raise ShortageError("the machine is too busy to compile it", remedy=BUSY)
        if over or done.status or not replies.endswith(b",\n"):
            text = over[1] if over else outcome.end_of(done)[1]
            return Inspection(SourceFault(f"the compiler did not survive it: {text}"))
        return Inspection.read(json.loads(replies.removesuffix(b",\n")))

    def _opened(self) -> ChildEnd:
        """How a container's look at the source ended, where nothing foreign has run: what is lost or killed
        then, the machine has lost.
        """
        for _ in range(_TRUSTED_TRIES):
            try:
                done = self._ask(wire.INSPECT, (), b"", _INSPECTION, 0, _FAILED)
            except Lost:
                continue
            if done.reason or not outcome.is_from_outside(done):
                self._prepared = True
                return done
            self._drop()
        raise ShortageError("the container ended before the submission was run", remedy=BUSY)

    def call(self, entry: str, calls: Sequence[Sequence[Any]], limits: Limits) -> CallsResult:
        """Make the calls in one child; see `Box.call`."""
        if not calls:
            return CallsResult((), Usage())
        if fault := self._prepare():
            return CallsResult((Reply(Stop.EXCEPTION, detail=fault),) * len(calls), Usage())
        head, arguments = packed(entry, calls, limits.items)
        try:
            with parcels.files(b"", b"", b"", arguments) as stdio:
                del arguments  # which may be large
                done = self._request(wire.CALLS, stdio if wire.PAUSES else stdio[:3], head, limits)
                printed = max(map(parcels.size, stdio[1:3]))
                text = parcels.part(stdio[1], done.printed_bytes, PRINTED_BYTES)
        except Lost as lost:
            kept = outcome.parse_replies(lost.replies, len(calls))[0][: len(calls) - 1]
            return CallsResult((*kept, Reply(Stop.TAMPERED, detail=LOST)), Usage(0, lost.wall_ns / 1e9))
        replies = self._ended(done, limits, printed, len(calls))
        text = text if done.stage == wire.CALLING else b""
        if self._boxes.share.short:
            replies = [each._replace(detail=self._with_threads(each.detail)) for each in replies]
        return CallsResult(tuple(replies), done.usage, done.imported, text)

    def _ended(self, done: ChildEnd, limits: Limits, printed: int, count: int) -> list[Reply]:
        """The replies of a child that is gone; the last says how it ended if it did not answer all."""
        replies, kept_form = outcome.parse_replies(self._here().replies(), count)
        if done.stage != wire.CALLING and any(reply.stop is Stop.ANSWERED for reply in replies):
            replies, kept_form = [], False  # nothing was asked
        over = self._overrun(done, limits, printed)
        if over is None and kept_form and len(replies) == count:
            return replies
        if over:
            stop, detail = over
            if len(replies) >= count:
                detail += ", in this call or one before it"
        elif not kept_form:
            stop, detail = Stop.TAMPERED, "it wrote into its own replies"
        else:
            stop = Stop.EXITED  # in mid-call, whatever its status
            detail = outcome.end_of(done)[1]
        if done.stage != wire.CALLING and stop is Stop.EXITED:
            detail += IMPORTING
        # of a limit that the calls passed together, the last one hears
        return [*replies[: count - 1], Reply(stop, detail=detail)]

    def _overrun(self, done: ChildEnd, limits: Limits, printed: int) -> tuple[Stop, str] | None:
        return outcome.overrun(done, limits, printed, self._lines)

    def _run(self, stdio: Sequence[int], limits: Limits) -> ChildEnd:
        return self._request(wire.PROGRAM, stdio, b"", limits)

    def _prepare(self) -> str:
        """Make the server ready for runs, once a container; the source's fault, or nothing."""
        found = self.inspect()
        if found.fault:
            return found.fault.message
        if not self._prepared:
            self._opened()
        return ""

    def _request(self, kind: bytes, stdio: Sequence[int], payload: bytes, limits: Limits) -> ChildEnd:
        memory = 2 * limits.memory_bytes + _ADDRESS_SPACE
        return self._ask(kind, stdio, payload, limits, memory, _FAILED)
