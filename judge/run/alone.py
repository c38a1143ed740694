"""A place to measure in that is alone on the machine, for all processes in which one user judges.

    <folder>/door     held in passing by who begins to judge, and all the while by who measures or waits to
    <folder>/room     shared by those who judge, held alone by who measures

The folder is the one that $JUDGE_LOCKS names, else `judge` in $XDG_RUNTIME_DIR, else `judge-locks-<user id>`
among the temporary files. One that is a link, another user's, or open to others is not used: whoever can
plant it could keep us waiting. So the locks are of one user, and two users' judges do not know each other.

A lock belongs to an open file: every use opens the files anew. The kernel gives it back when the process
ends, however that ends. Whoever holds one for ever, stopped perhaps, keeps nobody for ever: patience is
bounded, and what is measured then is known not to be alone.
"""

from __future__ import annotations

import os
import stat
import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager, nullcontext, suppress
from pathlib import Path
from typing import NamedTuple

try:
    import fcntl
except ImportError:  # nothing to lock with: each process is alone as far as it knows
    fcntl = None  # type: ignore[assignment]

VARIABLE = "JUDGE_LOCKS"
PATIENCE_SECONDS = 30.0  # longer than an honest queue, short enough for a person
_LITTLE_SECONDS = 0.5  # once that was in vain, until it is not
_SHORTEST_PAUSE, _LONGEST_PAUSE = 0.001, 0.02  # seconds between two tries
_FOLDER = os.O_RDONLY | getattr(os, "O_DIRECTORY", 0) | getattr(os, "O_NOFOLLOW", 0)
_FILE = os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
_OTHERS_WRITE = stat.S_IWGRP | stat.S_IWOTH


class Admitted(NamedTuple):
    """Who measures is `alone` unless it is known that it is not; `waited` is for how many seconds."""

    alone: bool = True
    waited: float = 0.0


Tell = Callable[[int, int], None]  # seconds waited, seconds at most
Waiting = Callable[[], AbstractContextManager[Tell | None]]


class MeasureLock:
    """The two locks of the user's judges; without a folder for them everyone is let in at once.

    `waiting` opens what a person who waits is told by, once there is somebody to wait for.
    """

    def __init__(
        self,
        *,
        waiting: Waiting = nullcontext,
        patience: float = PATIENCE_SECONDS,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._waiting = waiting
        self._whole_patience = patience
        self._clock = clock
        self._patience = patience  # little, once it was in vain

    def judging(self) -> AbstractContextManager[Admitted]:
        """Be one of those who judge; not to be asked for by who has a place already."""
        return self._placed(alone=False)

    def measuring(self) -> AbstractContextManager[Admitted]:
        """Be the only one; not to be asked for by who has a place already."""
        return self._placed(alone=True)

    @contextmanager
    def _placed(self, *, alone: bool) -> Iterator[Admitted]:
        begun, had = self._clock(), True
        until = begun + self._patience
        with ExitStack() as held:
            folder = _opened(held)
            if folder is not None:
                with ExitStack() as passing:
                    through = self._take("door", folder, until, alone=True, held=held if alone else passing)
                    had = self._take("room", folder, until, alone=alone, held=held) and through
                # Who hangs may hang for ever: only the first wait for it is long.
                self._patience = self._whole_patience if had else min(_LITTLE_SECONDS, self._patience)
            yield Admitted(had, self._clock() - begun)

    def _take(self, name: str, folder: int, until: float, *, alone: bool, held: ExitStack) -> bool:
        """Hold the lock as long as `held` does; whether it was had in time. Nothing is held where it was not.

        Where the file system knows no locks, nobody else has them either.
        """
        with ExitStack() as mine:
            try:
                file = os.open(name, _FILE | os.O_CLOEXEC, 0o600, dir_fd=folder)
                mine.callback(os.close, file)
                found = os.fstat(file)
                if not stat.S_ISREG(found.st_mode) or found.st_uid != os.geteuid():
                    return True
                taken = self._wait_for(file, fcntl.LOCK_EX if alone else fcntl.LOCK_SH, until)
            except OSError:
                return True
            if taken:
                held.push(mine.pop_all())  # closing the file gives the lock back
            return taken

    def _wait_for(self, file: int, how: int, until: float) -> bool:
        """Try until it is had or the time is up; Ctrl-C comes through between two tries."""
        if _had(file, how):
            return True
        begun, pause = self._clock(), _SHORTEST_PAUSE
        with self._waiting() as tell:
            while (now := self._clock()) < until:
                if tell is not None:
                    tell(int(now - begun), round(until - begun))
                time.sleep(pause)
                if _had(file, how):
                    return True
                pause = min(2 * pause, _LONGEST_PAUSE)
        return False


def _had(file: int, how: int) -> bool:
    try:
        fcntl.flock(file, how | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    return True


def _opened(held: ExitStack) -> int | None:
    """The folder of the locks, open as long as `held` is; None where there is none to be trusted."""
    if fcntl is None or os.open not in os.supports_dir_fd:
        return None
    for path in _folders():
        try:
            with suppress(FileExistsError):
                path.mkdir(0o700)
            folder = os.open(path, _FOLDER | os.O_CLOEXEC)
        except OSError:
            continue
        if _ours(os.fstat(folder)):
            held.callback(os.close, folder)
            return folder
        os.close(folder)
    return None


def _folders() -> Iterator[Path]:
    own = os.environ.get(VARIABLE)
    if own:
        yield Path(own)
        return
    runtime = Path(os.environ.get("XDG_RUNTIME_DIR", ""))
    with suppress(OSError):
        if runtime.is_absolute() and _ours(runtime.stat()):  # not so after `su`
            yield runtime / "judge"
    with suppress(OSError):  # of whoever has no folder for temporary files
        # tempfile would be slow to import
        yield Path(os.environ.get("TMPDIR") or "/tmp", f"judge-locks-{os.geteuid()}")


def _ours(found: os.stat_result) -> bool:
    return found.st_uid == os.geteuid() and not found.st_mode & _OTHERS_WRITE
