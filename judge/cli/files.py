"""The files to judge, and those that options write.

All are read before the first is judged; of several, one that cannot be read is a row. A file to write is
refused before anything is judged, and written whole.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from errno import EACCES
from itertools import islice
from pathlib import Path

from msgspec import Struct

from judge.errors import UsageError, nearest, unwritable
from judge.files import (
    DANGLING,
    ENVIRONMENT,
    LARGEST,
    LED_OUT,
    LedOutError,
    is_dangling,
    read_inside,
    read_ordinary,
    read_pipe,
    real_within,
    replace_file,
    why_unreadable,
    within_limit,
)
from judge.languages import NAME, PATTERN, is_program

_MOST, _DEEPEST = 10_000, 20  # files in a folder, and levels of folders: a class is smaller
_SILENCE = 30.0  # seconds without a byte after which a pipe is given up
_LOOKED_AT = 2000  # bytes of a file in which it says what it is
_EPOCH = "SOURCE_DATE_EPOCH"  # the usual way to ask for the same bytes every time
_OWN_PIPES = ("/dev/", "/proc/")  # <(command) and /dev/stdin: a shell has started what writes there


class Submission(Struct, frozen=True):
    """A file to judge: its name as the person gave it, and its bytes."""

    name: str
    source: bytes


class Unjudged(Struct, frozen=True):
    """An entry that is not judged: its name, why, and the problem where it is known."""

    name: str
    why: str
    problem: str = ""


def read_submissions(names: Iterable[str]) -> list[Submission]:
    """The named files; a folder stands for the *.py in it. A file named twice is judged once.

    Raises:
        UsageError: one is missing, unreadable, no ordinary file or too large, or a folder holds no *.py.
    """
    submissions, unread = gathered(names, depth=0)
    if unread:
        raise UsageError(unread[0].why, where=unread[0].name)
    return submissions


def gathered(
    names: Iterable[str], problem: str = "", depth: int = _DEEPEST
) -> tuple[list[Submission], list[Unjudged]]:
    """The named files, as `read_submissions`, and those of several that cannot be read; `problem` is for all.

    A folder stands for every *.py in it and in its folders, but for hidden ones and virtual environments.

    Raises:
        UsageError: one is missing, the only one cannot be read, or a folder holds no *.py.
    """
    entries = dict.fromkeys(entry for name in names for entry in _entries(name, depth))
    submissions, unread = [], []
    for name, folder, why in entries:
        if not why:
            try:
                submissions.append(Submission(name, _read(name, folder)))
                continue
            except UsageError as fault:
                if len(entries) == 1:
                    raise
                why = DANGLING if is_dangling(name) else fault.what
        unread.append(Unjudged(name, why, problem))
    return submissions, unread


def _entries(name: str, depth: int) -> list[tuple[str, str, str]]:
    """The file of that name, or all that is to be judged in the folder, so many levels down.

    Each has its name, the folder that it was found in, "" if it was named, and why it cannot be read, if so.

    Raises:
        UsageError: there is nothing, or more than anybody would want.
    """
    if not name:  # which would be the current folder
        raise UsageError("no such file", where="''", remedy=f"name a {NAME} file")
    try:
        if not stat.S_ISDIR(Path(name).stat().st_mode):
            return [(name, "", "")]
        os.scandir(name).close()  # of a folder that cannot be read, that is said
    except OSError as fault:
        if is_dangling(name):
            return [(name, "", "")]
        raise _unreadable(name, fault) from fault
    except ValueError as fault:  # a NUL in the name
        raise UsageError("no such file", where=repr(name)) from fault
    found = [(path, name, why) for path, why in islice(_within(name, depth), _MOST + 1)]
    if len(found) > _MOST:
        what, remedy = f"this folder holds more than {_MOST:,} {PATTERN} files", "name a smaller one"
        raise UsageError(what, where=name, remedy=remedy)
    if not found:
        what, remedy = f"this folder holds no {PATTERN} file", "name a file, or a folder of submissions"
        raise UsageError(what, where=name, remedy=remedy)
    return found


def _within(folder: str, depth: int) -> Iterator[tuple[str, str]]:
    """The programs in a folder, in order, those of its own folders after its own, so many levels down.

    What is to be judged and cannot be comes with the reason.
    """
    try:
        with os.scandir(folder) as scanned:
            entries = sorted((entry.name, str(Path(entry.path))) for entry in scanned)
    except OSError as fault:
        yield folder, _unreadable(folder, fault).what
        return
    inner = {name: path for name, path in entries if os.path.isdir(path)}  # noqa: PTH112 - False where it may not be asked
    yield from ((path, "") for name, path in entries if name not in inner and is_program(name))
    for name, path in inner.items() if depth else ():
        if os.path.islink(path):  # noqa: PTH114 - it may lead back
            yield path, "a link to a folder is not followed"
        elif depth == 1:
            yield path, f"this folder lies more than {_DEEPEST} levels down"
        elif not name.startswith((".", "__")) and not os.path.exists(os.path.join(path, ENVIRONMENT)):  # noqa: PTH110, PTH118
            below = _within(path, depth - 1)
            first = next(below, (path, "this is a folder") if is_program(name) else None)
            if first:
                yield first
                yield from below


def _read(name: str, folder: str) -> bytes:
    """A file's bytes; one that was found in a folder lies there, wherever links lead."""
    try:
        mode = Path(name).stat().st_mode
        if stat.S_ISFIFO(mode):
            source = _piped(name)
        elif not stat.S_ISREG(mode):
            raise UsageError("this is not an ordinary file", where=name, remedy=f"name a {NAME} file")
        elif folder:
            root = str(Path(folder).resolve())
            real = real_within(root, os.path.relpath(name, folder))
            source, _ = read_inside(root, real, LARGEST + 1)
        else:
            source = read_ordinary(Path(name), LARGEST + 1)
    except LedOutError as fault:
        raise UsageError(LED_OUT, where=name) from fault
    except OSError as fault:
        raise _unreadable(name, fault) from fault
    return within_limit(source, name)


