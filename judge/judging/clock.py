"""The end by the clock of a routine's calls in this very process.

In the main thread a signal ends Python code where it stands, and sleep. What is in C and does not come back
cannot be ended from here: a process beside this one then says so, and ends this one.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from contextlib import ExitStack
from math import inf
from mmap import mmap
from tempfile import TemporaryFile
from threading import current_thread, main_thread
from time import monotonic
from types import FrameType

from judge.judging.inprocess import LimitPassed, Watch
from judge.sandbox.boundary import Stop

GRACE = 5.0  # seconds that a call may go on after its end, before its process is ended
_AGAIN = 0.1  # seconds after which a call that has caught the signal's exception gets another one
_BESIDE = """
import mmap, os, select, signal, sys
seconds, said, calling, process = sys.argv[1:]
if not select.select([0], [], [], float(seconds))[0] and mmap.mmap(int(calling), 1)[0]:
    os.write(2, said.encode())
    os.kill(int(process), signal.SIGKILL)
"""


class Clock(Watch):
    """A context manager that gives a routine so many seconds for all of its calls; None: any time.

    `cut_short` says whether something was left undone at the end. `stderr` is where a process that is ended
    says so, where that is not its own.
    """

    def __init__(self, name: str, seconds: float | None = None, stderr: int | None = None) -> None:
        self.cut_short = False
        self.told = "" if seconds is None else f"{seconds:g} s are over"
        self._name, self._seconds, self._stderr = name, inf if seconds is None else seconds, stderr
        self._end = monotonic() + self._seconds
        self._undone = ExitStack()
        self._calling: mmap | bytearray = bytearray(1)  # whether the routine is called just now

    @property
    def left(self) -> float:
        """The seconds that are left."""
        return max(0.0, self._end - monotonic())

    @property
    def spent(self) -> bool:
        """Whether nothing more may begin: something would have."""
        self.cut_short = self.cut_short or self._end <= monotonic()
        return self.cut_short

    def start(self) -> Clock:
        """Begin to watch the calls; to be closed."""
        if self._seconds < inf:
            self._calling = self._watched_from_beside()
            if current_thread() is main_thread():
                self._interrupt()
        return self

    def close(self) -> None:
        """Watch no longer."""
        self._undone.close()

    def still(self) -> bool:
        """See `Watch`."""
        return not self.spent

    def begin(self) -> None:
        """See `Watch`."""
        self._calling[0] = 1

    def rest(self) -> float:
        """See `Watch`."""
        self._calling[0] = 0
        return 0.0

    def _interrupt(self) -> None:
        """Let a signal end the call; whoever has set a timer, as pytest-timeout does, gets it back."""
        before, begun = signal.getitimer(signal.ITIMER_REAL), monotonic()
        if 0 < before[0] < self.left:
            return
        handler = signal.signal(signal.SIGALRM, self._alarm)
        signal.setitimer(signal.ITIMER_REAL, max(self.left, 1e-6), _AGAIN)

        def undo() -> None:
            rest = max(1e-6, before[0] - (monotonic() - begun)) if before[0] else 0.0
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, handler)
            signal.setitimer(signal.ITIMER_REAL, rest, before[1])

        self._undone.callback(undo)

    def _alarm(self, _signal: int, _frame: FrameType | None) -> None:
        if self._calling[0] and self.spent:
            raise LimitPassed(Stop.WALL, self.told)

    def _watched_from_beside(self) -> mmap:
        """What says to a process beside this one whether the routine is called."""
        file = self._undone.enter_context(TemporaryFile())  # noqa: SIM115 - it is entered
        file.write(b"\0")
        file.flush()
        said = f"judge: {self._name} has not come back {GRACE:g} s after its {self._seconds:g} s were over, "
        said += "and cannot be interrupted. This process ends.\n"
        words = [str(self._seconds + GRACE), said, str(file.fileno())]
        beside = subprocess.Popen(
            [sys.executable, "-I", "-S", "-c", _BESIDE, *words, str(os.getpid())],
            stdin=subprocess.PIPE,
            stderr=self._stderr,
            pass_fds=[file.fileno()],
        )
        self._undone.enter_context(beside)
        self._undone.callback(beside.kill)  # a child of the routine may hold its input open
        return mmap(file.fileno(), 1)
