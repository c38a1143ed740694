"""The `Box` that a fork server stands behind: one child for each program run and for each series of calls."""

from __future__ import annotations

import contextlib
import marshal
import sys
import threading
from collections.abc import Callable, Sequence
from typing import Any

from judge.errors import JudgeError
from judge.sandbox import imports, outcome, packing, shared
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
from judge.sandbox.container import Container, Done, Lost, NotStarted, OnSeries
from judge.sandbox.inside import series as series_file
from judge.sandbox.inside import wire
from judge.sandbox.roots import Roots

STDERR_BYTES = 4096
_INSPECTION = Limits(cpu_seconds=10.0, wall_seconds=30.0, memory_bytes=1 << 30, output_bytes=1 << 22)
_ADDRESS_SPACE = 256 << 20  # beyond twice the memory limit: honest numpy reserves far more than it touches
OnLevel = Callable[[str, bool], None]  # a level, and whether it was refused for good
Refuse = Callable[[NotStarted], JudgeError]

_PAUSES = sys.platform == "linux"  # a child can be measured between two series only by a clock from outside
_LOST = "it stopped the process that watches it"


class ForkServerBox:
    """A submission behind a fork server; a context manager that ends it all.

    The container is started at once and awaited on entering, so that a judge may do other things while it
    boots. Where the first of `levels` cannot be had the next is tried; where none can, entering raises what
    `refuse` makes of the reason.

    One thread at a time may use it, whichever opened it.
    """

    def __init__(
        self,
        source: bytes,
        name: str,
        levels: Sequence[str],
        roots: Roots,
        refuse: Refuse,
        on_level: OnLevel,
    ) -> None:
        """Start the container at the first of the levels; `on_level` is told what comes of each."""
        self._source = source
        self._name = name
        self._levels = list(levels)
        self._refuse = refuse
        self._on_level = on_level
        self._roots = roots
        self._inspection: Inspection | None = None
        self._modules: list[str] = []
        self._prepared: set[bytes] = set()
        self._container: Container | None = None
        self._warm_up: threading.Thread | None = None
        self._closed = False
        self._launch()

    @property
    def isolation(self) -> str:
        """The level that holds it: "full", "strong" or "limits"."""
        return self._levels[0]

    def __enter__(self) -> ForkServerBox:
        self._warmed_up()
        self._here()
        return self

    def __exit__(self, *exc: object) -> None:
        self._closed = True  # a warm-up still under way must not start another container
        if self._warm_up is not None and self._container is not None:
            self._container.kill()  # and need not be waited for: nothing will answer it any more
        self._warmed_up()
        self._drop()

    def warm_up(self) -> None:
        """Get ready for calls in the background: they wait for it, whatever fails shows when they come."""

        def prepare() -> None:
            with contextlib.suppress(JudgeError, Lost, OSError):
                self._prepare(wire.CALLS)

        self._warm_up = threading.Thread(target=prepare, daemon=True)
        self._warm_up.start()

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
        try:
            with shared.stdio(b"") as stdio:
                done = self._ask(wire.INSPECT, stdio, b"", _INSPECTION)
        except Lost:
            return Inspection(SourceFault("the compiler did not survive it"))
        replies = self._here().replies(b"", _INSPECTION.output_bytes, 1)
        over = outcome.overrun(done, _INSPECTION, 0, self._note())
        if over or done.status or not replies.endswith(b",\n"):
            text = over[1] if over else outcome.end_of(done, self._note())[1]
            return Inspection(SourceFault(f"the compiler did not survive it: {text}"))
        found = outcome.parse_inspection(replies)
        self._modules = imports.to_import(found["modules"])
        fault = SourceFault(*found["fault"]) if found["fault"] else None
        return Inspection(fault, tuple((name, line) for name, line in found["names"]))

    def call_many(self, entry: str, calls: Sequence[Sequence[Any]], limits: Limits) -> CallsResult:
        """Make one series of calls; see `Box.call_many`."""
        return self.call_series(entry, [calls], limits)[0] if calls else CallsResult((), Usage())

    def call_series(
        self,
        entry: str,
        series: Sequence[Sequence[Sequence[Any]]],
        limits: Limits,
        on_series: OnSeries | None = None,
    ) -> list[CallsResult]:
        """Make the calls in one child; see `Box.call_series`."""
        self._warmed_up()
        fault = self._prepare(wire.CALLS)
        if fault:
            return [
                CallsResult(tuple(Reply(Stop.EXCEPTION, detail=fault) for _ in calls), Usage())
                for calls in series
            ]
        if len(series) > 1 and not _PAUSES:  # each in a child of its own, as far as that goes
            return self._one_at_a_time(entry, series, limits, on_series)
        counts = [len(calls) for calls in series]
        packed = packing.packed(entry, series, limits.items)
        payload = packed[0].ljust(max(map(len, packed)), b"\0")  # the later ones take its place
        try:
            with shared.stdio(b"") as stdio, shared.file(series_file.pack(counts, packed)) as later:
                descriptors = (*stdio, later) if len(series) > 1 else stdio
                done = self._ask(wire.CALLS, descriptors, payload, limits, len(series), on_series)
                printed = _printed(*stdio[1:])
        except Lost as lost:
            kept = outcome.parse_series(lost.replies, lost.marks, counts)[0][: sum(counts) - 1]
            replies = [*kept, Reply(Stop.TAMPERED, detail=_LOST)]
            return outcome.by_series(replies, series, outcome.usages_of_lost(lost))
        replies = self._ended(done, payload, limits, printed, counts)
        return outcome.by_series(replies, series, outcome.usages_of(done))

    def _ended(
        self, done: Done, payload: bytes, limits: Limits, printed: int, counts: Sequence[int]
    ) -> list[Reply]:
        """The replies of a child that is gone; the last says how it ended if it did not answer all."""
        note = self._note()
        count = sum(counts)
        data = self._here().replies(payload, limits.output_bytes, len(counts))
        replies, kept_form = outcome.parse_series(data, done.marks, counts)
        over = outcome.overrun(done, limits, printed, note)
        if over is None and kept_form and (done.reason == wire.FOR_ROOM or len(replies) == count):
            return replies
        if over:
            stop, detail = over
            count = sum(counts[: outcome.blamed(done, stop, limits) + 1])
            if len(replies) >= count:
                detail += ", in this call or one before it"
        elif not kept_form:
            stop, detail = Stop.TAMPERED, "it wrote into its own replies"
        else:
            detail = outcome.end_of(done, note)[1]
            stop = Stop.EXITED  # in mid-call, whatever its status
            if not self._here().region.words[wire.IMPORTED]:
                detail += ", while the module was imported"
        # of a limit that the calls of a series passed together, its last call hears
        return [*replies[: max(0, count - 1)], Reply(stop, detail=detail)]

    def _one_at_a_time(
        self,
        entry: str,
        series: Sequence[Sequence[Sequence[Any]]],
        limits: Limits,
        on_series: OnSeries | None,
    ) -> list[CallsResult]:
        results: list[CallsResult] = []
        for calls in series:
            if results and on_series:
                on_series()
            results.append(self.call_many(entry, calls, limits))
            waited = results[-1].usage.waiting_seconds
            limits = limits._replace(waiting_seconds=max(0.0, limits.waiting_seconds - waited))
            replies = results[-1].replies
            if replies and replies[-1].stop not in (Stop.ANSWERED, Stop.EXCEPTION):
                break
        return results

    def run_program(self, stdin: bytes, limits: Limits) -> ProgramResult:
        """Run the source as `__main__` in a child of its own; see `Box.run_program`."""
        self._warmed_up()
        fault = self._prepare(wire.PROGRAM)
        if fault:
            return ProgramResult(Stop.EXCEPTION, b"", b"", fault, Usage())
        try:
            with shared.stdio(stdin) as (given, stdout, stderr):
                done = self._ask(wire.PROGRAM, (given, stdout, stderr), b"", limits)
                printed = _printed(stdout, stderr)
                out = shared.head(stdout, limits.output_bytes)
                err = shared.tail(stderr, STDERR_BYTES)
        except Lost:
            return ProgramResult(Stop.TAMPERED, b"", b"", _LOST, Usage())
        note = self._note()
        stop, detail = outcome.overrun(done, limits, printed, note) or outcome.end_of(done, note)
        detail = "" if stop is Stop.ANSWERED else detail
        return ProgramResult(stop, out, err, detail, outcome.usage_of(done))

    def _prepare(self, kind: bytes) -> str:
        """Make the server ready for runs of a kind, once a container; the source's fault, or nothing."""
        found = self._inspected()
        if found.fault:
            return found.fault.message
        if self._container and kind in self._prepared:
            return ""
        try:
            with shared.stdio(b"") as stdio:
                self._ask(wire.PREPARE, stdio, marshal.dumps((self._modules, kind)), _INSPECTION)
        except Lost:  # nothing foreign runs while it prepares: memory, a full machine
            raise JudgeError("the container ended while it was made ready") from None
        self._prepared.add(kind)
        return ""

    def _ask(
        self,
        kind: bytes,
        stdio: Sequence[int],
        payload: bytes,
        limits: Limits,
        series: int = 1,
        on_series: OnSeries | None = None,
    ) -> Done:
        """One request; whatever goes wrong on this side of it, Ctrl-C included, ends the container."""
        try:
            done = self._here().ask(
                kind,
                stdio,
                payload,
                cpu_ns=round(limits.cpu_seconds * 1e9),
                wall_ns=round(limits.wall_seconds * 1e9),
                waiting_ns=round(limits.waiting_seconds * 1e9),
                memory=2 * limits.memory_bytes + _ADDRESS_SPACE,
                output=limits.output_bytes,
                series=series,
                on_series=on_series,
            )
        except BaseException:
            self._drop()
            raise
        note, text = self._note()
        if note == wire.BROKEN_BOX and not done.started:  # once foreign code runs, notes are its own
            self._drop()
            raise JudgeError(f"the container failed: {text}")
        return done

    def _launch(self) -> None:
        """Start a container at the best level that is left; whether it gets ready shows later."""
        while True:
            try:
                self._container = Container(self._levels[0], self._name, self._source, self._roots)
            except NotStarted as refusal:
                self._give_up(refusal)
            else:
                self._prepared.clear()
                return

    def _give_up(self, refusal: NotStarted) -> None:
        """Leave a level that cannot be had for the next one."""
        if len(self._levels) == 1:
            raise self._refuse(refusal) from refusal
        if refusal.lasting:
            self._on_level(self._levels[0], True)
        del self._levels[0]

    def _here(self) -> Container:
        """The running container, ready for a request."""
        while True:
            if self._closed:
                raise Lost
            if self._container is None:
                self._launch()
            assert self._container is not None
            try:
                self._container.await_ready()
            except NotStarted as refusal:
                self._container = None
                self._give_up(refusal)
            else:
                self._on_level(self._levels[0], False)
                return self._container

    def _note(self) -> tuple[int, str]:
        return self._here().region.note()

    def _drop(self) -> None:
        container, self._container = self._container, None
        if container is not None:
            container.close()


def _printed(*descriptors: int) -> int:
    return max(shared.size(descriptor) for descriptor in descriptors)
