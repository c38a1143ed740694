"""The command on a terminal of its own, as a person has one."""

from __future__ import annotations

import os
import select
import struct
import subprocess
import sys
import time
from typing import Any

import pytest
from cli_support import ROOT

pty = pytest.importorskip("pty")
import fcntl  # noqa: E402 - where there is pty there are these
import termios  # noqa: E402

PATIENCE = 60  # seconds for something that is bound to come


class Terminal:
    """A judge at work on a terminal of so many columns and rows; a context manager that ends it."""

    def __init__(self, *words: object, columns: int = 80, rows: int = 24, **settings: str) -> None:
        self.ours, theirs = pty.openpty()
        self.resize(columns, rows, tell=False)
        self.before = termios.tcgetattr(self.ours)
        settings = {"TERM": "xterm-256color", "PYTHONPATH": str(ROOT), **settings}
        self.process = subprocess.Popen(
            [sys.executable, "-m", "judge", *map(str, words)],
            env={**os.environ, **settings},
            stdin=theirs,
            stdout=theirs,
            stderr=theirs,
            start_new_session=True,
            preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0),
        )
        os.close(theirs)
        self.written = ""

    def __enter__(self) -> Terminal:
        return self

    def __exit__(self, *_: object) -> None:
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        os.close(self.ours)

    def resize(self, columns: int, rows: int, *, tell: bool = True) -> None:
        fcntl.ioctl(self.ours, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))
        if tell:
            self.process.send_signal(28)  # SIGWINCH

    def press(self, keys: str) -> None:
        os.write(self.ours, keys.encode())

    def read(self, seconds: float = 0.2) -> bool:
        """Take in what has been written; whether more may come."""
        if select.select([self.ours], [], [], seconds)[0]:
            try:
                part = os.read(self.ours, 65536)
            except OSError:  # Linux says so when the other side is closed
                return False
            self.written += part.decode(errors="replace")
            return bool(part)
        return True

    def until(self, text: str) -> str:
        """Wait for the text; all that was written since the last time, up to its end."""
        end = time.monotonic() + PATIENCE
        while text not in self.written:
            assert time.monotonic() < end, f"{text!r} is not shown: {self.written}"
            assert self.read() or text in self.written, self.written
        seen, text, self.written = self.written.partition(text)
        return seen + text

    def ends(self) -> int:
        """Take in the rest; the exit status."""
        end = time.monotonic() + PATIENCE
        while self.read() and time.monotonic() < end:
            pass
        return self.process.wait(timeout=PATIENCE)


def on_a_terminal(*words: object, typed: str = "", **more: Any) -> tuple[int, str]:
    """Run the command on a terminal of its own; its status and all that was written there."""
    with Terminal(*words, **more) as terminal:
        if typed:
            terminal.press(typed)
        status = terminal.ends()
    return status, terminal.written.replace("\r\n", "\n")
