"""Writing a package: whole, beside its place, and then put there at once.

    .judge-export-<16 hex digits>    a package while it is written, and then the one that it replaces

Only a package of the same problem is replaced, which its uuid tells; whatever else is there stays.
"""

from __future__ import annotations

import contextlib
import ctypes
import fcntl
import os
import re
import shutil
import time
import zipfile
from collections.abc import Iterator
from pathlib import Path

from judge.errors import UsageError, unwritable
from judge.files import replace_file
from judge.packs.export.package import Files

_NAMES = re.compile(r"\.judge-export-[0-9a-f]{16}")
_REMEDY = "name another folder with --out, or move it away"
_OLD = 60.0  # seconds; one that was begun just now may not be locked yet
_EXCHANGE = 2  # of renameat2
_HERE = -100  # AT_FDCWD
_MOST = 65536  # bytes of a problem.yaml that are read


def check_folder(place: Path, uuid: str) -> None:
    """Raises UsageError unless nothing is there, or our package of that uuid."""
    if not os.path.lexists(place):
        return
    if place.is_symlink() or not place.is_dir() or not _says(place / "problem.yaml", uuid):
        raise UsageError("it is not a package of this kata", where=str(place), remedy=_REMEDY)


def check_archive(place: Path, uuid: str) -> None:
    """The same for an archive."""
    if not os.path.lexists(place):
        return
    if place.is_symlink() or not place.is_file() or not _archive_says(place, uuid):
        raise UsageError("it is not a package of this kata", where=str(place), remedy=_REMEDY)


def write_folder(place: Path, files: Files) -> None:
    """Put a package there; one that is there is replaced as a whole. Raises UsageError."""
    try:
        place.parent.mkdir(parents=True, exist_ok=True)
        _sweep(place.parent)
        with _beside(place) as new:
            for path, content in files.items():
                target = new / path
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(content)
            if os.path.lexists(place):
                _exchange(new, place)
            else:
                new.rename(place)
    except OSError as fault:
        raise unwritable(place, fault, _REMEDY) from fault


def write_archive(place: Path, content: bytes) -> None:
    """Put an archive there. Raises UsageError."""
    try:
        place.parent.mkdir(parents=True, exist_ok=True)
        replace_file(place, content)
    except OSError as fault:
        raise unwritable(place, fault, _REMEDY) from fault


@contextlib.contextmanager
def _beside(place: Path) -> Iterator[Path]:
    """A new folder beside the place, locked while it is in use; what it is in the end is removed."""
    folder = place.with_name(f".judge-export-{os.urandom(8).hex()}")
    folder.mkdir()
    lock = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
    try:
        with contextlib.suppress(OSError):  # a file system without locks
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield folder
    finally:
        os.close(lock)
        if folder.is_dir():
            shutil.rmtree(folder, ignore_errors=True)


def _exchange(new: Path, old: Path) -> None:
    """Swap two folders: in one step where the system can."""
    try:
        done = ctypes.CDLL(None, use_errno=True).renameat2(
            _HERE, os.fsencode(new), _HERE, os.fsencode(old), _EXCHANGE
        )
    except AttributeError:
        done = -1
    if done == 0:
        return
    aside = old.with_name(f".judge-export-{os.urandom(8).hex()}")
    old.rename(aside)
    try:
        new.rename(old)
    except OSError:
        aside.rename(old)
        raise
    aside.rename(new)


def _sweep(folder: Path) -> None:
    """Take away what exports that were killed have left; silently."""
    with contextlib.suppress(OSError):
        for path in folder.iterdir():
            if _NAMES.fullmatch(path.name) and path.is_dir() and not path.is_symlink():
                _take_away(path)


def _take_away(path: Path) -> None:
    with contextlib.suppress(OSError):
        lock = os.open(path, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC)
        try:
            if time.time() - os.fstat(lock).st_mtime < _OLD:
                return
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)  # refused while its writer lives
            shutil.rmtree(path, ignore_errors=True)
        finally:
            os.close(lock)


def _says(path: Path, uuid: str) -> bool:
    """Whether a problem.yaml has that uuid."""
    try:
        with path.open("rb") as file:
            return _has(file.read(_MOST), uuid)
    except OSError:
        return False


def _archive_says(path: Path, uuid: str) -> bool:
    try:
        with zipfile.ZipFile(path) as archive:
            names = [name for name in archive.namelist() if name.rpartition("/")[2] == "problem.yaml"]
            if len(names) != 1:
                return False
            with archive.open(names[0]) as file:
                return _has(file.read(_MOST), uuid)
    except (OSError, zipfile.BadZipFile, RuntimeError, ValueError, NotImplementedError):
        return False


def _has(content: bytes, uuid: str) -> bool:
    return f"uuid: {uuid}".encode() in content.splitlines()
