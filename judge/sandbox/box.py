"""The `Box` that a fork server stands behind: one child for each run of a program, and for some calls."""

from __future__ import annotations

import contextlib
import errno
import marshal
import os
import signal
import threading
from collections.abc import Sequence
from typing import Any

from judge.errors import LIMIT_ON_TASKS, NO_THREAD, JudgeError, ShortageError, shortage_of
from judge.sandbox import imports, outcome, payload, room, shared
from judge.sandbox.boundary import (
    IMPORTING,
    CallsResult,
    Inspection,
    Limits,
    ProgramResult,
    Reply,
    SourceFault,
    Stop,
    Usage,
)
from judge.sandbox.container import Done, Holder, Lost
from judge.sandbox.inside import wire

STDERR_BYTES = 4096
PRINTED_BYTES = 4 << 10  # of what a function prints that are kept
_INSPECTION = Limits(cpu_seconds=10.0, wall_seconds=30.0, memory_bytes=1 << 30, output_bytes=1 << 22)
_ADDRESS_SPACE = 256 << 20  # beyond twice the memory limit: honest numpy reserves far more than it touches
_TRUSTED_TRIES = 2
_BUSY = "judge it again, with a smaller -j if the machine is busy"
_LOST = "it stopped the process that watches it"


class ForkServerBox:
    """A submission behind a fork server; a context manager that ends it all.

    The container is started at once and awaited on entering, so that a judge may do other things while it
    boots. One thread at a time may use it, whichever opened it.
    """

    def __init__(self, holder: Holder, share: room.Share, lines: int) -> None:
        """`holder` has the container, `share` bounds its threads; its source has so many lines."""
        self._inspection: Inspection | None = None
        self._modules: list[str] = []
        self._share = share
        self._lines = lines
        self._warm_up: threading.Thread | None = None
        self._oom_kills = room.oom_kills()
        self._holder = holder

    @property
    def isolation(self) -> str:
        """The level that holds it: "full", "strong" or "limits"."""
        return self._holder.level

    def __enter__(self) -> ForkServerBox:
        self._warmed_up()
        self._holder.here()
        return self

    def __exit__(self, *exc: object) -> None:
        self._holder.close(at_once=self._warm_up is not None)  # then the warm-up need not be waited for
        self._warmed_up()
        self._holder.drop()

    def warm_up(self) -> None:
        """Get ready for calls in the background: they wait for it, whatever fails shows when they come."""

        def prepare() -> None:
            with contextlib.suppress(JudgeError, Lost, OSError, MemoryError, RuntimeError):
                self._prepare()

        thread = threading.Thread(target=prepare, daemon=True)
        with contextlib.suppress(RuntimeError):  # no thread is left: the calls get ready themselves
            thread.start()
            self._warm_up = thread

    def _warmed_up(self) -> None:
        if self._warm_up is not None:
            self._warm_up.join()
            self._warm_up = None

    def inspect(self) -> Inspection:
        """Parse and compile the source in a child, without running it."""
        self._warmed_up()
        return self._inspected()

    def _inspected(self) -> Inspection:
        if self._inspection is None:
            self._inspection = self._inspect()
        return self._inspection

    def _inspect(self) -> Inspection:
        done = self._ask_trusted(wire.INSPECT, b"")
        replies = self._holder.here().replies(b"", _INSPECTION.output_bytes)
        over = outcome.overrun(done, _INSPECTION, 0, self._note())
        if done.reason not in (wire.NOT_KILLED, wire.FOR_CPU):  # no compiler waits
            raise ShortageError("the machine is too busy to compile it", remedy=_BUSY)
        if over or done.status or not replies.endswith(b",\n"):
            text = over[1] if over else outcome.end_of(done, self._note())[1]
            return Inspection(SourceFault(f"the compiler did not survive it: {text}"))
        found = outcome.parse_inspection(replies)
        self._modules = imports.to_import(found["modules"])
        return Inspection.read(found)

    def _ask_trusted(self, kind: bytes, payload: bytes) -> Done:
        """A request in which nothing foreign runs: what is lost or killed then, the machine has lost."""
        for _ in range(_TRUSTED_TRIES):
            try:
                with shared.stdio(b"") as stdio:
                    done = self._ask(kind, stdio, payload, _INSPECTION)
            except Lost:
                continue
            if done.reason or not outcome.is_from_outside(done):
                return done
        raise ShortageError("the container ended before the submission was run", remedy=_BUSY)

    def call(self, entry: str, calls: Sequence[Sequence[Any]], limits: Limits) -> CallsResult:
        """Make the calls in one child; see `Box.call`."""
        if not calls:
            return CallsResult((), Usage())
        self._warmed_up()
        if fault := self._prepare():
            return CallsResult((Reply(Stop.EXCEPTION, detail=fault),) * len(calls), Usage())
        head, arguments = payload.packed(entry, calls, limits.items)
        try:
            with shared.stdio(b"") as stdio, shared.file(arguments) as given:
                del arguments  # which may be large
                descriptors = (*stdio, given) if wire.PAUSES else stdio
                done = self._ask(wire.CALLS, descriptors, head, limits)
                printed = max(map(shared.size, stdio[1:]))
                text = shared.part(stdio[1], done.printed_bytes, PRINTED_BYTES)
        except Lost as lost:
            kept = outcome.parse_replies(lost.replies, len(calls))[0][: len(calls) - 1]
            return CallsResult((*kept, Reply(Stop.TAMPERED, detail=_LOST)), Usage(0, lost.wall_ns / 1e9))
        replies = self._ended(done, head, limits, printed, len(calls))
        told = tuple(reply._replace(detail=self._with_threads(reply.detail)) for reply in replies)
        usage, imported = outcome.usage_of(done), outcome.imported(done)
        return CallsResult(told, usage, imported, text if done.stage == wire.CALLING else b"")

    def _ended(self, done: Done, head: bytes, limits: Limits, printed: int, count: int) -> list[Reply]:
        """The replies of a child that is gone; the last says how it ended if it did not answer all."""
        note = self._note()
        replies, kept_form = outcome.parse_replies(
            self._holder.here().replies(head, limits.output_bytes), count
        )
        if done.stage != wire.CALLING and any(reply.stop is Stop.ANSWERED for reply in replies):
            replies, kept_form = [], False  # nothing was asked
        over = outcome.overrun(done, limits, printed, note, self._stood_at())
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
            detail = outcome.end_of(done, note)[1]
        if done.stage != wire.CALLING and stop is Stop.EXITED:
            detail += IMPORTING
        # of a limit that the calls passed together, the last one hears
        return [*replies[: count - 1], Reply(stop, detail=detail)]

    def run_program(self, stdin: bytes, limits: Limits) -> ProgramResult:
        """Run the source as `__main__` in a child of its own; see `Box.run_program`."""
        self._warmed_up()
        if fault := self._prepare():
            return ProgramResult(Stop.EXCEPTION, b"", b"", fault, Usage())
        try:
            with shared.stdio(stdin) as (given, stdout, stderr):
                done = self._ask(wire.PROGRAM, (given, stdout, stderr), b"", limits)
                printed = max(map(shared.size, (stdout, stderr)))
                out = shared.head(stdout, limits.output_bytes)
                err = shared.tail(stderr, STDERR_BYTES)
        except Lost:
            return ProgramResult(Stop.TAMPERED, b"", b"", _LOST, Usage())
        note = self._note()
        over = outcome.overrun(done, limits, printed, note, self._stood_at())
        stop, detail = over or outcome.end_of(done, note)
        detail = "" if stop is Stop.ANSWERED else self._with_threads(detail)
        return ProgramResult(stop, out, err, detail, outcome.usage_of(done))

    def _prepare(self) -> str:
        """Make the server ready for runs, once a container; the source's fault, or nothing."""
        found = self._inspected()
        if found.fault:
            return found.fault.message
        if not self._holder.prepared:
            self._ask_trusted(wire.PREPARE, marshal.dumps(self._modules))
            self._holder.prepared = True
        return ""

    def _ask(
        self,
        kind: bytes,
        stdio: Sequence[int],
        payload: bytes,
        limits: Limits,
    ) -> Done:
        """One request; whatever goes wrong on this side of it, Ctrl-C included, ends the container."""
        memory = 2 * limits.memory_bytes + _ADDRESS_SPACE
        if kind in (wire.CALLS, wire.PROGRAM):
            room.check_memory(memory)
        try:
            done = self._holder.here().ask(kind, stdio, payload, limits, memory)
        except BaseException as fault:
            self._holder.drop()
            if isinstance(fault, Lost):
                self._check_kills()
                beyond_reach = not fault.asked or self.isolation != "limits"
                if beyond_reach and kind in (wire.CALLS, wire.PROGRAM):
                    raise ShortageError("the process that watches it has ended", remedy=_BUSY) from None
            raise
        note, text = self._note()
        # Once foreign code runs, notes are its own.
        if note == wire.BROKEN_BOX and done.stage == wire.NOT_STARTED:
            code = self._holder.here().region.code()
            self._holder.drop()
            if code:
                raise shortage_of(code, "the container failed")
            raise ShortageError(f"the container failed: {text}", remedy=_BUSY)
        if not done.reason and _killed(done) and done.peak_bytes <= limits.memory_bytes:
            self._check_kills()
        return done

    def _check_kills(self) -> None:
        """Raise ShortageError if the kernel has killed anything for want of memory since this was opened."""
        if room.oom_kills() != self._oom_kills:
            raise shortage_of(errno.ENOMEM, "the kernel has killed the submission's process")

    def _with_threads(self, detail: str) -> str:
        """What it says of its own end, with how many threads it may have where that is fewer than elsewhere.

        Whether it wanted more is its own word, which decides nothing.
        """
        if not self._share.short or NO_THREAD not in detail:
            return detail
        most = f"it may have {self._share.each} threads at once here, and not {room.THREADS} as elsewhere"
        return f"{detail}; {most}: {LIMIT_ON_TASKS}"

    def _stood_at(self) -> int:
        """The line where it says that it stood when its time was up, if there is such a one; else 0."""
        said = int(self._holder.here().region.words[wire.STOOD_AT])
        return said if said <= self._lines else 0

    def _note(self) -> tuple[int, str]:
        return self._holder.here().region.note()


def _killed(done: Done) -> bool:
    return os.WIFSIGNALED(done.status) and os.WTERMSIG(done.status) == signal.SIGKILL
