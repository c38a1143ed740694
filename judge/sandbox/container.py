"""Fork servers as the judge sees them: start one, ask it, be sure that it is gone.

A seed is an interpreter that has the judge's modules of the inside, and forks a server for each container.
It is used again by whatever would start the same one, at `full` by one at a time.

Every wait is bounded. A server that does not answer in time is killed with everything in it; the next
request starts another.
"""

from __future__ import annotations

import _socket  # socket itself wraps every constant in an enumeration: slow
import contextlib
import marshal
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Sequence
from queue import SimpleQueue
from typing import Any, NamedTuple

from judge.errors import JudgeError, shortage_code, shortage_of
from judge.sandbox import levels, parcels
from judge.sandbox.boundary import Limits, Usage
from judge.sandbox.inside import wire
from judge.sandbox.launch import LaunchPlan
from judge.sandbox.levels import StartError

START_SECONDS = 20.0  # a loaded machine, a cold disk
SLOW_TRIES = 2  # each takes as long as that
GRACE_SECONDS = 5.0  # beyond a request's own wall limit
END_SECONDS = 1.0
GONE = BrokenPipeError, ConnectionResetError
REASON_BYTES = 2000
PAIR = _socket.SOCK_SEQPACKET if sys.platform == "linux" else _socket.SOCK_STREAM

Planned = Callable[[Callable[[], str]], LaunchPlan]  # by what makes an empty folder


class Lost(Exception):  # noqa: N818 - it never reaches a person
    """The fork server died or did not answer, the container is gone; `replies` is what its child left.

    `asked` says whether it came as far as running anything.
    """

    def __init__(self, replies: bytes = b"", wall_ns: int = 0, *, asked: bool = True) -> None:
        super().__init__()
        self.replies, self.wall_ns, self.asked = replies, wall_ns, asked


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
    note: tuple[int, str] = wire.NO_NOTE, ""  # what the child says of it: foreign once it has begun
    stood_at: int = 0  # the line where it says that it stood when its time was up, 0 for unknown
    code: int = 0  # the errno of what failed before it had begun

    @property
    def usage(self) -> Usage:
        """What was used of the calls, of a whole program, or of an import that ended it."""
        return Usage(self.cpu_ns / 1e9, self.wall_ns / 1e9, self.peak_bytes)

    @property
    def imported(self) -> Usage:
        """What the import took of a module whose calls were begun."""
        return Usage(self.imported_cpu_ns / 1e9, self.imported_wall_ns / 1e9)


class _Starter:
    """The one thread that starts every seed.

    On Linux a seed dies with the thread that started it; this one lives as long as the judge, so that a box
    may be handed from thread to thread.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._thread: threading.Thread | None = None
        self._orders: SimpleQueue[Any] = SimpleQueue()

    def start(self, command: Sequence[str], **settings: Any) -> subprocess.Popen[bytes]:
        """As `subprocess.Popen`. Raises OSError, and RuntimeError where there is no thread left for it."""
        told: SimpleQueue[subprocess.Popen[bytes] | BaseException] = SimpleQueue()
        with self._lock:
            if self._thread is None or not self._thread.is_alive():  # the first time, or after a fork
                self._orders = SimpleQueue()
                self._thread = threading.Thread(target=_start_all, args=(self._orders,), daemon=True)
                self._thread.start()
            self._orders.put((told, command, settings))
        try:
            started = told.get()
        except BaseException:  # Ctrl-C: it takes only a moment more, and nobody else would end it
            if not isinstance(late := told.get(), BaseException):
                _kill(late)
            raise
        if isinstance(started, BaseException):
            raise started
        return started


def _start_all(orders: SimpleQueue[Any]) -> None:
    while True:
        told, command, settings = orders.get()
        try:
            told.put(subprocess.Popen(command, **settings))
        except BaseException as fault:
            told.put(fault)


_STARTER = _Starter()


class Seed:
    """An interpreter that has the judge's modules of the inside, and forks a server for each container."""

    def __init__(self, plan: LaunchPlan) -> None:
        """Start it. Raises StartError, OSError and RuntimeError."""
        self.plan = plan
        self.users = 0
        with contextlib.ExitStack() as closing, contextlib.ExitStack() as passed:
            self._line, theirs = _channel(closing, passed)
            self._complaints = parcels.nameless()
            closing.callback(os.close, self._complaints)
            (bundled,) = passed.enter_context(parcels.files(parcels.code(plan.config)))
            descriptors = bundled, theirs
            try:
                self._process = _STARTER.start(
                    (*plan.command, *map(str, descriptors)),
                    env=plan.environment,
                    cwd="/",
                    stdin=subprocess.DEVNULL,
                    stdout=subprocess.DEVNULL,
                    stderr=self._complaints,
                    pass_fds=descriptors,
                    start_new_session=True,  # Ctrl-C is for the judge, which ends this in its own way
                )
            except OSError as fault:
                code = fault.errno or 0
                what = f"{plan.command[0]} cannot be started: {os.strerror(code)}"
                raise levels.of_code(code, what, 1) from fault
            self._closing = closing.pop_all()

    def fork(self, channel: int, region: int, order: int) -> None:
        """Fork a server with these. That it has ended is noticed at the channel, which hangs up then."""
        with contextlib.suppress(*GONE):
            self._line.send(wire.OPEN, (channel, region, order))

    def kill(self) -> None:
        """End it with all its servers at once."""
        _kill(self._process)

    def close(self) -> tuple[str, int]:
        """End it with all its servers; what was complained of, and its status."""
        try:
            if self._line.ended(END_SECONDS):
                with contextlib.suppress(subprocess.TimeoutExpired):
                    self._process.wait(END_SECONDS)
        finally:
            _kill(self._process)
            said = parcels.tail(self._complaints, REASON_BYTES).decode(errors="replace")
            self._closing.close()
        return said, self._process.returncode


