"""One running fork server as the judge sees it: start it, ask it, be sure that it is gone.

Every wait is bounded. A server that does not answer in time is killed with everything in it; the next
request starts another.
"""

from __future__ import annotations

import _socket  # socket itself wraps every constant in an enumeration: slow
import contextlib
import marshal
import os
import signal
import time
from collections.abc import Callable, Sequence
from typing import NamedTuple

from judge.errors import JudgeError, shortage_of
from judge.sandbox import levels, seeds, shared
from judge.sandbox.boundary import Limits, Usage
from judge.sandbox.inside import wire
from judge.sandbox.launch import LaunchPlan
from judge.sandbox.levels import StartError
from judge.sandbox.seeds import Seed, Seeds
from judge.sandbox.temporary import TemporaryFolder

START_SECONDS = 20.0  # a loaded machine, a cold disk
SLOW_TRIES = 2  # each takes as long as that
GRACE_SECONDS = 5.0  # beyond a request's own wall limit

Planned = Callable[[Callable[[], str]], LaunchPlan]  # by what makes an empty folder


class Lost(Exception):  # noqa: N818 - it never reaches a person
    """The fork server died or did not answer, the container is gone; `replies` is what its child left.

    `asked` says whether it came as far as running anything.
    """

    def __init__(self, replies: bytes = b"", wall_ns: int = 0, *, asked: bool = True) -> None:
        super().__init__()
        self.asked = asked
        self.replies = replies
        self.wall_ns = wall_ns


class ChildEnd(NamedTuple):
    """A child's end as the fork server measured it."""

    status: int  # as wait4 gives it
    reason: int  # wire.NOT_KILLED or one of wire.FOR_…
    cpu_ns: int
    wall_ns: int
    peak_bytes: int
    stage: int  # how far the child came; the times are of that
    imported_cpu_ns: int = 0  # the import of a module whose calls were begun
    imported_wall_ns: int = 0
    printed_bytes: int = 0  # to stdout, before the calls

    @property
    def usage(self) -> Usage:
        """What was used of the calls, of a whole program, or of an import that ended it."""
        return Usage(self.cpu_ns / 1e9, self.wall_ns / 1e9, self.peak_bytes)

    @property
    def imported(self) -> Usage:
        """What the import took of a module whose calls were begun."""
        return Usage(self.imported_cpu_ns / 1e9, self.imported_wall_ns / 1e9)


