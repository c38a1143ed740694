"""A file that an option of a command writes: refused before anything is judged, and written whole."""

from __future__ import annotations

import os
import stat
from collections.abc import Callable
from contextlib import suppress
from datetime import UTC, datetime
from errno import EACCES
from pathlib import Path

from msgspec import Struct

from judge.errors import UsageError, unwritable
from judge.files import read_ordinary, replace_file

_LOOKED_AT = 2000  # bytes of a file in which it says what it is
_EPOCH = "SOURCE_DATE_EPOCH"  # the usual way to ask for the same bytes every time


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
        try:
            start = read_ordinary(self.path, _LOOKED_AT) if self.path.exists() else b""
        except OSError as fault:
            raise unwritable(self.path, fault, _another(self.option)) from fault
        if start.strip() and not self.ours(start):
            what = f"it is there already and is no {self.kind}"
            raise UsageError(what, where=str(self.path), remedy=_another(self.option))

    def write(self, content: bytes) -> None:
        """Put `content` there at once. Raises UsageError."""
        if self.path is None:
            return
        try:
            replace_file(self.path, content)
        except OSError as fault:
            raise unwritable(self.path, fault, _another(self.option)) from fault


def svg_target(path: Path | None) -> OutFile:
    """The file that `--svg` names. Raises UsageError."""
    return OutFile(path, "--svg", "SVG", lambda start: b"<svg" in start)


def check_place(path: Path, option: str) -> None:
    """Make sure that `path`, which `option` names, is an ordinary file or nothing yet, and can be written.

    Raises:
        UsageError: it is not.
    """
    where = str(path)
    try:
        if not path.parent.is_dir():
            raise UsageError("its folder does not exist", where=where, remedy="make the folder first")
        with suppress(FileNotFoundError):
            mode = path.stat().st_mode
            if stat.S_ISDIR(mode):
                raise UsageError("it is a folder", where=where, remedy=f"name a file with {option}")
            if not stat.S_ISREG(mode):  # a pipe would be waited for
                raise UsageError("it is no ordinary file", where=where, remedy=_another(option))
        if not os.access(path.resolve().parent, os.W_OK | os.X_OK):
            raise PermissionError(EACCES, os.strerror(EACCES))
    except OSError as fault:
        raise unwritable(path, fault, _another(option)) from fault


def _another(option: str) -> str:
    return f"name another file with {option}"


def moment() -> datetime:
    """When a page is made: now, or what `$SOURCE_DATE_EPOCH` says. Raises UsageError."""
    given = os.environ.get(_EPOCH, "")
    try:
        return datetime.fromtimestamp(int(given), UTC) if given else datetime.now(UTC)
    except (ValueError, OverflowError, OSError):
        remedy = "set it to seconds since 1970, or unset it"
        raise UsageError(f"{given!r} is no time", where=f"${_EPOCH}", remedy=remedy) from None
