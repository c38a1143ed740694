"""A class's results in one SQLite file beside its folder, each committed as it comes.

    FOLDER.judge.sqlite3            the rows, those of older submissions too
    FOLDER.judge.sqlite3-lock       there while a judge writes: one at a time

Each commit is synced, which takes a disk's turn and is little beside judging: what was shown as done is there
after a power cut too. What a killed judge was in the middle of is judged by the next one.
"""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import sqlite3
from collections.abc import Iterable, Iterator
from pathlib import Path

import msgspec
from msgspec.structs import replace

from judge.batch.model import KeptRow
from judge.database import DatabaseKind, connect, faults, writing
from judge.errors import StoreError

_ROWS = """CREATE TABLE rows (
    key TEXT PRIMARY KEY,               -- the digest of the submission and its environment
    json TEXT NOT NULL                  -- judge.batch.model.KeptRow
)"""
RESULTS = DatabaseKind(
    "file of results",
    0x4A55434C,  # "JUCL"
    (("CREATE TABLE rows (key TEXT)",), ("DROP TABLE rows", _ROWS)),  # rows of before are judged again
    "move it away, or copy the folder to another place",
    synchronous="FULL",
)
_PART = replace(RESULTS, elsewhere="name the files that 'judge class --shard' wrote")


def store_of(folder: Path) -> Path:
    """Where a class's results are: beside its folder. Raises StoreError where nothing is beside it."""
    place = Path(os.path.abspath(folder))  # noqa: PTH100 - a link keeps its own
    if not place.name:
        raise StoreError("nothing can be beside this folder", where=str(place), remedy="name another folder")
    return place.with_name(f"{place.name}.judge.sqlite3")


class ResultStore:
    """The results in one file. Every method raises StoreError where the file fails."""

    def __init__(self, connection: sqlite3.Connection, path: Path) -> None:
        self.path = path
        self._connection = connection

    @classmethod
    @contextlib.contextmanager
    def open(cls, path: Path) -> Iterator[ResultStore]:
        """The file at `path` for writing, made if it is not there. After a fault, one that was begun here and
        holds nothing is taken away.

        Raises:
            StoreError: it cannot be opened, is no such file, or another judge is writing to it.
        """
        with _locked(path):
            new = not path.exists()
            with contextlib.closing(connect(RESULTS, path, reading=False)) as connection:
                store = cls(connection, path)
                try:
                    yield store
                except BaseException:
                    with contextlib.suppress(StoreError, OSError):
                        if new and not store.every():
                            connection.close()
                            path.unlink()
                    raise

    @classmethod
    @contextlib.contextmanager
    def read(cls, path: Path) -> Iterator[ResultStore]:
        """A part's file, only to be looked at. Raises StoreError, also where it is not there."""
        if not path.exists():
            what = "there is no such file of results"
            raise StoreError(what, where=str(path), remedy=_PART.elsewhere)
        with contextlib.closing(connect(_PART, path, reading=True)) as connection:
            yield cls(connection, path)

    def keep_all(self, rows: Iterable[KeptRow]) -> None:
        """Keep rows, all of them or none."""
        values = [(row.key, _json(row)) for row in rows]
        with writing(RESULTS, self._connection, self.path) as connection:
            connection.executemany("INSERT OR REPLACE INTO rows VALUES (?, ?)", values)

    def every(self) -> list[KeptRow]:
        """All rows, those of older files and standards too, the oldest first."""
        with faults(RESULTS, self.path):
            found = self._connection.execute("SELECT json FROM rows ORDER BY key").fetchall()
        try:
            rows = [msgspec.json.decode(text, type=KeptRow) for (text,) in found]
        except (msgspec.DecodeError, TypeError) as fault:
            raise RESULTS.damaged(self.path) from fault
        return sorted(rows, key=lambda row: row.at)


def _json(row: KeptRow) -> str:
    """The row as JSON; half of a surrogate pair, which a submission may answer, is a question mark."""
    return json.dumps(msgspec.to_builtins(row), ensure_ascii=False).encode("utf-8", "replace").decode()


@contextlib.contextmanager
def _locked(path: Path) -> Iterator[None]:
    """Hold the lock of a file of results. Raises StoreError where another judge has it."""
    place = path.with_name(path.name + "-lock")
    with faults(RESULTS, path):
        lock = os.open(place, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        held = os.path.samestat(os.fstat(lock), place.stat())
    except (BlockingIOError, FileNotFoundError):
        held = False
    try:
        if not held:  # somebody has it, or has had it until just now and taken it away
            remedy = "wait until it has ended, or end it"
            raise StoreError("another judge is writing to it", where=str(path), remedy=remedy)
        yield
    finally:
        if held:
            with contextlib.suppress(OSError):
                place.unlink()
        os.close(lock)
