"""Running a command as a person sees it: in a terminal of its own, 88 columns wide, with colours.

Standard error goes elsewhere: how work goes on, how well this machine contains submissions, and faults.
"""

from __future__ import annotations

import fcntl
import os
import pty
import select
import struct
import subprocess
import tempfile
import termios
import time
from collections.abc import Mapping, Sequence
from pathlib import Path

COLUMNS = 88
_ROWS = 60
_SECONDS = 120
_UNWANTED = ("NO_COLOR", "COLUMNS", "JUDGE_PROBLEMS")


def run(command: Sequence[str], folder: Path, settings: Mapping[str, str]) -> tuple[int, str, str]:
    """The exit status, what the command showed, and what it wrote to standard error."""
    kept = {name: value for name, value in os.environ.items() if name not in _UNWANTED}
    environment = {**kept, "TERM": "xterm-256color", "PYTHONIOENCODING": "utf-8", **settings}
    ours, theirs = pty.openpty()
    with os.fdopen(ours, "rb", buffering=0), tempfile.TemporaryFile() as errors:
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", _ROWS, COLUMNS, 0, 0))
        process = subprocess.Popen(
            command, cwd=folder, env=environment, stdin=theirs, stdout=theirs, stderr=errors
        )
        os.close(theirs)
        written = _all_of(ours)
        status = process.wait(_SECONDS)
        errors.seek(0)
        return status, written.decode("utf-8").replace("\r\n", "\n"), errors.read().decode("utf-8")


def _all_of(terminal: int) -> bytes:
    """What is written until the last process there has ended."""
    written = b""
    end = time.monotonic() + _SECONDS
    while (left := end - time.monotonic()) > 0:
        if not select.select([terminal], [], [], left)[0]:
            break
        try:
            more = os.read(terminal, 65536)
        except OSError:  # how Linux tells that nobody is left at the other side
            break
        if not more:
            break
        written += more
    return written
