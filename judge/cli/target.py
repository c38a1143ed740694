"""A file that an option of a command writes: refused before anything is judged, and written whole."""

from __future__ import annotations

import os
from collections.abc import Callable
from datetime import UTC, datetime
from errno import EACCES
from pathlib import Path

from msgspec import Struct

from judge.errors import UsageError, unwritable
from judge.files import read_ordinary, replace_file

_LOOKED_AT = 2000  # bytes of a file in which it says what it is
_EPOCH = "SOURCE_DATE_EPOCH"  # the usual way to ask for the same bytes every time


class OutFile(Struct, frozen=True):
    """The file at `path` that `option` names.

    What is there already is written over only if it is empty or `ours` says of its first bytes that it is
    such a file, which a person calls by the name `kind`. That protects a submission named by a slip.
    """

    path: Path
    option: str
    kind: str
    ours: Callable[[bytes], bool]

    def check(self, *, force: bool = False, remedy: str | None = None) -> None:
        """Refuse a place that cannot be written or, without `force`, holds something else.

        Raises:
            UsageError: that is so; `remedy` says what to do about something else that is there.
        """
        check_place(self.path, self.option)
        try:
            if force or not self.path.exists() or self._is_ours():
                return
        except OSError as fault:
            raise unwritable(self.path, fault, _another(self.option)) from fault
        what = f"it is there already and is no {self.kind}"
        raise UsageError(what, where=str(self.path), remedy=remedy or _another(self.option))

    def write(self, content: bytes) -> None:
        """Put `content` there at once. Raises UsageError."""
        try:
            replace_file(self.path, content)
        except OSError as fault:
            raise unwritable(self.path, fault, _another(self.option)) from fault

    def _is_ours(self) -> bool:
        start = read_ordinary(self.path, _LOOKED_AT)
        return not start.strip() or self.ours(start)


def svg_target(path: Path) -> OutFile:
    """The file that `--svg` names."""
    return OutFile(path, "--svg", "SVG", lambda start: b"<svg" in start)


def check_svg(path: Path, submissions: int) -> None:
    """Refuse, before anything is judged, to draw several submissions or over a file that is no SVG."""
    if submissions > 1:
        raise UsageError("--svg draws one submission", where=str(path), remedy="name one FILE")
    svg_target(path).check()


def check_place(path: Path, option: str) -> None:
    """Make sure that `path`, which `option` names, is an ordinary file or nothing yet, and can be written.

    Raises:
        UsageError: it is not.
    """
    where = str(path)
    try:
        if not path.parent.is_dir():
            raise UsageError("its folder does not exist", where=where, remedy="make the folder first")
        if _exists(path) and path.is_dir():
            raise UsageError("it is a folder", where=where, remedy=f"name a file with {option}")
        if _exists(path) and not path.is_file():  # a pipe would be waited for
            raise UsageError("it is no ordinary file", where=where, remedy=_another(option))
        if not os.access(path.resolve().parent, os.W_OK | os.X_OK):
            raise PermissionError(EACCES, os.strerror(EACCES))
    except OSError as fault:
        raise unwritable(path, fault, _another(option)) from fault


def _another(option: str) -> str:
    return f"name another file with {option}"


def _exists(path: Path) -> bool:
    """Whether something is there; a name that cannot be one, such as one too long, raises OSError."""
    try:
        path.stat()
    except FileNotFoundError:
        return False
    return True


def moment() -> datetime:
    """When a page is made: now, or what `$SOURCE_DATE_EPOCH` says. Raises UsageError."""
    given = os.environ.get(_EPOCH, "")
    try:
        return datetime.fromtimestamp(int(given), UTC) if given else datetime.now(UTC)
    except (ValueError, OverflowError, OSError):
        remedy = "set it to seconds since 1970, or unset it"
        raise UsageError(f"{given!r} is no time", where=f"${_EPOCH}", remedy=remedy) from None
