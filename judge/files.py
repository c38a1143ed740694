"""Reading and writing files that others may touch, and the person's own folders.

Reading never waits for what may not come, and is not led elsewhere: opening a named pipe waits for a writer,
and opening some devices does something, so both are looked at first. Where others may set links, somebody
looks where they lead, and the file is then opened at that place, folder by folder, without following any: who
exchanges one meanwhile gains nothing.

A file is written beside its place, whole, and then put there at once:

    .judge-<16 hex digits>.tmp      the file while it is written, in the folder where it will be

A reader sees the old file or the new one. A judge that is killed leaves at most such a `.tmp`; the next one
to write into the folder takes it away. A writer holds a lock on its own until it is in place.
"""

from __future__ import annotations

import contextlib
import errno
import os
import re
import select
import stat
import sys
import time
from collections.abc import Container, Iterator
from pathlib import Path

from judge.errors import UsageError

_NAME = ".judge-{}.tmp"
_NAMES = re.compile(r"\.judge-[0-9a-f]{16}\.tmp")
_OLD = 60.0  # seconds; one that was begun just now may not be locked yet
_NO_LINKS = (errno.EPERM, errno.EOPNOTSUPP, errno.ENOSYS, errno.EMLINK, errno.EXDEV)
_NEW = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW | os.O_CLOEXEC
_AT_ONCE = 65536  # bytes
_FOR_READING = os.O_RDONLY | os.O_NONBLOCK | os.O_NOCTTY | os.O_CLOEXEC
_AS_A_FOLDER = getattr(os, "O_PATH", os.O_RDONLY) | os.O_DIRECTORY | os.O_CLOEXEC

# -- reading ------------------------------------------------------------------------------------------------


def read_ordinary(path: Path, most: int = -1, owners: Container[int] | None = None) -> bytes:
    """The first `most` bytes of an ordinary file, all of them without it.

    Raises:
        OSError: it cannot be read, or is not of one of the `owners`; of what is not an ordinary file its text
            says that.
        ValueError: there is a NUL in the name.
    """
    _check_ordinary(path.stat())
    content, found = _read(os.open(path, _FOR_READING), most)  # what is there may have changed since
    if owners is not None and found.st_uid not in owners:
        raise PermissionError(errno.EPERM, "it is another user's")
    return content


def read_ordinary_text(path: Path) -> str:
    """The text of an ordinary file in UTF-8, its lines ended by newlines alone.

    Raises OSError as `read_ordinary` does, UnicodeDecodeError where it is no such text.
    """
    return read_ordinary(path).decode().replace("\r\n", "\n").replace("\r", "\n")


class RefusedError(OSError):
    """Of a file that is there and is not to be read; its text says why."""


def real_within(root: str, path: str) -> str:
    """Where the links of a path lead that begins in the folder `root`, itself real: a path from there on.

    Raises RefusedError where it leads out of the folder, OSError where there is nothing.
    """
    real = os.path.realpath(os.path.join(root, path), strict=True)  # noqa: PTH118 - of any name
    inside = os.path.relpath(real, root)
    if inside == os.pardir or inside.startswith(os.pardir + os.sep):
        raise RefusedError(errno.EXDEV, f"it is a link out of the folder, {NOT_FOLLOWED}")
    return inside


def read_inside(root: str, path: str, most: int = -1) -> tuple[bytes, os.stat_result]:
    """The first `most` bytes of an ordinary file below the folder `root`, and its status; follows no link.

    `path` is from there on, as `real_within` gives it. Raises OSError as `read_ordinary` does, and where
    there is a link by now.
    """
    *folders, name = Path(path).parts
    here = os.open(root, _AS_A_FOLDER)
    try:
        for folder in folders:
            above, here = here, os.open(folder, _AS_A_FOLDER | os.O_NOFOLLOW, dir_fd=here)
            os.close(above)
        _check_ordinary(os.stat(name, dir_fd=here, follow_symlinks=False))
        return _read(os.open(name, _FOR_READING | os.O_NOFOLLOW, dir_fd=here), most)
    finally:
        os.close(here)


def _read(descriptor: int, most: int) -> tuple[bytes, os.stat_result]:
    with os.fdopen(descriptor, "rb") as file:
        found = os.fstat(descriptor)
        _check_ordinary(found)
        return file.read(most), found


