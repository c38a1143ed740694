"""Files without a name to pass to a container: memory on Linux, unlinked temporary files elsewhere."""

from __future__ import annotations

import contextlib
import fcntl
import os
import sys
from collections.abc import Iterator

from judge.sandbox.inside import wire
from judge.sandbox.inside.again import again


def nameless(data: bytes = b"") -> int:
    """A descriptor of a new nameless file holding `data`, positioned at its start."""
    descriptor = _create(0)
    try:
        rest = memoryview(data)
        while rest:
            rest = rest[os.write(descriptor, rest) :]
        os.lseek(descriptor, 0, os.SEEK_SET)
    except BaseException:
        os.close(descriptor)
        raise
    return descriptor


def region() -> tuple[int, wire.Region]:
    """A new region and its descriptor; on Linux its size is sealed, so that no user can pull it away."""
    descriptor = _create(os.MFD_ALLOW_SEALING if sys.platform == "linux" else 0)
    try:
        os.ftruncate(descriptor, wire.REGION_BYTES)
        if sys.platform == "linux":
            seals = fcntl.F_SEAL_SHRINK | fcntl.F_SEAL_GROW | fcntl.F_SEAL_SEAL
            fcntl.fcntl(descriptor, fcntl.F_ADD_SEALS, seals)
        return descriptor, wire.Region(descriptor)
    except BaseException:
        os.close(descriptor)
        raise


@contextlib.contextmanager
def files(*contents: bytes) -> Iterator[list[int]]:
    """Descriptors of new files that hold these, closed at the end."""
    opened: list[int] = []
    try:
        for data in contents:
            opened.append(nameless(data))
        contents, data = (), b""  # they may be large
        yield opened
    finally:
        for descriptor in opened:
            os.close(descriptor)


def part(descriptor: int, start: int, length: int) -> bytes:
    """So many bytes of a file from `start` on, fewer where it ends."""
    return os.pread(descriptor, max(0, min(length, size(descriptor) - start)), start)


def size(descriptor: int) -> int:
    """A file's length in bytes."""
    return os.fstat(descriptor).st_size


def tail(descriptor: int, most: int) -> bytes:
    """The last `most` bytes of a file, fewer if it is shorter."""
    return os.pread(descriptor, most, max(0, size(descriptor) - most))


def _create(flags: int) -> int:
    if sys.platform != "linux":
        return _unlinked()
    return again(lambda: os.memfd_create("judge", os.MFD_CLOEXEC | flags))


def _unlinked() -> int:
    import tempfile  # slow to import, and Linux does without

    descriptor, path = again(lambda: tempfile.mkstemp(prefix="judge-"))
    os.unlink(path)  # noqa: PTH108 - nothing to see before it is gone
    return descriptor