class Seeds:
    """The seeds of some boxes, for any thread. With `keep` one that nobody uses waits for the next box."""

    def __init__(self) -> None:
        self.keep = False
        self._lock = threading.Lock()
        self._seeds: list[Seed] = []

    def take(self, plan: LaunchPlan) -> Seed:
        """One for a container of that plan. Raises as `Seed`."""
        with self._lock:
            for seed in self._seeds:
                if seed.plan.seed == plan.seed and not (seed.users and plan.alone):
                    break
            else:
                seed = Seed(plan)
                self._seeds.append(seed)
            seed.users += 1
            return seed

    def leave(self, seed: Seed, *, whole: bool) -> tuple[str, int]:
        """A container has ended; where it is not `whole` the seed ends with it, as `Seed.close` tells."""
        with self._lock:
            seed.users -= 1
            # What a compiler was started from at `full` would show the next one what it has written.
            stays = seed.users > 0 or (self.keep and not (seed.plan.alone and "folders" in seed.plan.config))
            if seed not in self._seeds or (whole and stays):
                return "", 0
            self._seeds.remove(seed)
        return seed.close()

    def close(self) -> None:
        """End those that nobody uses; the next container has another."""
        with self._lock:
            idle = [seed for seed in self._seeds if not seed.users]
            self._seeds = [seed for seed in self._seeds if seed.users]
        for seed in idle:
            seed.close()


def _channel(closing: contextlib.ExitStack, passed: contextlib.ExitStack) -> tuple[wire.Channel, int]:
    """A new channel, and the descriptor of its other end; each is closed with its own."""
    ours, theirs = _socket.socketpair(_socket.AF_UNIX, PAIR)
    closing.callback(ours.close)
    passed.callback(theirs.close)
    return wire.Channel(ours), theirs.fileno()


def _kill(process: subprocess.Popen[bytes]) -> None:
    """Its session has no other members than its own; under bubblewrap its death is that of its namespace."""
    if process.poll() is None:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, signal.SIGKILL)
        process.kill()
        process.wait()


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
            if code := shortage_code(fault):
                raise levels.of_code(code, str(fault)) from fault
            raise

    def _open(self, source: bytes, planned: Planned, opening: Limits | None) -> None:
        with contextlib.ExitStack() as passed:
            self._line, theirs = _channel(self._closing, passed)
            descriptor, self.region = parcels.region()
            self._closing.callback(self.region.close)
            passed.callback(os.close, descriptor)
            plan = planned(self._home)
            (order,) = passed.enter_context(parcels.files(marshal.dumps((plan.config, source))))
            self.region.lay(plan.hidden)
            self._seed = self._seeds.take(plan)
            self._seed.fork(theirs, descriptor, order)
        if opening is not None:
            self.region.words[wire.USED] = wire.replies_at(len(plan.hidden))
            with parcels.files(b"", b"", b"") as stdio, contextlib.suppress(*GONE):  # which shows later
                self.send(wire.INSPECT, stdio, len(plan.hidden), opening, 2 * opening.memory_bytes)

    def _home(self) -> str:
        """An empty folder of this machine for a submission's own, gone with the container."""
        home = self._closing.enter_context(parcels.temporary_folder()) / "home"
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
            (kind, note), code = self.region.note(), int(self.region.words[wire.CODE])
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
            what = "more calls at once than the container's memory holds"
            raise JudgeError(what, remedy="make fewer at a time")
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
            end = ChildEnd(*wire.DONE.unpack_from(answer)[1:])
            line, code = (int(self.region.words[at]) for at in (wire.STOOD_AT, wire.CODE))
            return end._replace(note=self.region.note(), stood_at=line, code=code)
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
            if not (ended := self._line.ended(END_SECONDS)):
                self._end(seed)
                ended = self._line.ended(END_SECONDS)
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
