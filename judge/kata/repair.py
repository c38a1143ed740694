"""A history without what is damaged in it: all that can be read goes into a new file, which takes its place.

    history.sqlite3                the new one
    history.sqlite3.damaged-1      the file as it was

Nobody else may have the history open meanwhile: what they wrote would go into the old file.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import sqlite3
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

from msgspec import Struct

from judge.database import connect, faults
from judge.errors import HistoryError
from judge.kata.database import HISTORY
from judge.kata.rows import COLUMNS, DAMAGE, NOUNS, Run, one_by_one, read, text_of

_NEW, _OLD = ".repaired", ".damaged-{}"
_LONGEST = 1 << 32  # bytes of a history


class Repaired(Struct, frozen=True):
    """What came of it: how many runs are kept, what is left out in words, and where the file as it was is.

    `before` is None where nothing was damaged: then nothing was changed.
    """

    runs: int
    left_out: tuple[str, ...] = ()
    before: Path | None = None


def repair(path: Path) -> Repaired:
    """Leave out of the history what cannot be read.

    Raises HistoryError: another judge has it open, it is no history, or it cannot be read or written at all.
    """
    if not path.exists():
        raise HistoryError("there is no history yet", where=str(path), remedy="'judge run' begins one")
    with faults(HISTORY, path):
        length = _fill_up(path)
    with contextlib.closing(connect(HISTORY, path, reading=False)) as old, faults(HISTORY, path):
        old.text_factory = text_of
        _take_alone(old, path)
        new = path.with_name(path.name + _NEW)
        _remove(new)
        try:
            with contextlib.closing(connect(HISTORY, new, reading=False)) as target:
                target.execute("PRAGMA synchronous = FULL")
                runs, left_out = _copied(old, target)
                target.execute("PRAGMA journal_mode = DELETE")  # so that it is one file
            if not left_out and _is_whole(old):
                return Repaired(runs)
            before = _kept_as_it_was(path, length)
            new.replace(path)
            return Repaired(runs, tuple(left_out), before)
        finally:
            _remove(new)


def _fill_up(path: Path) -> int:
    """Give a file whose end was cut off its length again: SQLite reads nothing of it otherwise.

    The length that it had, which is what there is of it.
    """
    with path.open("r+b") as file:
        head, length = file.read(100), file.seek(0, os.SEEK_END)
        size = int.from_bytes(head[16:18], "big")
        whole = int.from_bytes(head[28:32], "big") * (1 << 16 if size == 1 else size)
        ours = int.from_bytes(head[68:72], "big") == HISTORY.application
        logged = path.with_name(f"{path.name}-wal").exists()  # it may be what brings the rest
        if ours and not logged and length < whole <= _LONGEST:
            file.truncate(whole)
    return length


def _is_whole(connection: sqlite3.Connection) -> bool:
    """Whether SQLite finds nothing wrong, such as an index that no row was read by."""
    try:
        return bool(connection.execute("PRAGMA integrity_check(1)").fetchone() == ("ok",))
    except sqlite3.DatabaseError:
        return False


def _take_alone(connection: sqlite3.Connection, path: Path) -> None:
    """Keep everybody else out until this connection closes."""
    try:
        connection.execute("PRAGMA journal_mode = DELETE")  # refused while anybody else has it open
        connection.execute("PRAGMA locking_mode = EXCLUSIVE")
        connection.execute("BEGIN EXCLUSIVE")
    except sqlite3.OperationalError as fault:
        if not getattr(fault, "sqlite_errorname", "").startswith(("SQLITE_BUSY", "SQLITE_LOCKED")):
            raise
        remedy = "try again when it has ended"
        raise HistoryError("another program has the history open", where=str(path), remedy=remedy) from fault


def _copied(old: sqlite3.Connection, new: sqlite3.Connection) -> tuple[int, list[str]]:
    """Copy the rows that can be read; how many runs these are, and the others in words."""
    left_out: list[str] = []
    runs = 0
    new.execute("BEGIN IMMEDIATE")
    digests: dict[str, None] = {}
    for table, columns in sorted(COLUMNS.items(), key=lambda each: each[0] != "runs"):  # which name sources
        names = ", ".join(columns)
        values = ", ".join("?" * len(columns))
        for row in _rows(old, table, names, digests, left_out):
            try:
                found = read(table, row)
                if isinstance(found, Run):
                    found.levels  # noqa: B018 - which reads its result
                    runs += 1
                    digests[found.source_hash] = None
                new.execute(f"INSERT INTO {table} ({names}) VALUES ({values})", row)
            except (*DAMAGE, HistoryError):
                left_out.append(_named(table, row[0]))
    new.execute("COMMIT")
    return runs, left_out


def _rows(
    connection: sqlite3.Connection, table: str, names: str, digests: Iterable[str], left_out: list[str]
) -> Iterator[Sequence[Any]]:
    """The rows of a table, in order; one by one where a part of the file cannot be read.

    `digests` are those of the sources that runs have judged.
    """
    key = COLUMNS[table][0]
    try:
        yield from connection.execute(f"SELECT {names} FROM {table} ORDER BY {key}").fetchall()
    except sqlite3.DatabaseError:
        if table != "sources":
            yield from one_by_one(connection, table, left_out.append)
            return
        for digest in digests:
            try:
                query = f"SELECT {names} FROM sources WHERE hash = ?"
                yield from connection.execute(query, (digest,)).fetchall()
            except sqlite3.DatabaseError:
                left_out.append(_named(table, digest))


def _named(table: str, number: object) -> str:
    return NOUNS[table] if table == "current" else f"{NOUNS[table]} {str(number)[:16]}"


def _kept_as_it_was(path: Path, length: int) -> Path:
    """A copy of the file, which was so long, under another name."""
    number = 1
    while True:
        before = path.with_name(path.name + _OLD.format(number))
        try:
            descriptor = os.open(before, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o600)
            with os.fdopen(descriptor, "wb") as target, path.open("rb") as source:
                shutil.copyfileobj(source, target)
                target.truncate(length)
                os.fsync(descriptor)
        except FileExistsError:
            number += 1
        else:
            return before


def _remove(path: Path) -> None:
    for name in (path.name, f"{path.name}-wal", f"{path.name}-shm", f"{path.name}-journal"):
        path.with_name(name).unlink(missing_ok=True)
