"""Folders for what is compiled and run; a killed judge's go when the next one makes its own.

<temporary folder>/judge-box-<random>     locked as long as its judge lives
"""

from __future__ import annotations

import contextlib
import fcntl
import os
import time
from collections.abc import Iterator
from pathlib import Path

_PREFIX = "judge-box-"
_OLD = 60.0  # seconds; one that was made just now may not be locked yet
_AS_A_FOLDER = os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC


@contextlib.contextmanager
def temporary_folder() -> Iterator[Path]:
    """A new folder that others may pass through, for a user that a container becomes. Raises OSError."""
    place = Path(os.environ.get("TMPDIR", ""))  # tempfile takes as long to import as all else of a start
    place = place if place.is_absolute() and place.is_dir() else Path("/tmp")
    sweep(place)
    path = place / f"{_PREFIX}{os.urandom(8).hex()}"
    path.mkdir(mode=0o700)  # before others may pass through
    path.chmod(0o711)
    lock = os.open(path, _AS_A_FOLDER)
    try:
        with contextlib.suppress(OSError):  # a file system without locks: its age protects it
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield path
    finally:
        _remove(str(path))
        os.close(lock)


def sweep(folder: Path) -> None:
    """Take away what judges of this user left there that are dead; silently, and following no link."""
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if entry.name.startswith(_PREFIX):
                _take_away(entry.path)


def _remove(path: str) -> None:
    """Take it away with all that is in it, as far as that goes."""
    with contextlib.suppress(OSError):
        _empty(path)
        Path(path).rmdir()


def _take_away(path: str) -> None:
    with contextlib.suppress(OSError):  # it is gone, in use, or no business of ours
        descriptor = os.open(path, _AS_A_FOLDER)
        try:
            found = os.fstat(descriptor)
            if found.st_uid == os.geteuid() and time.time() - found.st_mtime > _OLD:
                fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)  # refused while its judge lives
                _remove(path)
        finally:
            os.close(descriptor)


def _empty(folder: str) -> None:
    """Take away all that is below it, no link followed, where nobody changes it meanwhile. Raises OSError.

    What lies in a folder below is taken up beside that, so that however deep they are no path grows long.
    """
    top = os.open(folder, _AS_A_FOLDER)
    try:
        waiting = _without_files(top, top)
        while waiting:
            here = os.open(waiting[-1], _AS_A_FOLDER, dir_fd=top)
            try:
                inner = _without_files(here, top)
            finally:
                os.close(here)
            os.rmdir(waiting.pop(), dir_fd=top)
            waiting += inner
    finally:
        os.close(top)


def _without_files(folder: int, into: int) -> list[str]:
    """Take the files of an open folder away, and its folders into another one; their names there."""
    folders = []
    for entry in list(os.scandir(folder)):
        if entry.is_dir(follow_symlinks=False):
            os.chmod(entry.name, 0o700, dir_fd=folder)
            folders.append(os.urandom(8).hex())
            os.rename(entry.name, folders[-1], src_dir_fd=folder, dst_dir_fd=into)
        else:
            os.unlink(entry.name, dir_fd=folder)
    return folders
