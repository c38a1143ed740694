"""What can go wrong that a person is told about.

    JudgeError            anything the judge says in one line instead of a traceback (exit 3)
    ├── UsageError        the caller's: an unknown problem, a missing file (exit 2)
    ├── ProblemError      a problem folder's own fault: a misspelt key, a wrong example
    ├── ShortageError     this machine has too little of something just now: processes, memory
    └── StoreError        the file of past runs, or of a class's results, cannot be read or written

A submission's faults are not errors: they are verdicts.
"""

from __future__ import annotations

import errno
import os
from collections.abc import Iterable, Sequence
from enum import IntEnum
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path


class ExitCode(IntEnum):
    """What the `judge` command tells the shell."""

    ACCEPTED = 0
    NOT_ACCEPTED = 1
    USAGE = 2
    FAULT = 3
    INTERRUPTED = 130


class JudgeError(Exception):
    """One clear line: what is wrong, where, and what to do about it.

    `where` names the place as a person would look it up: `problem.toml:12`, `count/statement.md`, a path.
    """

    exit_code = ExitCode.FAULT

    def __init__(self, what: str, *, where: str | None = None, remedy: str | None = None) -> None:
        super().__init__(what)
        self.what, self.where, self.remedy = what, where, remedy

    def __str__(self) -> str:
        place = f"{self.where}: " if self.where else ""
        advice = f"; {self.remedy}" if self.remedy else ""
        return f"{place}{self.what}{advice}"


class UsageError(JudgeError):
    """What the caller asked for cannot be done as it was asked."""

    exit_code = ExitCode.USAGE


class UnknownKataError(UsageError):
    """No kata is called `name`."""

    def __init__(self, name: str, remedy: str) -> None:
        super().__init__(f"no kata is called {name!r}", remedy=remedy)
        self.name = name


class ProblemError(JudgeError):
    """A problem's folder contradicts itself or the format."""


class ShortageError(JudgeError):
    """The machine, or a limit set for the judge, has no room for what one submission needs."""


class StoreError(JudgeError):
    """A file of results fails: a full disk, a newer judge's file, no database, another judge that writes."""


NO_THREAD = "can't start new thread"  # all that Python says of it
LIMIT_ON_TASKS = "raise the limit on processes (ulimit -u, a container's pids limit)"
_FEWER = "use a smaller -j"
_SHORTAGES = {
    errno.EAGAIN: ("no further process or thread can be started", f"{_FEWER}, or {LIMIT_ON_TASKS}"),
    errno.ENOMEM: (
        "there is no memory left",
        f"{_FEWER}, end other programs, or raise the limit (ulimit -v, a container's memory)",
    ),
    errno.EMFILE: ("the judge has no file descriptor left", f"{_FEWER}, or raise the limit (ulimit -n)"),
    errno.ENFILE: ("the system has no file descriptor left", f"{_FEWER}, or end other programs"),
    errno.EFBIG: ("a file may not become as large as it must", "raise the limit (ulimit -f unlimited)"),
    errno.ENOSPC: ("there is no space left for a file", "free some"),
    errno.EDQUOT: ("your quota leaves no space for a file", "free some"),
}


def printable(text: str) -> str:
    r"""`text` with everything a terminal would obey, or hide, written out, such as `\x1b`.

    A submission's name, message or answer must not steer the terminal it is shown on: no escape sequences,
    no other control characters, no marks that reorder text.
    """
    if text.isprintable():
        return text
    return "".join(
        character if character.isprintable() else character.encode("unicode_escape").decode("ascii")
        for character in text
    )


def told(fault: Exception) -> str:
    """What to tell a person about a fault that costs less than the whole run: a line, whatever it was."""
    line = fault if isinstance(fault, JudgeError) else shortage(fault)
    return str(line or f"internal fault: {fault!r}")


def shortage(fault: BaseException) -> ShortageError | None:
    """What `fault` says that there is too little of, and what to do about it; None where it says no such."""
    if isinstance(fault, ShortageError):
        return fault
    code = shortage_code(fault)
    return shortage_of(code) if code else None


def shortage_code(fault: BaseException) -> int:
    """The errno of the shortage behind a fault; 0 where it is another's."""
    if isinstance(fault, MemoryError):
        return errno.ENOMEM
    if isinstance(fault, RuntimeError) and NO_THREAD in str(fault):
        return errno.EAGAIN
    code = fault.errno if isinstance(fault, OSError) else None
    return code if code in _SHORTAGES else 0


def shortage_of(code: int, what: str = "") -> ShortageError:
    """The shortage behind an errno; `what` says what could not be done, where that is known."""
    reason, remedy = _SHORTAGES.get(code, (os.strerror(code).lower(), "try again"))
    return ShortageError(f"{what}: {reason}" if what else reason, remedy=remedy)


def unwritable(path: Path, fault: OSError | ValueError, remedy: str | None = None) -> UsageError:
    """The error that says that `path` cannot be written, and why; a ValueError is for a NUL in its name."""
    reason = (getattr(fault, "strerror", None) or "it failed").lower()
    return UsageError(f"cannot be written ({reason})", where=str(path), remedy=remedy)


def nearest(name: str, names: Iterable[str]) -> str | None:
    """The one of `names` that `name` was most likely meant to be, or None."""
    import difflib  # late: only who mistyped something waits for it

    def likeness(other: str) -> tuple[float, int]:  # of two that are as like, that with more in its place
        ratio = difflib.SequenceMatcher(None, other, name).ratio()
        return ratio, sum(map(str.__eq__, name, other))

    return max(difflib.get_close_matches(name, list(names)), key=likeness, default=None)


def one_slip(typed: str, name: str) -> bool:
    """Whether it is the name with a letter more, a letter less, another letter, or two of them exchanged."""
    at = next(
        (at for at, pair in enumerate(zip(typed, name, strict=False)) if pair[0] != pair[1]), len(typed)
    )
    rest, right = typed[at:], name[at:]
    return min(len(typed), len(name)) > 3 and (
        rest[1:] == right or rest == right[1:] or rest[1:] == right[1:] or rest == right[1::-1] + right[2:]
    )


def meant(name: str, names: Sequence[str], introduction: str = "there are") -> str:
    """What to do about a name that is none of `names`."""
    near = nearest(name, names)
    return f"did you mean {near!r}?" if near else f"{introduction} {', '.join(names) or 'none'}"
