"""Processes of `judge worker` that `--on` starts itself, here or by another program, and ends with itself.

Each is given its keys on standard input, tells in JSON when it is ready, and ends when that input does: so it
does when whoever started it is killed.
"""

from __future__ import annotations

import subprocess
import threading
from collections import deque
from collections.abc import Sequence
from contextlib import suppress
from queue import Empty, SimpleQueue
from typing import IO, Any

import msgspec

from judge.cluster.keys import Keys
from judge.errors import JudgeError

_END = 10.0  # seconds for a process to end by itself
_LAST = 1.0  # seconds to read what it wrote last; what it has started may hold its output open for longer


class Helper:
    """A process whose first line of output is what `judge worker --json` writes; `what` names it."""

    def __init__(self, what: str, command: Sequence[str], keys: Keys | None = None) -> None:
        """Raises JudgeError where the program cannot be started."""
        self.what = what
        try:
            self._process = subprocess.Popen(
                command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                start_new_session=True,
            )
        except OSError as fault:
            reason = (fault.strerror or "it failed").lower()
            raise JudgeError(
                f"{command[0]} cannot be started ({reason})", remedy=f"install {command[0]}"
            ) from fault
        self._lines: SimpleQueue[bytes] = SimpleQueue()
        self._said: deque[str] = deque(maxlen=3)
        process: Any = self._process  # whose pipes are there, as they were asked for
        self._stdin: IO[bytes] = process.stdin
        self._readers = [
            threading.Thread(target=self._read, args=(process.stdout,), daemon=True),
            threading.Thread(target=self._listen, args=(process.stderr,), daemon=True),
        ]
        for reader in self._readers:
            reader.start()
        if keys is not None:
            with suppress(OSError):  # it has ended; what it said tells why
                self._stdin.write(keys.text().encode())
                self._stdin.flush()

    def ready(self, seconds: float) -> dict[str, Any]:
        """What it wrote when it was ready. Raises JudgeError where it ended instead, or is too slow."""
        try:
            content = self._lines.get(timeout=seconds)
            return msgspec.json.decode(content, type=dict[str, Any])
        except Empty:
            raise JudgeError(f"{self.what}: it is not ready after {seconds:.0f} seconds") from None
        except msgspec.DecodeError:
            self._readers[1].join(1.0)
            said = self._said[-1] if self._said else f"exit status {self._process.wait()}"
            raise JudgeError(f"{self.what}: it has not started: {said}") from None

    def let_go(self) -> None:
        """Let it end."""
        with suppress(OSError):
            self._stdin.close()

    def end(self) -> None:
        """Wait until it has ended, and end it if it does not."""
        self.let_go()
        for act in (None, self._process.terminate, self._process.kill):
            if act is not None:
                act()
            with suppress(subprocess.TimeoutExpired):
                self._process.wait(_END)
                break
        for stream, reader in zip((self._process.stdout, self._process.stderr), self._readers, strict=True):
            reader.join(_LAST)
            if stream is not None and not reader.is_alive():
                stream.close()

    def _read(self, stream: IO[bytes]) -> None:
        for content in stream:
            self._lines.put(content)
        self._lines.put(b"")

    def _listen(self, stream: IO[bytes]) -> None:
        for content in stream:
            self._said.append(content.decode(errors="replace").strip().removeprefix("judge: "))
