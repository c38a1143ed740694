"""The files to judge, and those that options write.

All are read before the first is judged; of several, one that cannot be read is a row. A file to write is
refused before anything is judged, and written whole.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from errno import EACCES
from pathlib import Path
from typing import Any

from msgspec import Struct

from judge.errors import UsageError, nearest, unwritable
from judge.files import (
    LARGEST,
    files_below,
    read_below,
    read_ordinary,
    read_pipe,
    replace_file,
    why_unreadable,
    within_limit,
)
from judge.languages import PATTERN, is_program
from judge.problem import Problem

_SILENCE = 30.0  # seconds without a byte after which a pipe is given up
_LOOKED_AT = 2000  # bytes of a file in which it says what it is
_TO_FAIL = 1.0  # seconds that a browser has to say that there is none
_OWN_PIPES = ("/dev/", "/proc/")  # <(command) and /dev/stdin: a shell has started what writes there


class SubmissionFile(Struct, frozen=True):
    """A file to judge: its name as the person gave it, and its bytes."""

    name: str
    source: bytes


class Unjudged(Struct, frozen=True):
    """An entry that is not judged: its name, why, and the problem where it is known."""

    name: str
    why: str
    problem: str = ""


def read_submission(name: str, folder: str = "") -> SubmissionFile:
    """The file of that name; one that was found in a `folder` lies there, wherever links lead.

    Raises UsageError: it is missing, is no ordinary file or too large.
    """
    path = Path(name)
    try:
        if folder:
            source, *_ = read_below(Path(folder).resolve(), os.path.relpath(name, folder))
        elif not path.is_fifo():
            source = within_limit(read_ordinary(path, LARGEST + 1))
        elif os.path.abspath(name).startswith(_OWN_PIPES):  # noqa: PTH100 - which leads nowhere a link does
            source = within_limit(read_pipe(path, LARGEST + 1, _SILENCE))
        else:
            remedy = "write the program to an ordinary file, or hand it over as <(command)"
            raise UsageError("this is a named pipe, which may never be written to", where=name, remedy=remedy)
    except (OSError, ValueError) as fault:
        raise _unreadable(name, fault) from fault
    return SubmissionFile(name, source)


def gathered(names: Iterable[str], problem: str = "") -> tuple[list[SubmissionFile], list[Unjudged]]:
    """The named files, and those of several that cannot be read; `problem` is for all. A folder stands for
    every *.py in it and in its folders. A file named twice is judged once.

    Raises:
        UsageError: one is missing, the only one cannot be read, or a folder holds no *.py.
    """
    entries: dict[str, tuple[str, str]] = {}
    for name in names:
        entries |= _entries(name)
    submissions, unread = [], []
    for name, (folder, why) in entries.items():
        try:
            if why:
                raise UsageError(why, where=name)
            submissions.append(read_submission(name, folder))
        except UsageError as fault:
            if len(entries) == 1:
                raise
            unread.append(Unjudged(name, fault.what, problem))
    return submissions, unread


def _entries(name: str) -> dict[str, tuple[str, str]]:
    """The file of that name, or all that is to be judged in the folder: by their names the folder that each
    was found in, "" if it was named, and why it cannot be read, if so. Raises UsageError.
    """
    try:
        os.lstat(name)
    except (OSError, ValueError) as fault:
        raise _unreadable(name, fault) from fault
    folder = Path(name)
    if not folder.is_dir():
        return {name: ("", "")}
    below = [(path, why) for path, why in files_below(folder) if why or is_program(path)]
    if not below:
        what, remedy = f"this folder holds no {PATTERN} file", "name a file, or a folder of submissions"
        raise UsageError(what, where=name, remedy=remedy)
    return {str(folder / path): (name, why) for path, why in below}


def _unreadable(name: str, fault: OSError | ValueError) -> UsageError:
    path = Path(name)
    if isinstance(fault, ValueError):  # a NUL in the name
        return UsageError("no such file", where=repr(name))
    if isinstance(fault, FileNotFoundError) and not path.is_symlink():
        return UsageError("no such file", where=name or "''", remedy=_meant(path))
    remedy = "check its permissions" if isinstance(fault, PermissionError) else None
    return UsageError(why_unreadable(fault), where=name, remedy=remedy)


def _meant(path: Path) -> str:
    """What to do about a missing file: the nearest name beside it, or where the search began."""
    try:  # by their stems: every name is like any other's .py
        found = sorted(path.parent.iterdir(), key=lambda each: each.suffix == path.suffix)
        beside = {each.stem: each for each in found}
        stem = nearest(path.stem, beside)
        return f"did you mean {beside[stem]}?" if stem else f"paths start from {Path.cwd()}"
    except OSError:
        return f"there is no folder {path.parent}"


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

    def write(self, content: bytes, same: Callable[[bytes, bytes], bool] = bytes.__eq__) -> None:
        """Put `content` there at once, unless it is the `same` as what is there. Raises UsageError."""
        if self.path is not None:
            with writing(self.path, _another(self.option)):
                if not self.path.exists() or not same(self.path.read_bytes(), content):
                    replace_file(self.path, content)


def check_place(path: Path, option: str) -> None:
    """Make sure that `path`, which `option` names, is an ordinary file or nothing yet, and can be written.

    Raises UsageError where it is not.
    """
    with writing(path, _another(option)):
        if not path.parent.is_dir():
            raise UsageError("its folder does not exist", where=str(path), remedy="make the folder first")
        with suppress(FileNotFoundError):
            read_ordinary(path, 0)
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
    return "move it away" if option == "--open" else f"name another file with {option}"


def explore_page(problem: Problem, values: dict[str, Any] | None) -> str:
    """The page on which a case of the kata, its own if there is none, can be dragged. Raises UsageError."""
    from judge.problem.module import load_module  # only for who wants to look

    explore = load_module(problem).hooks.explore
    page = explore(problem, values) if explore else None
    if page is None:
        raise UsageError(f"There is no page for {problem.id} yet")
    return page


def opened_in_browser(place: str) -> bool:
    """Open an address or a file in the person's browser; False where there is none.

    What the browser says goes nowhere, and it outlives the judge.
    """
    import subprocess  # only for who wants to look

    command, silent = ("open" if sys.platform == "darwin" else "xdg-open"), subprocess.DEVNULL
    try:
        begun = subprocess.Popen(
            [command, place], stdin=silent, stdout=silent, stderr=silent, start_new_session=True
        )
        return begun.wait(_TO_FAIL) == 0
    except OSError:
        return False
    except subprocess.TimeoutExpired:  # it is the browser itself
        return True
