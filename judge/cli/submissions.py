"""Reading the files to judge: all of them before the first is judged."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterable
from pathlib import Path

from msgspec import Struct

from judge.errors import UsageError, nearest
from judge.language import NAME, PATTERN, is_program
from judge.reading import read_ordinary, read_pipe

_LARGEST = 4 * 2**20  # bytes; no person writes more
_SILENCE = 30.0  # seconds without a byte after which a pipe is given up
_OWN_PIPES = ("/dev/", "/proc/")  # <(command) and /dev/stdin: a shell has started what writes there


class Submission(Struct, frozen=True):
    """A file to judge: its name as the person gave it, and its bytes."""

    name: str
    source: bytes


def read_submissions(names: Iterable[str]) -> list[Submission]:
    """The named files; a folder stands for its *.py, in order. A file named twice is judged once.

    Raises:
        UsageError: one is missing, unreadable, no ordinary file or too large, or a folder holds no *.py.
    """
    files = dict.fromkeys(file for name in names for file in _files(name))
    return [Submission(file, _read(file)) for file in files]


def _files(name: str) -> list[str]:
    if not name:  # which would be the current folder
        raise UsageError("no such file", where="''", remedy=f"name a {NAME} file")
    try:
        is_folder = stat.S_ISDIR(Path(name).stat().st_mode)
        if not is_folder:
            return [name]
        # Not glob, to which a folder that may not be read is an empty one.
        found = sorted(path for path in Path(name).iterdir() if is_program(path) and path.is_file())
    except OSError as fault:
        raise _unreadable(name, fault) from fault
    except ValueError as fault:  # a NUL in the name
        raise UsageError("no such file", where=repr(name)) from fault
    if not found:
        raise UsageError(
            f"this folder holds no {PATTERN} file",
            where=name,
            remedy="name a file, or a folder of submissions",
        )
    return [str(path) for path in found]


def _read(name: str) -> bytes:
    path = Path(name)
    try:
        mode = path.stat().st_mode
        if stat.S_ISFIFO(mode):
            source = _piped(name)
        elif stat.S_ISREG(mode):
            source = read_ordinary(path, _LARGEST + 1)
        else:
            raise UsageError("this is no ordinary file", where=name, remedy=f"name a {NAME} file")
    except OSError as fault:
        raise _unreadable(name, fault) from fault
    if len(source) > _LARGEST:
        raise UsageError(f"this file is larger than {_LARGEST // 2**20} MB", where=name)
    return source


def _piped(name: str) -> bytes:
    """What comes through a pipe of our own. Raises UsageError for another one: there may be no writer."""
    if not os.path.abspath(name).startswith(_OWN_PIPES):  # noqa: PTH100 - which leads nowhere a link does
        remedy = "write the program to an ordinary file, or hand it over as <(command)"
        raise UsageError("this is a named pipe, which may never be written to", where=name, remedy=remedy)
    try:
        return read_pipe(Path(name), _LARGEST + 1, _SILENCE)
    except TimeoutError as fault:
        what = f"nothing came through this pipe for {_SILENCE:g} seconds"
        raise UsageError(what, where=name, remedy="write the program to a file, and name that") from fault


def _unreadable(name: str, fault: OSError) -> UsageError:
    if not isinstance(fault, FileNotFoundError):
        reason = (fault.strerror or "cannot be read").lower()
        return UsageError(f"cannot be read ({reason})", where=name, remedy="check its permissions")
    return UsageError("no such file", where=name, remedy=_meant(Path(name)))


def _meant(path: Path) -> str:
    """What to do about a missing file: the nearest name beside it, or where the search began."""
    if path.is_symlink():
        return "it is a link to a file that is not there"
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
