"""One running fork server as the judge sees it: start it, ask it, be sure that it is gone.

Every wait is bounded. A server that does not answer in time is killed with everything in it; the next
request starts another.
"""

from __future__ import annotations

import _socket  # socket itself wraps every constant in an enumeration: slow
import contextlib
import os
import select
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Sequence
from queue import SimpleQueue
from typing import Any, NamedTuple

from judge.errors import JudgeError, shortage_of
from judge.sandbox import bundle, levels, shared
from judge.sandbox.boundary import Limits, Usage
from judge.sandbox.inside import wire
from judge.sandbox.launch import Plan
from judge.sandbox.levels import StartError
from judge.sandbox.temporary import TemporaryFolder

START_SECONDS = 20.0  # a loaded machine, a cold disk
SLOW_TRIES = 2  # each takes as long as that
GRACE_SECONDS = 5.0  # beyond a request's own wall limit
END_SECONDS = 1.0
REASON_BYTES = 2000

# By the descriptors of the code, the channel and the region, and what makes an empty folder.
Planned = Callable[[tuple[int, int, int], Callable[[], str]], Plan]
_PAIR = _socket.SOCK_SEQPACKET if sys.platform == "linux" else _socket.SOCK_STREAM


class Lost(Exception):  # noqa: N818 - it never reaches a person
    """The fork server died or did not answer, the container is gone; `replies` is what its child left.

    `asked` says whether it came as far as running anything.
    """

    def __init__(self, replies: bytes = b"", wall_ns: int = 0, *, asked: bool = True) -> None:
        super().__init__()
        self.asked = asked
        self.replies = replies
        self.wall_ns = wall_ns


class Done(NamedTuple):
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


class _Order:
    """A process to be started, and what came of it."""

    def __init__(self, command: Sequence[str], settings: dict[str, Any]) -> None:
        self.done = threading.Event()
        self.process: subprocess.Popen[bytes] | None = None
        self.fault: BaseException | None = None
        self._command = command
        self._settings = settings

    def carry_out(self) -> None:
        try:
            self.process = subprocess.Popen(self._command, **self._settings)
        except BaseException as fault:
            self.fault = fault
        self.done.set()


