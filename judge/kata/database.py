"""The history's SQLite file: where it is, and what kind of file it is (`judge.database` opens it).

<data folder>/history.sqlite3               the runs; the folder is the user's own, the file may be $JUDGE_DB
<data folder>/history.sqlite3.damaged-1     one that could not be read: a new one took its place
"""

from __future__ import annotations

import contextlib
import os
from itertools import count
from pathlib import Path

from judge.database import Kind
from judge.errors import HistoryError
from judge.folders import user_data
from judge.kata.migrations import APPLICATION, MIGRATIONS
from judge.reading import read_ordinary

VARIABLE = "JUDGE_DB"
HISTORY = Kind(
    "history",
    APPLICATION,
    MIGRATIONS,
    f"name another file with --db or ${VARIABLE}",
    HistoryError,
)
_BESIDE = ("-wal", "-shm", "-journal", "")  # what SQLite keeps with a file, and the file itself
_HEAD, _APPLICATION = 100, 68  # bytes of SQLite's header; where it names the application
Identity = tuple[int, int]


def history_path() -> Path:
    """Where the history is: $JUDGE_DB, or a file in the user's own data folder. Raises HistoryError."""
    own = os.environ.get(VARIABLE)
    if own:
        return Path(own)
    try:
        return user_data() / "history.sqlite3"
    except RuntimeError:
        remedy = f"set ${VARIABLE} to a file"
        raise HistoryError("there is no home folder for the history", remedy=remedy) from None


def identity(path: Path) -> Identity | None:
    """What tells the file at `path` from another one that takes its place; None where there is none."""
    try:
        found = path.stat()
    except (OSError, ValueError):
        return None
    return found.st_dev, found.st_ino


def is_ours(path: Path) -> bool:
    """Whether the file there says that it is a history."""
    try:
        return read_ordinary(path, _HEAD)[_APPLICATION : _APPLICATION + 4] == APPLICATION.to_bytes(4, "big")
    except OSError:
        return False


def set_aside(path: Path, damaged: Identity | None) -> Path | None:
    """Rename that damaged history, which nobody may have open here; its new name.

    None where another judge has put a new file in its place meanwhile. Raises OSError.
    """
    if identity(path) != damaged:
        return None
    names = (path.with_name(f"{path.name}.damaged-{number}") for number in count(1))
    target = next(each for each in names if not os.path.lexists(each))
    for suffix in _BESIDE:
        with contextlib.suppress(FileNotFoundError):
            path.with_name(path.name + suffix).rename(target.with_name(target.name + suffix))
    return target
