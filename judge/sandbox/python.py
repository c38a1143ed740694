"""The box of a Python submission: a fork server, one child for each run of a program, and for some calls."""

from __future__ import annotations

import contextlib
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from judge.errors import ShortageError
from judge.sandbox import launch, outcome, shared
from judge.sandbox.boundary import (
    IMPORTING,
    CallsResult,
    Inspection,
    Limits,
    Reply,
    SourceFault,
    Stop,
    Usage,
)
from judge.sandbox.box import BUSY, LOST, ContainerBox
from judge.sandbox.calls import packed
from judge.sandbox.container import ChildEnd, Container, Lost
from judge.sandbox.inside import wire
from judge.sandbox.levels import StartError

if TYPE_CHECKING:
    from judge.sandbox.factory import Containment

PRINTED_BYTES = 4 << 10  # of what a function prints that are kept
_INSPECTION = Limits(cpu_seconds=10.0, wall_seconds=30.0, memory_bytes=1 << 30, output_bytes=1 << 22)
_ADDRESS_SPACE = 256 << 20  # beyond twice the memory limit: honest numpy reserves far more than it touches
_TRUSTED_TRIES = 2
_FAILED = "the container failed"


class PythonBox(ContainerBox):
    """The container is started at once, where the source is looked at and its modules are imported, and
    awaited on entering, so that a judge may do other things meanwhile.
    """

    def __init__(self, boxes: Containment, source: bytes, name: str) -> None:
        """Start a container ahead; what goes wrong with that shows when it is asked for."""
        super().__init__(boxes)
        self._source, self._name = source, name
        self.lines = len(source.splitlines())
        self._held = boxes.levels.level
        with contextlib.suppress(StartError):
            self._container = self._start(self._held)

    def _start(self, level: str) -> Container:
        plan = partial(launch.plan, level, self._name, self._boxes.visible(), self._boxes.share)
        return Container(level, self._source, plan, self._boxes.seeds, _INSPECTION)

    def __enter__(self) -> PythonBox:
        self._here()
        return self

    def _inspect(self) -> Inspection:
        done = self._opened()
        replies = self._here().replies()
        over = self._overrun(done, _INSPECTION, 0, self._note())
        if done.reason not in (wire.NOT_KILLED, wire.FOR_CPU):  # no compiler waits
            self._drop()
            raise ShortageError("the machine is too busy to compile it", remedy=BUSY)
        if over or done.status or not replies.endswith(b",\n"):
            text = over[1] if over else outcome.end_of(done, self._note())[1]
            return Inspection(SourceFault(f"the compiler did not survive it: {text}"))
        return Inspection.read(outcome.parse_inspection(replies))

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
            with shared.files(b"", b"", b"", arguments) as stdio:
                del arguments  # which may be large
                done = self._request(wire.CALLS, stdio if wire.PAUSES else stdio[:3], head, limits)
                printed = max(map(shared.size, stdio[1:3]))
                text = shared.part(stdio[1], done.printed_bytes, PRINTED_BYTES)
        except Lost as lost:
            kept = outcome.parse_replies(lost.replies, len(calls))[0][: len(calls) - 1]
            return CallsResult((*kept, Reply(Stop.TAMPERED, detail=LOST)), Usage(0, lost.wall_ns / 1e9))
        replies = self._ended(done, limits, printed, len(calls))
        text = text if done.stage == wire.CALLING else b""
        if self._boxes.share.short:
            replies = [
                each._replace(detail=self._with_threads(each.detail)) if each.detail else each
                for each in replies
            ]
        return CallsResult(tuple(replies), done.usage, done.imported, text)

    def _ended(self, done: ChildEnd, limits: Limits, printed: int, count: int) -> list[Reply]:
        """The replies of a child that is gone; the last says how it ended if it did not answer all."""
        note = self._note()
        replies, kept_form = outcome.parse_replies(self._here().replies(), count)
        if done.stage != wire.CALLING and any(reply.stop is Stop.ANSWERED for reply in replies):
            replies, kept_form = [], False  # nothing was asked
        over = self._overrun(done, limits, printed, note)
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

    def _run(self, stdio: Sequence[int], limits: Limits) -> ChildEnd:
        return self._request(wire.PROGRAM, stdio, b"", limits)

    def _said(self, done: ChildEnd, stderr: bytes) -> tuple[tuple[int, str], str]:  # noqa: ARG002
        return self._note(), ""

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

    def _note(self) -> tuple[int, str]:
        return self._here().region.note()
