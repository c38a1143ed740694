"""What a hostile program left in a folder: how much it is, and taking it away, however deep it lies."""

from __future__ import annotations

import errno
import os
import stat

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

AS_A_FOLDER = os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC


def holds_more(folder: str, files: int, size: int) -> bool:
    """Whether more than so many files and folders, or bytes, are below it; also where that cannot be told."""
    try:
        for found in _below(folder):
            files -= 1
            size -= found.st_size if stat.S_ISREG(found.st_mode) else 0
            if files < 0 or size < 0:
                return True
    except OSError:
        return True
    return False


def _below(folder: str) -> Iterator[os.stat_result]:
    """What is below it, no link followed; what goes meanwhile is passed over."""
    for entry in os.scandir(folder):
        try:
            yield entry.stat(follow_symlinks=False)
            if entry.is_dir(follow_symlinks=False):
                yield from _below(entry.path)
        except FileNotFoundError:
            continue


def empty(folder: str) -> None:
    """Take away all that is below it, no link followed, where nobody changes it meanwhile. Raises OSError."""
    here = os.open(folder, AS_A_FOLDER)
    above: list[tuple[tuple[int, int], list[str]]] = []  # the folders on the way, and what they still hold
    try:
        inner = _without_files(here)
        while inner or above:
            if inner:
                os.chmod(inner[-1], 0o700, dir_fd=here)
                above.append((_place(here), inner))
                here = _gone(here, inner[-1])
                inner = _without_files(here)
            else:
                place, inner = above.pop()
                here = _gone(here, "..")
                if _place(here) != place:
                    raise OSError(errno.ESTALE, os.strerror(errno.ESTALE))
                os.rmdir(inner.pop(), dir_fd=here)
    finally:
        os.close(here)


def _gone(here: int, name: str) -> int:
    """The folder of that name in an open one, which is closed."""
    there = os.open(name, AS_A_FOLDER, dir_fd=here)
    os.close(here)
    return there


def _place(descriptor: int) -> tuple[int, int]:
    found = os.fstat(descriptor)
    return found.st_dev, found.st_ino


def _without_files(descriptor: int) -> list[str]:
    """Take the files of a folder away; the names of its folders."""
    folders = []
    for entry in list(os.scandir(descriptor)):
        if entry.is_dir(follow_symlinks=False):
            folders.append(entry.name)
        else:
            os.unlink(entry.name, dir_fd=descriptor)
    return folders
