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
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from msgspec import Struct

from judge.database import connect, faults
from judge.errors import HistoryError
from judge.kata.database import HISTORY
from judge.kata.rows import COLUMNS, DAMAGE, NOUNS, Run, read, text_of

_NEW, _OLD = ".repaired", ".damaged-{}"
_NO_REPAIR = "move it away, and a new one begins"


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
            if not left_out:
                return Repaired(runs)
            before = _kept_as_it_was(path)
            new.replace(path)
            return Repaired(runs, tuple(left_out), before)
        finally:
            _remove(new)


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
    for table, columns in COLUMNS.items():
        names = ", ".join(columns)
        values = ", ".join("?" * len(columns))
        for row in _rows(old, table, names, left_out):
            try:
                found = read(table, row)
                if isinstance(found, Run):
                    found.levels  # noqa: B018 - which reads its result
                    runs += 1
                new.execute(f"INSERT INTO {table} ({names}) VALUES ({values})", row)
            except (*DAMAGE, HistoryError):
                left_out.append(_named(table, row[0]))
    new.execute("COMMIT")
    return runs, left_out


def _rows(
    connection: sqlite3.Connection, table: str, names: str, left_out: list[str]
) -> Iterator[Sequence[Any]]:
    """The rows of a table, in order; one by one where a part of the file cannot be read."""
    key = COLUMNS[table][0]
    try:
        yield from connection.execute(f"SELECT {names} FROM {table} ORDER BY {key}").fetchall()
        return
    except sqlite3.DatabaseError:
        if key != "id":
            left_out.append(f"every {NOUNS[table]}")
            return
    try:
        found = connection.execute("SELECT seq FROM sqlite_sequence WHERE name = ?", (table,)).fetchone()
        last = found[0] if found and isinstance(found[0], int) else 0
    except sqlite3.DatabaseError:
        last = 0
    for number in range(1, last + 1):
        try:
            yield from connection.execute(f"SELECT {names} FROM {table} WHERE id = ?", (number,)).fetchall()
        except sqlite3.DatabaseError:
            left_out.append(_named(table, number))


def _named(table: str, number: object) -> str:
    return NOUNS[table] if table == "current" else f"{NOUNS[table]} {str(number)[:16]}"


def _kept_as_it_was(path: Path) -> Path:
    """A copy of the file under another name."""
    number = 1
    while True:
        before = path.with_name(path.name + _OLD.format(number))
        try:
            descriptor = os.open(before, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o600)
            with os.fdopen(descriptor, "wb") as target, path.open("rb") as source:
                shutil.copyfileobj(source, target)
                os.fsync(descriptor)
        except FileExistsError:
            number += 1
        else:
            return before


def _remove(path: Path) -> None:
    for name in (path.name, f"{path.name}-wal", f"{path.name}-shm", f"{path.name}-journal"):
        path.with_name(name).unlink(missing_ok=True)