def _check_ordinary(found: os.stat_result) -> None:
    if stat.S_ISDIR(found.st_mode):
        raise RefusedError(errno.EISDIR, "it is a folder")
    if not stat.S_ISREG(found.st_mode):
        raise RefusedError(errno.EINVAL, "it is not an ordinary file")


def read_pipe(path: Path, most: int, silence: float) -> bytes:
    """What comes through a pipe until its end or up to `most` bytes.

    Raises RefusedError where nothing came for `silence` seconds, OSError where it cannot be read.
    """
    with os.fdopen(os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC), "rb", 0) as pipe:
        came = select.poll()
        came.register(pipe, select.POLLIN)
        content = b""
        while len(content) < most:
            part = pipe.read(min(_AT_ONCE, most - len(content)))  # None where nothing has come yet
            if part == b"":
                break
            if part is None and not came.poll(silence * 1000):
                what = f"nothing came through this pipe for {silence:g} seconds"
                raise RefusedError(errno.ETIMEDOUT, f"{what}; write the program to a file, and name that")
            content += part or b""
        return content


# -- programs in a folder that others fill -------------------------------------------------------------------

LARGEST = 4 * 2**20  # bytes of a program; no person writes more
NOT_FOLLOWED = "which is not followed: put the file itself there"
_MOST, _DEEPEST = 100_000, 20  # files and folders below one, and levels of folders
_LEFT_OUT = "node_modules"  # of programs that nobody has handed in
_ENVIRONMENT = "pyvenv.cfg"  # what a virtual environment's folder holds


def files_below(root: Path) -> Iterator[tuple[str, str]]:
    """Every file below a folder, by its path from there, a folder's own before those of its folders; and each
    folder that is not entered, with the reason.

    What is hidden is left out, and so are virtual environments. Raises UsageError where there is too much.
    """
    unread: list[OSError] = []
    count = 0
    for place, folders, files in os.walk(root, onerror=unread.append):
        here, within = Path(place), Path(place).relative_to(root)
        inner = sorted(each for each in filter(_is_looked_at, folders) if not _is_environment(here / each))
        folders.clear()
        count += len(files) + len(inner)
        if count > _MOST:
            what, remedy = f"this folder holds more than {_MOST:,} files", "name a smaller one"
            raise UsageError(what, where=str(root), remedy=remedy)
        for name in sorted(filter(_is_looked_at, files)):
            yield str(within / name), ""
        for name in inner:
            if (here / name).is_symlink():  # it may lead back
                yield str(within / name), f"it is a link to a folder, {NOT_FOLLOWED}"
            elif len(within.parts) == _DEEPEST - 1:
                yield str(within / name), f"this folder lies more than {_DEEPEST} levels down"
            else:
                folders.append(name)
    for fault in unread:
        yield str(Path(fault.filename or root).relative_to(root)), why_unreadable(fault)


def _is_looked_at(name: str) -> bool:
    return not name.startswith((".", "__")) and name != _LEFT_OUT


def _is_environment(folder: Path) -> bool:
    return os.path.lexists(folder / _ENVIRONMENT)


def read_below(root: Path, path: str) -> tuple[bytes, str, os.stat_result]:
    """The bytes of a program below a real folder, where its links lead from there on, and its status.

    Raises OSError: `why_unreadable` says why it is not read.
    """
    real = real_within(str(root), path)
    source, found = read_inside(str(root), real, LARGEST + 1)
    return within_limit(source), real, found


def within_limit(source: bytes) -> bytes:
    """The same bytes. Raises RefusedError where they are more than a program has."""
    if len(source) > LARGEST:
        raise RefusedError(errno.EFBIG, f"this file is larger than {LARGEST // 2**20} MB")
    return source


def unreadable(path: Path, fault: OSError | ValueError, remedy: str) -> UsageError:
    """The error that says that `path` cannot be read, and why."""
    reason = (getattr(fault, "strerror", None) or "no name for a file").lower()
    return UsageError(f"cannot be read ({reason})", where=str(path), remedy=remedy)


