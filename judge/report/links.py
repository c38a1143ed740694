"""Paths that a terminal makes clickable (OSC 8), and plain ones everywhere else."""

from __future__ import annotations

import os
from pathlib import Path
from typing import IO

from judge.report.layout import printable
from judge.report.screen import is_terminal


def file_link(path: Path, stream: IO[str]) -> str:
    """The path as it was given, on a terminal a link to the file."""
    encoding = getattr(stream, "encoding", None) or "utf-8"
    text = printable(str(path)).encode(encoding, "backslashreplace").decode(encoding)
    if not is_terminal(stream) or os.environ.get("TERM") == "dumb":
        return text
    return f"\x1b]8;;{path.absolute().as_uri()}\x1b\\{text}\x1b]8;;\x1b\\"