class Container:
    """A fork server and its descriptors."""

    def __init__(
        self, level: str, source: bytes, plan: Planned, pool: Seeds, opening: Limits | None = None
    ) -> None:
        """Have one forked as `plan` says, and with `opening` the source looked at. Raises StartError."""
        self.region: wire.Region
        self._closing = contextlib.ExitStack()
        self._seeds = pool
        self._seed: Seed | None = None
        self._pid = 0  # as the server knows it, once it is ready
        self.level = level
        try:
            self._open(source, plan, opening)
        except BaseException as fault:
            self.close()
            if isinstance(fault, OSError | MemoryError | RuntimeError) and (why := levels.of_fault(fault)):
                raise why from fault
            raise

    def _open(self, source: bytes, planned: Planned, opening: Limits | None) -> None:
        ours, theirs = _socket.socketpair(_socket.AF_UNIX, seeds.PAIR)
        self._line = wire.Channel(ours)
        self._closing.callback(ours.close)
        with contextlib.ExitStack() as passed:
            passed.callback(theirs.close)
            descriptor, self.region = shared.region()
            self._closing.callback(self.region.close)
            passed.callback(os.close, descriptor)
            plan = planned(self._home)
            order = passed.enter_context(shared.file(marshal.dumps((plan.config, source))))
            self.region.lay(plan.hidden)
            self._seed = self._seeds.take(plan)
            self._seed.fork(theirs.fileno(), descriptor, order)
        if opening is not None:
            self.region.words[wire.USED] = wire.replies_at(len(plan.hidden))
            with shared.stdio(b"") as stdio, contextlib.suppress(*seeds.GONE):  # which shows later
                self.send(wire.INSPECT, stdio, len(plan.hidden), opening, 2 * opening.memory_bytes)

    def _home(self) -> str:
        """An empty folder of this machine for a submission's own, gone with the container."""
        folder = TemporaryFolder()
        self._closing.callback(folder.close)
        home = folder.path / "home"
        home.mkdir(mode=0o700)
        return str(home)

    def await_ready(self) -> None:
        """Wait until it has confined itself. Raises StartError, the container then being closed.

        Raises JudgeError where a submission in it could read what none may see: a lower level is no way out.
        """
        if self._pid:
            return
        began = time.monotonic()
        frame = self._receive(START_SECONDS)
        if not frame.startswith(wire.READY):
            silent = time.monotonic() - began >= START_SECONDS
            (kind, note), code = self.region.note(), self.region.code()
            said, status = self._hang_up(whole=bool(note))  # ends it, so that it has said all
            self.close()
            if kind == wire.EXPOSED:
                what = f"isolation {self.level} would let a submission read {note}"
                raise JudgeError(what, remedy="install the judge in a virtual environment of its own")
            if silent:
                raise StartError(f"it was not ready after {START_SECONDS:g} s", SLOW_TRIES)
            raise levels.of_code(code, note) if note else levels.of_end(said, status)
        self._pid = int.from_bytes(frame[len(wire.READY) :][:4], "little")

    def _receive(self, seconds: float) -> bytes:
        self._line.patience(seconds)
        try:
            return self._line.receive()[0]
        except OSError:  # hung up, or not in time
            return b""

    def ask(
        self,
        kind: bytes,
        stdio: Sequence[int],
        payload: bytes,
        limits: Limits,
        memory: int,
        begun: Callable[[], None] | None = None,
    ) -> ChildEnd:
        """One request and its answer. Raises Lost and StartError; ShortageError before anything foreign runs.

        `memory` is the bytes that the process may have in all, more than the limit of the submission. `begun`
        is called once the request is on its way, which `stop` may end from another thread.
        """
        if self._seed is None:
            raise Lost
        self.await_ready()
        if wire.replies_at(len(payload)) + wire.reply_bytes(limits.output_bytes) > wire.REGION_BYTES:
            raise JudgeError(
                "more calls at once than the container's memory holds", remedy="make fewer at a time"
            )
        self.region.prepare(payload)
        try:
            self.send(kind, stdio, len(payload), limits, memory)
        except OSError:
            self.close()
            raise Lost(asked=False) from None
        if begun is not None:
            begun()
        return self.answer(limits)

    def send(self, kind: bytes, stdio: Sequence[int], payload: int, limits: Limits, memory: int) -> None:
        """A request, whose payload of that length is there already. Raises OSError."""
        self._start = wire.replies_at(payload)
        self._stop = self._start + wire.reply_bytes(limits.output_bytes)
        seconds = limits.cpu_seconds, limits.wall_seconds, limits.waiting_seconds
        times = [round(each * 1e9) for each in seconds]
        frame = wire.REQUEST.pack(kind, *times, memory, limits.output_bytes, payload, self._stop)
        self._line.send(frame, stdio)

    def answer(self, limits: Limits) -> ChildEnd:
        """What comes of the request. Raises as `ask`."""
        began = time.monotonic_ns()
        answer = self._receive(2 * limits.wall_seconds + GRACE_SECONDS)  # an import has a limit of its own
        if answer.startswith(wire.LACKING):
            raise shortage_of(wire.LACK.unpack_from(answer)[1], "the submission could not be run")
        if answer.startswith(wire.ENDED):
            return ChildEnd(*wire.DONE.unpack_from(answer)[1:])
        data = self.replies()
        self.close()
        raise Lost(data, time.monotonic_ns() - began)

    def stop(self) -> None:
        """End what the request has begun, if it has not ended."""
        with contextlib.suppress(OSError):  # all of it has
            self._line.send(wire.STOP)

    def replies(self) -> bytes:
        """What the last child appended; foreign data."""
        return self.region.replies(self._start, self._stop)

    def close(self) -> None:
        """Hang up, which ends the server; kill it if that takes too long. Safe to call twice."""
        try:
            self._hang_up()
        finally:
            self._closing.close()

    def _hang_up(self, *, whole: bool = True) -> tuple[str, int]:
        """End it, and the seed too unless it is `whole`; what that complained of, and its status."""
        seed, self._seed = self._seed, None
        if seed is None:
            return "", 0
        ended = False
        try:
            if not (ended := self._line.ended(seeds.END_SECONDS)):
                self._end(seed)
                ended = self._line.ended(seeds.END_SECONDS)
        finally:
            self._line.close()
            told = self._seeds.leave(seed, whole=whole and ended)
        return told

    def _end(self, seed: Seed) -> None:
        """Kill it; below `full` it is known here by the number that it knows itself by, and others stay."""
        if self._pid and not seed.plan.alone:
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.kill(self._pid, signal.SIGKILL)
        else:
            seed.kill()
