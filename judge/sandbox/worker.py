"""One contained child process, seen from outside: started, spoken to, watched, measured and taken away.

judge ── socket pair ──> child.py        frames, see child.py
      <─ answers file ── one line a call
      <─ output, errors ─ stdout and stderr of the submission
"""

from __future__ import annotations

import marshal
import math
import os
import resource
import select
import signal
import socket
import subprocess
import time
from typing import Any

from judge.errors import JudgeError
from judge.sandbox import measure
from judge.sandbox.boundary import Limits, Stop, Usage
from judge.sandbox.capture import Capture

START_SECONDS = 30.0
FRAME_BYTES = 4 << 20
_HERE = os.path.dirname(os.path.abspath(__file__))  # noqa: PTH100, PTH120
_BOOT = (
    "import sys; sys.path.insert(0, sys.argv[1]); import child; sys.path.remove(sys.argv[1]); "
    "child.main(sys.argv[1], *map(int, sys.argv[2:]))"
)
# BLAS libraries start a thread a core otherwise, and each reserves address space.
_ENVIRONMENT = {
    "PATH": "/usr/bin:/bin",
    "LANG": "C.UTF-8",
    "OPENBLAS_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "MKL_NUM_THREADS": "1",
}


class HangupError(JudgeError):
    """The child closed its channel or did not speak in time."""

    def __init__(self) -> None:
        super().__init__("the contained process hung up before anything ran in it")