def _piped(name: str) -> bytes:
    """What comes through a pipe of our own. Raises UsageError for another one: there may be no writer."""
    if not os.path.abspath(name).startswith(_OWN_PIPES):  # noqa: PTH100 - which leads nowhere a link does
        remedy = "write the program to an ordinary file, or hand it over as <(command)"
        raise UsageError("this is a named pipe, which may never be written to", where=name, remedy=remedy)
    try:
        return read_pipe(Path(name), LARGEST + 1, _SILENCE)
    except TimeoutError as fault:
        what = f"nothing came through this pipe for {_SILENCE:g} seconds"
        raise UsageError(what, where=name, remedy="write the program to a file, and name that") from fault


def _unreadable(name: str, fault: OSError) -> UsageError:
    if not isinstance(fault, FileNotFoundError):
        return UsageError(why_unreadable(fault), where=name, remedy="check its permissions")
    return UsageError("no such file", where=name, remedy=_meant(Path(name)))


def _meant(path: Path) -> str:
    """What to do about a missing file: the nearest name beside it, or where the search began."""
    if path.is_symlink():
        return DANGLING
    try:  # by their stems: every name is like any other's .py
        found = sorted(path.parent.iterdir(), key=lambda each: each.suffix == path.suffix)
    except OSError:
        return f"there is no folder {path.parent}"
    beside = {each.stem: each for each in found}
    if stem := nearest(path.stem, beside):
        return f"did you mean {beside[stem]}?"
    try:
        return f"paths start from {Path.cwd()}"
    except OSError:
        return "the current folder is gone"


class OutFile(Struct, frozen=True):
    """The file at `path` that `option` names; without a path it is not asked for, and nothing is written.

    What is there already is written over only if it is empty or `ours` says of its first bytes that it is
    such a file, which a person calls by the name `kind`. That protects a submission named by a slip.

    Raises UsageError for a place that cannot be written or holds something else.
    """

    path: Path | None
    option: str
    kind: str
    ours: Callable[[bytes], bool]

    def __post_init__(self) -> None:
        if self.path is None:
            return
        check_place(self.path, self.option)
        with writing(self.path, _another(self.option)):
            start = read_ordinary(self.path, _LOOKED_AT) if self.path.exists() else b""
        if start.strip() and not self.ours(start):
            what = f"it is there already, and it is not {self.kind}"
            raise UsageError(what, where=str(self.path), remedy=_another(self.option))

    def write(self, content: bytes) -> None:
        """Put `content` there at once. Raises UsageError."""
        if self.path is not None:
            with writing(self.path, _another(self.option)):
                replace_file(self.path, content)


def svg_target(path: Path | None) -> OutFile:
    """The file that `--svg` names. Raises UsageError."""
    return OutFile(path, "--svg", "an SVG", lambda start: b"<svg" in start)


def check_place(path: Path, option: str) -> None:
    """Make sure that `path`, which `option` names, is an ordinary file or nothing yet, and can be written.

    Raises:
        UsageError: it is not.
    """
    where = str(path)
    with writing(path, _another(option)):
        if not path.parent.is_dir():
            raise UsageError("its folder does not exist", where=where, remedy="make the folder first")
        with suppress(FileNotFoundError):
            mode = path.stat().st_mode
            if stat.S_ISDIR(mode):
                raise UsageError("it is a folder", where=where, remedy=f"name a file with {option}")
            if not stat.S_ISREG(mode):  # a pipe would be waited for
                raise UsageError("it is not an ordinary file", where=where, remedy=_another(option))
        if not os.access(path.resolve().parent, os.W_OK | os.X_OK):
            raise PermissionError(EACCES, os.strerror(EACCES))


@contextmanager
def writing(path: Path, remedy: str) -> Iterator[None]:
    """What fails in the block is a UsageError: the path cannot be written, and why."""
    try:
        yield
    except OSError as fault:
        raise unwritable(path, fault, remedy) from fault


def _another(option: str) -> str:
    return f"name another file with {option}"


def moment() -> datetime:
    """When a page is made: now, or what `$SOURCE_DATE_EPOCH` says. Raises UsageError."""
    given = os.environ.get(_EPOCH, "")
    try:
        return datetime.fromtimestamp(int(given), UTC) if given else datetime.now(UTC)
    except (ValueError, OverflowError, OSError):
        remedy = "set it to seconds since 1970, or unset it"
        raise UsageError(f"{given!r} is not a time", where=f"${_EPOCH}", remedy=remedy) from None
