"""Noticing that a file was saved, however an editor does that: in place, by truncating, or by renaming."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from pathlib import Path

from msgspec import Struct

_STEP = 50  # milliseconds without a further change that end a burst of them
_BURST = 400  # milliseconds that a burst may last
_GRACE = 2.0  # seconds for the thread to end
_PAUSE = 0.05  # seconds in which a file that is written on would change
_PAUSES = 20  # of them at most
_PATIENCE = 6  # pauses for a file that is being replaced


class SavedMark(Struct, frozen=True):
    """What changes with every save."""

    file: int  # the inode: another one after a rename
    size: int
    changed: int  # nanoseconds


def mark(path: Path) -> SavedMark | None:
    """The file's mark; None where there is none, or it cannot be seen."""
    try:
        found = path.stat()
    except (OSError, ValueError):
        return None
    return SavedMark(found.st_ino, found.st_size, found.st_mtime_ns)


def settled(path: Path) -> SavedMark | None:
    """The file's mark once it has stopped changing; a missing or empty one is given time to come back."""
    before = mark(path)
    for pauses in range(1, _PAUSES + 1):
        time.sleep(_PAUSE)
        now = mark(path)
        there = now is not None and now.size > 0
        if now == before and (there or pauses >= _PATIENCE):
            break
        before = now
    return before


class Saves:
    """Calls `tell`, from a thread of its own, when something happens to a file; a context manager.

    What is told is only that it is time to look. Where nothing can be watched (too many watches, a strange
    file system, the folder gone) it stays silent: whoever waits should look now and then.
    """

    def __init__(self, path: Path, tell: Callable[[], None]) -> None:
        self._path = path
        self._tell = tell
        self._end = threading.Event()
        self._thread = threading.Thread(target=self._watch, name="saves", daemon=True)

    def __enter__(self) -> Saves:
        import watchfiles  # noqa: F401 - not in the thread: Ctrl-C in an import may leave its lock taken

        self._thread.start()
        return self

    def __exit__(self, *exc: object) -> None:
        self._end.set()
        self._thread.join(_GRACE)

    def _watch(self) -> None:
        from watchfiles import watch

        # A link is saved where it leads to.
        places = {self._path.absolute(), self._path.resolve()}
        names = {place.name for place in places}
        try:
            for _ in watch(
                *{place.parent for place in places},
                watch_filter=lambda _change, path: Path(path).name in names,
                debounce=_BURST,
                step=_STEP,
                stop_event=self._end,
                raise_interrupt=False,
                recursive=False,
            ):
                self._tell()
        except (OSError, RuntimeError):  # of watchfiles, for every fault of the system's
            return
