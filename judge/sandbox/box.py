"""What the boxes of all languages have in common: one container after the other, and how a process ended.

A container is started at once or when it is needed, tried again, and replaced where it has ended. Once
foreign code runs nothing that it says is believed: what was measured comes first; see `outcome`.
"""

from __future__ import annotations

import errno
import os
import signal
from abc import ABC, abstractmethod
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING

from judge.errors import LIMIT_ON_TASKS, NO_THREAD, JudgeError, ShortageError, shortage_of
from judge.sandbox import outcome, room, shared
from judge.sandbox.boundary import Inspection, Limits, ProgramResult, Stop, Talk, Usage
from judge.sandbox.container import ChildEnd, Container, Lost
from judge.sandbox.dialogue import Dialogue
from judge.sandbox.inside import wire

if TYPE_CHECKING:
    from judge.sandbox.factory import Containment

BUSY = "judge it again, with a smaller -j if the machine is busy"
_PATIENCE = 5.0  # seconds, with a talk whose program is gone
LOST = "it stopped the process that watches it"


class ContainerBox(ABC):
    """A submission in a container; a context manager that ends it all.

    One thread at a time may use it, whichever opened it.
    """

    stderr_bytes = 4096  # of its end
    lines = 0  # of the source, where a process says in which it stood

    def __init__(self, boxes: Containment) -> None:
        """`boxes` says at which level it is held, and what it may have."""
        self._boxes = boxes
        self._held = ""
        self._prepared = False  # whether the container has compiled the source
        self._inspection: Inspection | None = None
        self._oom_kills = room.oom_kills()
        self._closed = False
        self._container: Container | None = None
        self._dialogue: Dialogue | None = None  # with the program that is run

    @property
    def isolation(self) -> str:
        """The level that holds it: "full", "strong" or "limits"; "" as long as no container was made."""
        return self._held

    @property
    def name(self) -> str:
        """The language's, where its empty program costs something."""
        return ""

    @property
    def idle(self) -> Usage:
        """What the language's empty program costs."""
        return Usage()

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
            with shared.files(stdin if isinstance(stdin, bytes) else b"", b"", b"") as stdio:
                if isinstance(stdin, bytes):
                    done = self._run(stdio, limits)
                    printed, out = shared.size(stdio[1]), shared.part(stdio[1], 0, limits.output_bytes)
                else:
                    done, printed, out = self._talked(stdin, stdio[2], limits)
                printed = max(printed, shared.size(stdio[2]))
                err = shared.tail(stdio[2], self.stderr_bytes)
        except Lost:
            return ProgramResult(Stop.TAMPERED, b"", b"", LOST, Usage())
        note, words = self._said(done, err)
        stop, detail = self._overrun(done, limits, printed, note) or outcome.end_of(done, note, words)
        detail = "" if stop is Stop.ANSWERED else detail
        return ProgramResult(stop, out, err, self._with_threads(detail), done.usage)

    def _talked(self, talk: Talk, stderr: int, limits: Limits) -> tuple[ChildEnd, int, bytes]:
        """Run the program while it is talked with: how much it wrote, and what nobody has heard."""
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

    @abstractmethod
    def _said(self, done: ChildEnd, stderr: bytes) -> tuple[tuple[int, str], str]:
        """What a program says of its end: a note, and words."""

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
        if self._container is None or self._held != level:
            self._drop()
            self._held = level
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
        region = self._here().region
        (note, text), code = region.note(), region.code()
        # Once foreign code runs, notes are its own; what is no Python has no way to write any.
        if note == wire.BROKEN_BOX and (done.stage == wire.NOT_STARTED or kind == wire.EXECUTE):
            self._drop()
            raise shortage_of(code, what) if code else ShortageError(f"{what}: {text}", remedy=BUSY)
        killed = os.WIFSIGNALED(done.status) and os.WTERMSIG(done.status) == signal.SIGKILL
        if not done.reason and killed and done.peak_bytes <= limits.memory_bytes + self.idle.memory_bytes:
            self._check_kills()
        return done

    def _check_kills(self) -> None:
        """Raise ShortageError if the kernel has killed anything for want of memory since this was opened."""
        if room.oom_kills() != self._oom_kills:
            raise shortage_of(errno.ENOMEM, "the kernel has killed the submission's process")

    # -- how it ended

    def _overrun(
        self, done: ChildEnd, limits: Limits, printed: int, note: tuple[int, str]
    ) -> tuple[Stop, str] | None:
        said = int(self._here().region.words[wire.STOOD_AT])
        return outcome.overrun(
            done, limits, printed, note, said if said <= self.lines else 0, self.idle, self.name
        )

    def _with_threads(self, detail: str) -> str:
        """What it says of its own end, with how many threads it may have where that is fewer than elsewhere.

        Whether it wanted more is its own word, which decides nothing.
        """
        share = self._boxes.share
        if not share.short or NO_THREAD not in detail:
            return detail
        most = f"it may have {share.each} threads at once here, and not {room.THREADS} as elsewhere"
        return f"{detail}; {most}: {LIMIT_ON_TASKS}"
