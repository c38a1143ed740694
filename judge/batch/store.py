"""A class's results in one SQLite file beside its folder, each committed as it comes.

    FOLDER.judge.sqlite3            the rows, those of older hand-ins too
    FOLDER.judge.sqlite3-lock       there while a judge writes: one at a time

Each commit is synced, which takes a disk's turn and is little beside judging: what was shown as done is there
after a power cut too. What a killed judge was in the middle of is judged by the next one.
"""

from __future__ import annotations

import contextlib
import fcntl
import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from judge.batch.model import Row
from judge.database import Kind, connect, faults, writing
from judge.errors import StoreError

if TYPE_CHECKING:
    import sqlite3

_COLUMNS = Row.__struct_fields__
_ROWS = (
    """CREATE TABLE rows (
        key TEXT PRIMARY KEY,               -- the digest of the hand-in and its standard
        student TEXT NOT NULL,
        problem TEXT NOT NULL,
        file TEXT NOT NULL,                 -- within the class's folder
        digest TEXT NOT NULL,               -- of the source
        verdict TEXT NOT NULL,
        score INTEGER NOT NULL,
        points INTEGER NOT NULL,
        mistake TEXT NOT NULL,
        machine TEXT NOT NULL,
        isolation TEXT NOT NULL,
        at REAL NOT NULL,                   -- seconds since 1970: when it was judged, or came back to this
        copied TEXT NOT NULL,               -- the file of equal bytes that was judged in its place
        json TEXT NOT NULL,                 -- judge.batch.model.Done
        standard TEXT NOT NULL              -- judge.batch.model.Standard
    )""",
    "CREATE INDEX rows_of_a_student ON rows (student, problem, at)",
    "CREATE TABLE meta (name TEXT PRIMARY KEY, value TEXT NOT NULL)",  # never written
)
STORE = Kind(
    "file of results",
    0x4A55434C,  # "JUCL"
    (_ROWS,),
    "move it away, or copy the folder to another place",
    synchronous="FULL",
)


def store_of(folder: Path) -> Path:
    """Where a class's results are: beside its folder. Raises StoreError where nothing is beside it."""
    place = Path(os.path.abspath(folder))  # noqa: PTH100 - a link keeps its own
    if not place.name:
        raise StoreError("nothing can be beside this folder", where=str(place), remedy="name another folder")
    return place.with_name(f"{place.name}.judge.sqlite3")


class Store:
    """The results in one file; a context manager. Every method raises StoreError where the file fails."""

    def __init__(
        self, connection: sqlite3.Connection, path: Path, lock: int | None, *, new: bool = False
    ) -> None:
        self.path = path
        self._connection = connection
        self._lock = lock
        self._new = new

    @classmethod
    def open(cls, path: Path, *, reading: bool = False) -> Store:
        """The file at `path`, made if it is not there; with `reading` it is only looked at, and must be.

        Raises:
            StoreError: it cannot be opened, is no such file, or another judge is writing to it.
        """
        if reading and not path.exists():
            raise StoreError("there is no such file of results", where=str(path))
        lock = None if reading else _locked(path)
        new = not reading and not path.exists()
        try:
            return cls(connect(STORE, path, reading=reading), path, lock, new=new)
        except BaseException:
            _unlock(path, lock)
            raise

    def __enter__(self) -> Store:
        return self

    def __exit__(self, *exc: object) -> None:
        """Close it; after a fault, one that was begun here and holds nothing is taken away."""
        with contextlib.suppress(StoreError, OSError):
            empty = self._new and any(exc) and not self.every()
            self._connection.close()
            if empty:
                self.path.unlink(missing_ok=True)
        self._connection.close()
        _unlock(self.path, self._lock)

    def keep_all(self, rows: Iterable[Row]) -> None:
        """Keep rows, all of them or none."""
        values = [tuple(getattr(row, name) for name in _COLUMNS) for row in rows]
        marks = ", ".join("?" * len(_COLUMNS))
        with writing(STORE, self._connection, self.path) as connection:
            connection.executemany(
                f"INSERT OR REPLACE INTO rows ({', '.join(_COLUMNS)}) VALUES ({marks})", values
            )

    def every(self) -> list[Row]:
        """All rows, those of older files and standards too, the oldest first."""
        query = f"SELECT {', '.join(_COLUMNS)} FROM rows ORDER BY at, key"
        with faults(STORE, self.path):
            found = self._connection.execute(query).fetchall()
        return [_row(each, self.path) for each in found]


def _row(values: tuple[Any, ...], path: Path) -> Row:
    row = Row(*values)
    texts = [getattr(row, name) for name in _COLUMNS if name not in ("score", "points", "at")]
    if not all(isinstance(text, str) for text in texts):
        remedy = "move the file away, and a new one begins"
        raise StoreError("a row is damaged", where=str(path), remedy=remedy)
    return row


def _lock_of(path: Path) -> Path:
    return path.with_name(path.name + "-lock")


def _locked(path: Path) -> int:
    """The descriptor that holds the lock. Raises StoreError where another judge has it."""
    place = _lock_of(path)
    while True:
        with _opening(path):
            path.parent.mkdir(parents=True, exist_ok=True)
            lock = os.open(place, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            if os.path.samestat(os.fstat(lock), place.stat()):
                return lock
        except BlockingIOError:
            os.close(lock)
            remedy = "wait until it has ended, or end it"
            raise StoreError("another judge is writing to it", where=str(path), remedy=remedy) from None
        except FileNotFoundError:  # whoever had it has taken it away meanwhile
            pass
        os.close(lock)


@contextlib.contextmanager
def _opening(path: Path) -> Iterator[None]:
    try:
        yield
    except (OSError, ValueError) as fault:
        reason = (getattr(fault, "strerror", None) or "no name for a file").lower()
        what = f"the {STORE.noun} cannot be written ({reason})"
        raise StoreError(what, where=str(path), remedy=STORE.elsewhere) from fault


def _unlock(path: Path, lock: int | None) -> None:
    if lock is not None:
        with contextlib.suppress(OSError):
            _lock_of(path).unlink()
        os.close(lock)
