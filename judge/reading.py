"""Reading what somebody has named, without ever waiting for what may not come.

Opening a named pipe waits for a writer, and opening some devices does something: both are looked at first.
"""

from __future__ import annotations

import errno
import os
import select
import stat
from collections.abc import Container
from pathlib import Path

_AT_ONCE = 65536  # bytes


def read_ordinary(path: Path, most: int = -1, owners: Container[int] | None = None) -> bytes:
    """The first `most` bytes of an ordinary file, all of them without it.

    Raises:
        OSError: it cannot be read, or is not of one of the `owners`; of what is no ordinary file its text
            says that.
        ValueError: there is a NUL in the name.
    """
    check_ordinary(path.stat())
    # What is there may have changed since.
    descriptor = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_NOCTTY | os.O_CLOEXEC)
    with os.fdopen(descriptor, "rb") as file:
        found = os.fstat(descriptor)
        check_ordinary(found)
        if owners is not None and found.st_uid not in owners:
            raise PermissionError(errno.EPERM, "it is another user's")
        return file.read(most)


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