def why_unreadable(fault: OSError) -> str:
    """Why what is in a folder cannot be read, or is not."""
    if isinstance(fault, RefusedError):
        return str(fault.strerror)
    if isinstance(fault, FileNotFoundError):
        return "it is a link to a file that is not there"
    return f"cannot be read ({(fault.strerror or 'it failed').lower()})"


# -- writing ------------------------------------------------------------------------------------------------


def replace_file(path: Path, content: bytes, *, follow_links: bool = True) -> None:
    """Put `content` at `path`, whatever file is there; of two writers at a time one wins. Raises OSError.

    Where a link leads, so that it stays one; a file that is replaced passes on its permissions. Without
    `follow_links` at `path` itself, and what is there passes nothing on.
    """
    # Unlike Path.resolve, realpath takes a loop of links for a file.
    place = Path(os.path.realpath(path)) if follow_links else path
    mode = None
    with contextlib.suppress(FileNotFoundError):
        if follow_links:
            found = place.stat()
            _check_ordinary(found)
            mode = found.st_mode & 0o777
    with _written_beside(place, content, mode) as temporary:
        temporary.replace(place)


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
            os.close(os.open(path, _NEW, 0o666))  # without links: nobody else's file is lost in between
            temporary.replace(path)


def sweep(folder: Path) -> None:
    """Take away what judges of this user that are dead left in `folder` while they wrote; silently.

    Nothing but ordinary files that are named as above, old and not locked; no link is followed.
    """
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if _NAMES.fullmatch(entry.name) and entry.is_file(follow_symlinks=False):
                with contextlib.suppress(OSError):  # it is gone, or no business of ours
                    _take_away(entry.path)


def _take_away(path: str) -> None:
    with os.fdopen(os.open(path, _FOR_READING | os.O_NOFOLLOW), "rb") as file:
        found = os.fstat(file.fileno())
        ours = stat.S_ISREG(found.st_mode) and found.st_uid == os.geteuid()
        if ours and time.time() - found.st_mtime > _OLD:
            _lock(file.fileno())  # refused while its writer lives
            os.unlink(path)  # noqa: PTH108 - which follows no link either


def _lock(descriptor: int) -> None:
    import fcntl

    fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)


@contextlib.contextmanager
def _written_beside(place: Path, content: bytes, mode: int | None) -> Iterator[Path]:
    """A new file with that content and those permissions in the folder of `place`; gone afterwards."""
    sweep(place.parent)
    temporary = place.with_name(_NAME.format(os.urandom(8).hex()))
    with os.fdopen(os.open(temporary, _NEW, 0o666), "wb") as file:  # less what the umask takes away
        try:
            with contextlib.suppress(OSError):  # a file system without locks: its age protects it
                _lock(file.fileno())
            file.write(content)
            file.flush()
            if mode not in (None, stat.S_IMODE(os.fstat(file.fileno()).st_mode)):
                os.fchmod(file.fileno(), mode)
            yield temporary
        finally:
            temporary.unlink(missing_ok=True)


# -- the person's own folders -------------------------------------------------------------------------------

CACHE_VARIABLE = "JUDGE_CACHE"
_FOLDER = "circle-line-judge"


def cache_folder() -> Path:
    """Where the judge keeps what it can make again: $JUDGE_CACHE, or its folder among the person's caches.

    Raises RuntimeError where there is no home folder.
    """
    own = os.environ.get(CACHE_VARIABLE)
    return Path(own) if own else _folder("XDG_CACHE_HOME", ".cache", "user_cache_path")


def user_data() -> Path:
    """The judge's folder among the person's data. Raises RuntimeError where there is no home folder."""
    return _folder("XDG_DATA_HOME", ".local/share", "user_data_path")


def _folder(variable: str, below_home: str, function: str) -> Path:
    """By the XDG Base Directory Specification; off Linux, or without a home, as platformdirs has it.

    That knows every system, and to import it takes longer than many a judging.
    """
    if sys.platform == "linux" and "ANDROID_ROOT" not in os.environ:
        base, home = os.environ.get(variable, ""), os.environ.get("HOME", "")
        if base.startswith("/"):
            return Path(base, _FOLDER)
        if home.startswith("/"):
            return Path(home, below_home, _FOLDER)
    import platformdirs  # seldom

    path: Path = getattr(platformdirs, function)(_FOLDER, appauthor=False)
    return path
