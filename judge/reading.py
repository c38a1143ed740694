"""Reading what somebody has named, without ever waiting for what may not come, or being led elsewhere.

Opening a named pipe waits for a writer, and opening some devices does something: both are looked at first.
Where others may set links, somebody looks where they lead, and the file is then opened at that place, folder
by folder, without following any: who exchanges one meanwhile gains nothing.
"""

from __future__ import annotations

import errno
import os
import select
import stat
from collections.abc import Container
from pathlib import Path

_AT_ONCE = 65536  # bytes
_FOR_READING = os.O_RDONLY | os.O_NONBLOCK | os.O_NOCTTY | os.O_CLOEXEC
_AS_A_FOLDER = getattr(os, "O_PATH", os.O_RDONLY) | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC


def read_ordinary(path: Path, most: int = -1, owners: Container[int] | None = None) -> bytes:
    """The first `most` bytes of an ordinary file, all of them without it.

    Raises:
        OSError: it cannot be read, or is not of one of the `owners`; of what is no ordinary file its text
            says that.
        ValueError: there is a NUL in the name.
    """
    check_ordinary(path.stat())
    content, found = _read(os.open(path, _FOR_READING), most)  # what is there may have changed since
    if owners is not None and found.st_uid not in owners:
        raise PermissionError(errno.EPERM, "it is another user's")
    return content


class LedOutError(OSError):
    """A path that links lead out of the folder that it begins in."""


def real_within(root: str, path: str) -> str:
    """Where the links of a path lead that begins in the folder `root`, itself real: a path from there on.

    Raises:
        LedOutError: it leads out of the folder.
        OSError: there is nothing.
    """
    real = os.path.realpath(os.path.join(root, path), strict=True)  # noqa: PTH118 - of any name
    inside = os.path.relpath(real, root)
    if inside == os.pardir or inside.startswith(os.pardir + os.sep):
        raise LedOutError(errno.EXDEV, "it leads out of the folder")
    return inside


def read_inside(root: str, path: str, most: int = -1) -> tuple[bytes, os.stat_result]:
    """The first `most` bytes of an ordinary file below the folder `root`, and its status; follows no link.

    `path` is from there on, as `real_within` gives it. Raises OSError as `read_ordinary` does, and where
    there is a link by now.
    """
    here = os.open(root, _AS_A_FOLDER & ~os.O_NOFOLLOW)
    try:
        *folders, name = Path(path).parts
        for folder in folders:
            there = os.open(folder, _AS_A_FOLDER, dir_fd=here)
            os.close(here)
            here = there
        check_ordinary(os.stat(name, dir_fd=here, follow_symlinks=False))
        return _read(os.open(name, _FOR_READING | os.O_NOFOLLOW, dir_fd=here), most)
    finally:
        os.close(here)


def _read(descriptor: int, most: int) -> tuple[bytes, os.stat_result]:
    with os.fdopen(descriptor, "rb") as file:
        found = os.fstat(descriptor)
        check_ordinary(found)
        return file.read(most), found


def read_ordinary_text(path: Path) -> str:
    """The text of an ordinary file in UTF-8, its lines ended by newlines alone.

    Raises:
        OSError: as `read_ordinary` does.
        UnicodeDecodeError: it is no such text.
    """
    return read_ordinary(path).decode().replace("\r\n", "\n").replace("\r", "\n")


def check_ordinary(found: os.stat_result) -> None:
    """Raise OSError unless that is an ordinary file."""
    if stat.S_ISDIR(found.st_mode):
        raise IsADirectoryError(errno.EISDIR, "it is a folder")
    if not stat.S_ISREG(found.st_mode):
        raise OSError(errno.EINVAL, "it is no ordinary file")


def read_pipe(path: Path, most: int, silence: float) -> bytes:
    """What comes through a pipe until its end or up to `most` bytes.

    Raises:
        TimeoutError: nothing came for `silence` seconds.
        OSError: it cannot be read.
    """
    descriptor = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
    try:
        came = select.poll()
        came.register(descriptor, select.POLLIN)
        content = bytearray()
        while len(content) < most:
            try:
                part = os.read(descriptor, min(_AT_ONCE, most - len(content)))
            except BlockingIOError:
                if not came.poll(silence * 1000):
                    raise TimeoutError(errno.ETIMEDOUT, os.strerror(errno.ETIMEDOUT)) from None
                continue
            if not part:
                break
            content += part
        return bytes(content)
    finally:
        os.close(descriptor)
