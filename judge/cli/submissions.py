"""Reading the files to judge: all of them before the first is judged. Of several, one that fails is a row."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterable, Iterator
from itertools import islice
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from judge.errors import UsageError, nearest
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
    why_unreadable,
    within_limit,
)
from judge.languages import NAME, PATTERN, is_program

_MOST, _DEEPEST = 10_000, 20  # files in a folder, and levels of folders: a class is smaller
_SILENCE = 30.0  # seconds without a byte after which a pipe is given up
_OWN_PIPES = ("/dev/", "/proc/")  # <(command) and /dev/stdin: a shell has started what writes there


class Submission(Struct, frozen=True):
    """A file to judge: its name as the person gave it, and its bytes."""

    name: str
    source: bytes


class _Entry(Struct, frozen=True):
    """A file by its name; `folder` is the one that was named where it was found there."""

    name: str
    folder: str = ""


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
    submissions, unread = _gathered(names, 0, follow=False)
    if unread:
        raise UsageError(unread[0].why, where=unread[0].name)
    return submissions


def gathered(
    names: Iterable[str], problem: str = "", *, follow: bool = False
) -> tuple[list[Submission], list[Unjudged]]:
    """The named files, as `read_submissions`, and those of several that cannot be read; `problem` is for all.

    A folder stands for every *.py in it and in its folders, but for hidden ones and virtual environments.
    With `follow` links are followed that lead out of it.

    Raises:
        UsageError: one is missing, the only one cannot be read, or a folder holds no *.py.
    """
    submissions, unread = _gathered(names, _DEEPEST, follow=follow)
    return submissions, [replace(each, problem=problem) for each in unread]


def _gathered(names: Iterable[str], depth: int, *, follow: bool) -> tuple[list[Submission], list[Unjudged]]:
    entries = dict.fromkeys(entry for name in names for entry in _entries(name, depth))
    submissions, unread = [], []
    for entry in entries:
        if isinstance(entry, Unjudged):
            unread.append(entry)
            continue
        try:
            submissions.append(Submission(entry.name, _read(entry.name, "" if follow else entry.folder)))
        except UsageError as fault:
            if len(entries) == 1:
                raise
            unread.append(Unjudged(entry.name, DANGLING if is_dangling(entry.name) else fault.what))
    return submissions, unread


def _entries(name: str, depth: int) -> list[_Entry | Unjudged]:
    """The file of that name, or all that is to be judged in the folder, so many levels down.

    Raises:
        UsageError: there is nothing, or more than anybody would want.
    """
    if not name:  # which would be the current folder
        raise UsageError("no such file", where="''", remedy=f"name a {NAME} file")
    try:
        if not stat.S_ISDIR(Path(name).stat().st_mode):
            return [_Entry(name)]
        os.scandir(name).close()  # of a folder that cannot be read, that is said
    except OSError as fault:
        if is_dangling(name):
            return [_Entry(name)]
        raise _unreadable(name, fault) from fault
    except ValueError as fault:  # a NUL in the name
        raise UsageError("no such file", where=repr(name)) from fault
    found = list(islice(_within(name, depth), _MOST + 1))
    if len(found) > _MOST:
        what = f"this folder holds more than {_MOST:,} {PATTERN} files"
        raise UsageError(what, where=name, remedy="name a smaller one")
    if not found:
        raise UsageError(
            f"this folder holds no {PATTERN} file",
            where=name,
            remedy="name a file, or a folder of submissions",
        )
    return [each if isinstance(each, Unjudged) else _Entry(each, name) for each in found]


def _within(folder: str, depth: int) -> Iterator[str | Unjudged]:
    """The programs in a folder, in order, those of its own folders after its own, so many levels down."""
    try:
        with os.scandir(folder) as scanned:
            entries = sorted(scanned, key=lambda entry: entry.name)
    except OSError as fault:
        yield Unjudged(folder, _unreadable(folder, fault).what)
        return
    inner = {entry.name: str(Path(entry.path)) for entry in entries if os.path.isdir(entry.path)}  # noqa: PTH112 - False where it may not be asked
    yield from (
        str(Path(entry.path)) for entry in entries if entry.name not in inner and is_program(entry.name)
    )
    if depth:
        for name, path in inner.items():
            yield from _below(name, path, depth)


def _below(name: str, path: str, depth: int) -> Iterator[str | Unjudged]:
    """What is to be judged in a folder within another one."""
    if os.path.islink(path):  # noqa: PTH114 - it may lead back
        yield Unjudged(path, "a link to a folder is not followed")
    elif depth == 1:
        yield Unjudged(path, f"this folder lies more than {_DEEPEST} levels down")
    elif not name.startswith((".", "__")) and not os.path.exists(os.path.join(path, ENVIRONMENT)):  # noqa: PTH110, PTH118
        empty = True
        for each in _within(path, depth - 1):
            empty = False
            yield each
        if empty and is_program(name):
            yield Unjudged(path, "this is a folder")


def _read(name: str, folder: str = "") -> bytes:
    """A file's bytes; one that was found in a folder lies there, wherever links lead."""
    path = Path(name)
    try:
        if folder and path.is_file():
            root = str(Path(folder).resolve())
            real = real_within(root, os.path.relpath(name, folder))
            return within_limit(read_inside(root, real, LARGEST + 1)[0], name)
        mode = path.stat().st_mode
        if stat.S_ISFIFO(mode):
            return within_limit(_piped(name), name)
        if stat.S_ISREG(mode):
            return within_limit(read_ordinary(path, LARGEST + 1), name)
    except LedOutError as fault:
        raise UsageError(LED_OUT, where=name) from fault
    except OSError as fault:
        raise _unreadable(name, fault) from fault
    raise UsageError("this is no ordinary file", where=name, remedy=f"name a {NAME} file")


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
    try:
        beside = [entry.name for entry in path.parent.iterdir()]
    except OSError:
        return f"there is no folder {path.parent}"
    stem = nearest(path.stem, [Path(name).stem for name in beside])  # every name is like any other's .py
    alike = [name for name in beside if Path(name).stem == stem]
    if alike:
        return f"did you mean {path.with_name(nearest(path.name, alike) or alike[0])}?"
    try:
        return f"paths start from {Path.cwd()}"
    except OSError:
        return "the current folder is gone"
