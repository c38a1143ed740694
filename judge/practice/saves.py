"""Noticing that a file was saved, however an editor does that: in place, by truncating, or by renaming.

It is looked at ten times a second, which costs next to nothing, on any file system and through links.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from pathlib import Path

_LOOK = 0.1  # seconds between two looks
_GRACE = 2.0  # seconds for the thread to end: a file system may hang
_PAUSE = 0.05  # seconds in which a file that is written on would change
_PAUSES = 20  # of them at most
_PATIENCE = 6  # pauses for a file that is being replaced

SavedMark = tuple[int, int, int]  # what changes with every save: the inode, the size, the time in nanoseconds


def mark(path: Path) -> SavedMark | None:
    """The file's mark; None where there is none, or it cannot be seen."""
    try:
        found = path.stat()
    except (OSError, ValueError):
        return None
    return found.st_ino, found.st_size, found.st_mtime_ns


def settled(path: Path) -> SavedMark | None:
    """The file's mark once it has stopped changing; a missing or empty one is given time to come back."""
    before = mark(path)
    for pauses in range(1, _PAUSES + 1):
        time.sleep(_PAUSE)
        now = mark(path)
        if now == before and ((now and now[1]) or pauses >= _PATIENCE):
            break
        before = now
    return before


class Saves:
    """Calls `tell`, from a thread of its own, when a file has changed; a context manager."""

    def __init__(self, path: Path, tell: Callable[[], None]) -> None:
        self._path, self._tell, self._end = path, tell, threading.Event()
        self._thread = threading.Thread(target=self._watch, name="saves", daemon=True)

    def __enter__(self) -> Saves:
        self._thread.start()
        return self

    def __exit__(self, *exc: object) -> None:
        self._end.set()
        self._thread.join(_GRACE)

    def _watch(self) -> None:
        seen = mark(self._path)
        while not self._end.wait(_LOOK):
            if (now := mark(self._path)) != seen:
                seen = now
                self._tell()