class Worker:
    """A child that waits for its first request; `close` ends it with everything it started."""

    def __init__(self, python: str, folder: str, stdin: bytes | None = None) -> None:
        self._captures = tuple(Capture() for _ in range(3))
        self.answers, self.output, self.errors = self._captures
        self._end: tuple[int, resource.struct_rusage] | None = None
        self._pidfd = -1
        self._seen_cpu = 0.0
        self._peak = 0
        self._sent = 0.0  # when the request under way was sent
        self._own_peak = measure.maxrss_bytes(resource.getrusage(resource.RUSAGE_SELF))
        self._channel, far = socket.socketpair()
        source = Capture(stdin) if stdin is not None else None
        try:
            with far:
                self._process = self._start(python, folder, far.fileno(), source)
        except OSError as error:
            self._release()
            raise JudgeError(f"cannot start Python: {error.strerror}", where=python) from error
        finally:
            if source:
                source.close()
        self.pid = self._process.pid
        if hasattr(os, "pidfd_open"):
            self._pidfd = _pidfd(self.pid)
        self._seen_cpu = self._ready(python)
        self.peak()

    def _start(self, python: str, folder: str, far: int, source: Capture | None) -> subprocess.Popen[bytes]:
        command = [
            python,
            "-I",
            "-X",
            "utf8",
            "-c",
            _BOOT,
            _HERE,
            str(far),
            str(self.answers.fd),
            str(os.getpid()),
        ]
        return subprocess.Popen(
            command,
            stdin=source.fd if source else subprocess.DEVNULL,
            stdout=self.output.fd,
            stderr=self.errors.fd,
            cwd=folder,
            env={**_ENVIRONMENT, "HOME": folder},
            pass_fds=(far, self.answers.fd),
            start_new_session=True,
        )

    def _ready(self, python: str) -> float:
        """Wait until the child is up; its CPU time until now is not the submission's."""
        try:
            kind, payload = self.receive(START_SECONDS)
        except BaseException as error:
            text = self.errors.tail(2000).decode(errors="replace").strip().splitlines()
            self.close()
            if not isinstance(error, HangupError):
                raise
            reason = text[-1] if text else "it said nothing"
            raise JudgeError(f"the contained Python did not start: {reason}", where=python) from error
        assert kind == b"R"  # nothing foreign has run yet
        return self._cpu() if measure.HAS_CLOCK else int(payload) / 1e9

    @property
    def reusable(self) -> bool:
        """Whether another series may run in it: it is alive, and its CPU time can be told apart."""
        return measure.HAS_CLOCK and self._end is None

    def send(self, kind: bytes, content: tuple[Any, ...]) -> None:
        """Send one request.

        Raises:
            HangupError: the child does not take it.
        """
        payload = marshal.dumps(content, 2)
        self._sent = time.monotonic()
        self._channel.settimeout(START_SECONDS)
        try:
            self._channel.sendall(kind + len(payload).to_bytes(4, "little") + payload)
        except OSError as error:
            raise HangupError from error

    def receive(self, seconds: float) -> tuple[bytes, bytes]:
        """The next frame.

        Raises:
            HangupError: none came in time, or one of absurd length.
        """
        deadline = time.monotonic() + seconds
        head = self._exactly(5, deadline)
        length = int.from_bytes(head[1:], "little")
        if length > FRAME_BYTES:
            raise HangupError
        return head[:1], self._exactly(length, deadline)

    def _exactly(self, length: int, deadline: float) -> bytes:
        parts = bytearray()
        while len(parts) < length:
            self._channel.settimeout(max(0.001, deadline - time.monotonic()))
            try:
                part = self._channel.recv(length - len(parts))
            except OSError as error:
                raise HangupError from error
            if not part:
                raise HangupError
            parts += part
        return bytes(parts)

    def silent(self) -> bool:
        """Whether nothing lies on the channel; between requests anything there is not the child's own."""
        return not select.select([self._channel], [], [], 0)[0]

    def watch(self, limits: Limits, *, program: bool) -> Stop | None:
        """Wait for the request's end: a limit that was passed, or None if the child spoke or ended.

        A program has closed its channel, so that only its end counts.
        """
        poller = select.poll()
        if self._pidfd >= 0:
            poller.register(self._pidfd, select.POLLIN)
        if not program:
            poller.register(self._channel, select.POLLIN)
        pause = 0.002
        longest = 0.05 if self._pidfd >= 0 or not program else 0.01
        while True:
            passed = self._passed(limits)
            if passed or ((program or self._pidfd < 0) and self._ended()):
                return passed
            if poller.poll(math.ceil(pause * 1000)):
                return None
            left = limits.cpu_seconds - (self._cpu() - self._seen_cpu)
            pause = max(0.001, min(pause * 2, longest, left))

    def _passed(self, limits: Limits) -> Stop | None:
        if self._cpu() - self._seen_cpu > limits.cpu_seconds:
            return Stop.CPU
        if time.monotonic() - self._sent > limits.wall_seconds:
            return Stop.WALL
        if self.peak() > limits.memory_bytes:
            return Stop.MEMORY
        if self.flooded(limits):
            return Stop.OUTPUT
        return None

    def flooded(self, limits: Limits) -> bool:
        """Whether one of its files holds more than the limit."""
        return any(capture.size() > limits.output_bytes for capture in self._captures)

    def peak(self) -> int:
        """Peak resident bytes, as far as they were seen."""
        if self._end is None:
            self._peak = max(self._peak, measure.peak_bytes(self.pid) or 0)
        else:
            # Linux hands a starting process the peak of the one that started it: only more is its own.
            peak = measure.maxrss_bytes(self._end[1])
            if not measure.HAS_CLOCK or peak > self._own_peak:
                self._peak = max(self._peak, peak)
        return self._peak

    def used(self) -> Usage:
        """What was used since the last call of `used`, or since the child was ready."""
        wall = time.monotonic() - self._sent
        now = self._cpu()
        cpu, self._seen_cpu = max(0.0, now - self._seen_cpu), now
        return Usage(cpu, wall, self.peak())

    def _cpu(self) -> float:
        if self._end is not None:
            return self._end[1].ru_utime + self._end[1].ru_stime
        now = measure.cpu_seconds(self.pid)
        return now if now is not None else self._seen_cpu

    def _ended(self) -> bool:
        """Reap it if it has ended."""
        if self._end is None:
            if self._pidfd >= 0:
                if not select.select([self._pidfd], [], [], 0)[0]:
                    return False
                self._kill()  # while the dead leader still holds the group's number
            pid, status, usage = os.wait4(self.pid, os.WNOHANG)
            if not pid:
                return False
            self._reaped(status, usage)
        return True

    def ended(self, patience: float) -> bool:
        """Whether it ends by itself within that many seconds."""
        deadline = time.monotonic() + patience
        while not self._ended():
            if time.monotonic() > deadline:
                return False
            time.sleep(0.002)
        return True

    def end(self) -> int:
        """Its exit status as `subprocess` writes it, after killing it if it is alive."""
        if not self._ended():
            self.peak()
            self._kill()
            _, status, usage = os.wait4(self.pid, 0)
            self._reaped(status, usage)
        return self._process.returncode

    def _reaped(self, status: int, usage: resource.struct_rusage) -> None:
        self._end = (status, usage)
        self._process.returncode = os.waitstatus_to_exitcode(status)
        self._kill()  # what it left behind in its group

    def _kill(self) -> None:
        try:
            os.killpg(self.pid, signal.SIGKILL)
        except (ProcessLookupError, PermissionError):
            return  # nobody is left in the group (macOS says "not permitted" of a dead one)

    def close(self) -> None:
        """End the child and everything in its process group, and give all descriptors back."""
        try:
            self.end()
        finally:
            self._release()

    def _release(self) -> None:
        self._channel.close()
        if self._pidfd >= 0:
            os.close(self._pidfd)
            self._pidfd = -1
        for capture in self._captures:
            capture.close()


def _pidfd(pid: int) -> int:
    try:
        return os.pidfd_open(pid)
    except OSError:
        return -1  # an old kernel, or a container that forbids it: then the end is looked for every few ms


def describe_status(status: int) -> str:
    """An exit status in words."""
    if status >= 0:
        return f"exit status {status}"
    try:
        name = signal.Signals(-status).name
    except ValueError:
        return f"killed by signal {-status}"
    return f"killed by {name}" + (" (did it call itself too deeply?)" if -status == signal.SIGSEGV else "")


def limits_tuple(limits: Limits, cpu_before: float = 0.0) -> tuple[int, int, int]:
    """What the child sets as its own hard limits: memory, output, CPU seconds (0 where the judge watches)."""
    cpu = 0 if measure.HAS_CLOCK else math.ceil(limits.cpu_seconds + cpu_before) + 1
    return limits.memory_bytes, limits.output_bytes, cpu