class _Starter:
    """The one thread that starts every fork server.

    On Linux a fork server dies with the thread that started it; this one lives as long as the judge, so that
    a box may be handed from thread to thread.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._thread: threading.Thread | None = None
        self._orders: SimpleQueue[_Order] = SimpleQueue()

    def start(self, command: Sequence[str], **settings: Any) -> subprocess.Popen[bytes]:
        """As `subprocess.Popen`. Raises OSError, and RuntimeError where there is no thread left for it."""
        order = _Order(command, settings)
        with self._lock:
            if self._thread is None or not self._thread.is_alive():  # the first time, or after a fork
                orders: SimpleQueue[_Order] = SimpleQueue()
                thread = threading.Thread(target=self._serve, args=(orders,), daemon=True)
                thread.start()
                self._thread, self._orders = thread, orders
            self._orders.put(order)
        try:
            order.done.wait()
        except BaseException:  # Ctrl-C: it takes only a moment more, and nobody else would end it
            order.done.wait()
            if order.process is not None:
                _kill(order.process)
            raise
        if order.fault is not None:
            raise order.fault
        assert order.process is not None
        return order.process

    @staticmethod
    def _serve(orders: SimpleQueue[_Order]) -> None:
        while True:
            orders.get().carry_out()


_STARTER = _Starter()


class Container:
    """A fork server and its descriptors."""

    def __init__(self, level: str, source: bytes, plan: Planned) -> None:
        """Start it as `plan` says. Raises StartError where there is no room, or the command is missing."""
        self.region: wire.Region
        self._closing = contextlib.ExitStack()
        self._process: subprocess.Popen[bytes] | None = None
        self._ready = False
        self.level = level
        self._exposed = ""  # a path
        try:
            self._start(source, plan)
        except (OSError, MemoryError, RuntimeError) as fault:
            self.close()
            not_started = levels.of_fault(fault)
            if not_started is None:
                raise
            raise not_started from fault
        except BaseException:
            self.close()
            raise

    def _start(self, source: bytes, planned: Planned) -> None:
        ours, theirs = _socket.socketpair(_socket.AF_UNIX, _PAIR)
        self._line = wire.Channel(ours)
        self._closing.callback(ours.close)
        with contextlib.ExitStack() as passed:
            passed.callback(theirs.close)
            descriptor, self.region = shared.region()
            self._closing.callback(self.region.close)
            passed.callback(os.close, descriptor)
            self._complaints = shared.nameless()
            self._closing.callback(os.close, self._complaints)
            code = shared.nameless()
            passed.callback(os.close, code)
            plan = planned((code, theirs.fileno(), descriptor), self._home)
            shared.write_whole(code, bundle.pack(plan.config, source))
            os.lseek(code, 0, os.SEEK_SET)
            self.region.lay(plan.hidden)
            try:
                self._process = _STARTER.start(
                    plan.command,
                    env=plan.environment,
                    cwd="/",
                    stdin=subprocess.DEVNULL,
                    stdout=subprocess.DEVNULL,
                    stderr=self._complaints,
                    pass_fds=(code, theirs.fileno(), descriptor),
                    start_new_session=True,  # Ctrl-C is for the judge, which ends this in its own way
                )
            except OSError as fault:
                not_started = levels.of_fault(fault, plan.command[0])
                assert not_started is not None
                raise not_started from fault

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
        if self._ready:
            return
        if self._exposed:
            raise self._refusal()
        began = time.monotonic()
        frame = self._receive(START_SECONDS)
        if not frame.startswith(wire.READY):
            silent = time.monotonic() - began >= START_SECONDS
            (kind, note), code = self.region.note(), self.region.code()
            process = self._process
            self._hang_up()  # ends it, so that it has said all
            said = shared.tail(self._complaints, REASON_BYTES).decode(errors="replace")
            self.close()
            if kind == wire.EXPOSED:
                self._exposed = note
                raise self._refusal()
            status = process.returncode if process is not None else 0
            if silent:
                raise StartError(f"it was not ready after {START_SECONDS:g} s", SLOW_TRIES)
            raise levels.of_code(code, note) if note else levels.of_end(said, status)
        self._ready = True

    def _refusal(self) -> JudgeError:
        what = f"isolation {self.level} would let a submission read {self._exposed}"
        return JudgeError(what, remedy="install the judge in a virtual environment of its own")

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
    ) -> Done:
        """One request and its answer. Raises Lost and StartError; ShortageError before anything foreign runs.

        `memory` is the bytes that the process may have in all, more than the limit of the submission. `begun`
        is called once the request is on its way, which `stop` may end from another thread.
        """
        if self._process is None:
            raise Lost
        self.await_ready()
        start = wire.replies_at(len(payload))
        stop = start + wire.reply_bytes(limits.output_bytes)
        if stop > wire.REGION_BYTES:
            raise JudgeError(
                "more calls at once than the container's memory holds", remedy="make fewer at a time"
            )
        self.region.prepare(payload)
        times = [
            round(each * 1e9) for each in (limits.cpu_seconds, limits.wall_seconds, limits.waiting_seconds)
        ]
        frame = wire.REQUEST.pack(kind, *times, memory, limits.output_bytes, len(payload), stop)
        try:
            self._line.send(frame, stdio)
        except OSError:
            self.close()
            raise Lost(asked=False) from None
        if begun is not None:
            begun()
        began = time.monotonic_ns()
        answer = self._receive(2 * limits.wall_seconds + GRACE_SECONDS)  # an import has a limit of its own
        if answer.startswith(wire.LACKING):
            raise shortage_of(wire.LACK.unpack_from(answer)[1], "the submission could not be run")
        if answer.startswith(wire.ENDED):
            return Done(*wire.DONE.unpack_from(answer)[1:])
        data = self.replies(payload, limits.output_bytes)
        self.close()
        raise Lost(data, time.monotonic_ns() - began)

    def stop(self) -> None:
        """End what the request has begun, if it has not ended."""
        with contextlib.suppress(OSError):  # all of it has
            self._line.send(wire.STOP)

    def replies(self, payload: bytes, output: int) -> bytes:
        """What the last child appended; foreign data."""
        start = wire.replies_at(len(payload))
        return self.region.replies(start, start + wire.reply_bytes(output))

    def kill(self) -> None:
        """End what runs in it at once; whoever waits for its answer finds it lost."""
        process = self._process
        if process is not None:
            _kill(process)

    def close(self) -> None:
        """Hang up, which ends the server; kill it if that takes too long. Safe to call twice."""
        try:
            self._hang_up()
        finally:
            self._closing.close()

    def _hang_up(self) -> None:
        process, self._process = self._process, None
        if process is None:
            return
        try:
            self._line.close()
            _await_end(process)
        finally:
            _kill(process)


def _await_end(process: subprocess.Popen[bytes]) -> None:
    """Give it a moment; by its own descriptor where there is one, since Popen.wait looks only every 50 ms."""
    descriptor = _descriptor_of(process.pid)
    if descriptor is None:
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(END_SECONDS)
        return
    try:
        ended = select.poll()
        ended.register(descriptor, select.POLLIN)
        ended.poll(END_SECONDS * 1000)
    finally:
        os.close(descriptor)


def _descriptor_of(pid: int) -> int | None:
    """A descriptor that is readable once the child has ended; None where the system has no such thing."""
    if sys.platform != "linux":
        return None
    try:
        return os.pidfd_open(pid)
    except OSError:  # before Linux 5.3, or refused by the filter of a container around the judge
        return None


def _kill(process: subprocess.Popen[bytes]) -> None:
    """Its session has no other members than its own; under bubblewrap its death is that of its namespace."""
    if process.poll() is None:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, signal.SIGKILL)
        process.kill()
        process.wait()
