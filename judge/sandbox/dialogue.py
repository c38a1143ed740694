"""Talking with a program while it runs: two pipes in place of its input and its output, and a thread.

What the program writes is taken up only as far as somebody listens or waits, and counted: one that floods is
ended, and never fills the judge's memory. No wait is for the program alone: once it is gone, which the judge
says from outside, the rest of what it wrote is heard, and then the end, whoever still holds its pipes.
"""

from __future__ import annotations

import os
import select
import threading
from collections.abc import Callable

from judge.sandbox.boundary import Talk

_LOOK_MS = 100  # between two looks at whether the program is gone
_AT_ONCE = 1 << 16
_AT_END = 100  # times that somebody may talk to a program that is gone


class DialogueEnded(BaseException):
    """Raised in a talk that has nobody to go on with; no Exception, so that none takes it for its own."""


class Dialogue:
    """A talk with one run of a program, which may write so many bytes; see `boundary.Conversation`.

    `printed` is how much it wrote, `unheard` what of that nobody wanted to hear, and `fault` what the talk
    raised. The ends of the program go to its process; the others are the thread's alone, which closes them.
    """

    def __init__(self, talk: Talk, most: int) -> None:
        self.printed = 0
        self.fault: BaseException | None = None
        self._talk, self._most = talk, most
        self._buffer, self._searched = bytearray(), 0
        self._writes = self._reads = True  # what the program may still do, as far as is known
        self._gone = False
        self._left = _AT_END
        self._thread: threading.Thread | None = None
        stdin, self._to = os.pipe()
        try:
            self._from, stdout = os.pipe()
        except OSError:
            os.close(stdin)
            os.close(self._to)
            raise
        self.ends = stdin, stdout
        os.set_blocking(self._to, False)

    def begin(self, stop: Callable[[], None]) -> None:
        """The program runs from now on; `stop` ends it. Raises RuntimeError where there is no thread left."""
        thread = threading.Thread(target=self._carry_out, args=(stop,), daemon=True)
        thread.start()
        self._thread = thread

    def end(self, seconds: float) -> None:
        """The program is gone; wait that long for the talk to be over."""
        self._gone = True
        for number in self.ends:
            os.close(number)
        if self._thread is None:
            os.close(self._to)
            os.close(self._from)
        else:
            self._thread.join(seconds)

    @property
    def unheard(self) -> bytes:
        """What it wrote and nobody has heard."""
        return bytes(self._buffer)

    def _carry_out(self, stop: Callable[[], None]) -> None:
        goes_on = False
        try:
            if goes_on := self._talk(self):
                os.close(self._to)
                self._to = -1
                while self._writes:
                    self._wait()
        except DialogueEnded:
            goes_on = False
        except BaseException as fault:  # raised again where the run was asked for
            self.fault, goes_on = fault, False
        finally:
            if not goes_on:
                stop()
            for number in {self._to, self._from} - {-1}:
                os.close(number)

    # -- of the talk

    def say(self, data: bytes) -> None:
        """See `boundary.Conversation`."""
        rest = memoryview(data)
        while rest and self._reads:
            try:
                rest = rest[os.write(self._to, rest) :]
            except BlockingIOError:
                self._wait(writing=True)
            except BrokenPipeError:
                self._reads = False
        if rest:
            self._at_end()

    def hear(self) -> bytes:
        """See `boundary.Conversation`."""
        while not (end := self._buffer.find(b"\n", self._searched) + 1) and self._writes:
            self._searched = len(self._buffer)
            self._wait()
        line = bytes(self._buffer[: end or len(self._buffer)])
        del self._buffer[: len(line)]
        self._searched = 0
        if not line:
            self._at_end()
        return line

    def _wait(self, *, writing: bool = False) -> None:
        """Until something has come, which is taken up, or there is room, or the program is gone."""
        events = select.poll()
        if self._writes:
            events.register(self._from, select.POLLIN)
        if writing:
            events.register(self._to, select.POLLOUT)
        ready = [number for number, _ in events.poll(_LOOK_MS)]
        if self._from in ready:
            data = os.read(self._from, _AT_ONCE)
            self._buffer += data
            self.printed += len(data)
            self._writes = bool(data)
            if self.printed > self._most:
                raise DialogueEnded
        elif not ready and self._gone:
            self._writes = self._reads = False

    def _at_end(self) -> None:
        self._left -= 1
        if self._left < 0:
            raise DialogueEnded
