"""Seeds: interpreters that have the judge's modules of the inside, and fork a server for each container.

A seed is used again by whatever would start the same one, at `full` by one at a time.
"""

from __future__ import annotations

import _socket  # socket itself wraps every constant in an enumeration: slow
import contextlib
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Sequence
from queue import SimpleQueue
from typing import Any

from judge.sandbox import bundle, levels, shared
from judge.sandbox.inside import wire
from judge.sandbox.launch import LaunchPlan

END_SECONDS = 1.0
GONE = BrokenPipeError, ConnectionResetError
REASON_BYTES = 2000
PAIR = _socket.SOCK_SEQPACKET if sys.platform == "linux" else _socket.SOCK_STREAM


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
            ours, theirs = _socket.socketpair(_socket.AF_UNIX, PAIR)
            closing.callback(ours.close)
            passed.callback(theirs.close)
            self._line = wire.Channel(ours)
            self._complaints = shared.nameless()
            closing.callback(os.close, self._complaints)
            code = passed.enter_context(shared.file(bundle.pack(plan.config)))
            descriptors = code, theirs.fileno()
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
                not_started = levels.of_fault(fault, plan.command[0])
                assert not_started is not None
                raise not_started from fault
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
            said = shared.tail(self._complaints, REASON_BYTES).decode(errors="replace")
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


def _kill(process: subprocess.Popen[bytes]) -> None:
    """Its session has no other members than its own; under bubblewrap its death is that of its namespace."""
    if process.poll() is None:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, signal.SIGKILL)
        process.kill()
        process.wait()
