"""The one way in which the judge writes a file: beside its place, whole, and then put there at once.

    .judge-<16 hex digits>.tmp      the file while it is written, in the folder where it will be

A reader sees the old file or the new one. A judge that is killed leaves at most such a `.tmp`; the next one
to write into the folder takes it away. A writer holds a lock on its own until it is in place.
"""

from __future__ import annotations

import contextlib
import errno
import os
import re
import stat
import time
from collections.abc import Iterator
from pathlib import Path

from judge.reading import check_ordinary

_NAME = ".judge-{}.tmp"
_NAMES = re.compile(r"\.judge-[0-9a-f]{16}\.tmp")
_OLD = 60.0  # seconds; one that was begun just now may not be locked yet
_NO_LINKS = (errno.EPERM, errno.EOPNOTSUPP, errno.ENOSYS, errno.EMLINK, errno.EXDEV)


def replace_file(path: Path, content: bytes) -> None:
    """Put `content` at `path`, whatever file is there; of two writers at a time one wins. Raises OSError.

    Where a link leads, so that it stays one. A file that is replaced passes on its permissions.
    """
    place = Path(os.path.realpath(path))  # unlike Path.resolve it takes a loop of links for a file
    with _written_beside(place, content, _mode(place)) as temporary:
        temporary.replace(place)


def put_file(path: Path, content: bytes) -> None:
    """Put `content` at `path` itself: what is there passes nothing on, and no link is followed.

    Raises OSError.
    """
    with _written_beside(path, content, None) as temporary:
        temporary.replace(path)


def new_file(path: Path, content: bytes) -> None:
    """Put `content` at `path`, where nothing may be.

    Raises:
        FileExistsError: something is there, be it a link that leads nowhere; it is left as it is.
        OSError: it cannot be written.
    """
    with _written_beside(path, content, None) as temporary:
        try:
            path.hardlink_to(temporary)
        except OSError as fault:
            if fault.errno not in _NO_LINKS:
                raise
            _take_place(path)  # a file system without links: nobody else's file is lost in between
            temporary.replace(path)


def sweep(folder: Path) -> None:
    """Take away what judges of this user that are dead left in `folder` while they wrote; silently.

    Nothing but ordinary files that are named as above, old and not locked; no link is followed.
    """
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if _NAMES.fullmatch(entry.name) and entry.is_file(follow_symlinks=False):
                _take_away(entry.path)


def _take_away(path: str) -> None:
    with contextlib.suppress(OSError):  # it is gone, or no business of ours
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
        try:
            found = os.fstat(descriptor)
            ours = stat.S_ISREG(found.st_mode) and found.st_uid == os.geteuid()
            if ours and time.time() - found.st_mtime > _OLD:
                import fcntl

                fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)  # refused while its writer lives
                os.unlink(path)  # noqa: PTH108 - which follows no link either
        finally:
            os.close(descriptor)


@contextlib.contextmanager
def _written_beside(place: Path, content: bytes, mode: int | None) -> Iterator[Path]:
    """A new file with that content and those permissions in the folder of `place`; gone afterwards."""
    sweep(place.parent)
    temporary = place.with_name(_NAME.format(os.urandom(8).hex()))
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW | os.O_CLOEXEC
    with os.fdopen(os.open(temporary, flags, 0o666), "wb") as file:  # less what the umask takes away
        try:
            with contextlib.suppress(OSError):  # a file system without locks: its age protects it
                import fcntl

                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            file.write(content)
            file.flush()
            if mode not in (None, stat.S_IMODE(os.fstat(file.fileno()).st_mode)):
                os.fchmod(file.fileno(), mode)
            yield temporary
        finally:
            temporary.unlink(missing_ok=True)


def _mode(place: Path) -> int | None:
    """The permissions of the file that is there; None where nothing is. Raises OSError for no file."""
    try:
        found = place.stat()
    except FileNotFoundError:
        return None
    check_ordinary(found)
    return found.st_mode & 0o777


def _take_place(path: Path) -> None:
    os.close(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o666))
