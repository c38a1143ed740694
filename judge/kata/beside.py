"""What is to be kept in a history that another program has locked: a file each, beside it.

    history.sqlite3.waiting/<nanoseconds>-<8 hex digits>.row

Each is written whole or not at all. Who opens the history next takes them in, each once however many judges
do so and wherever one is killed: a row that is there already is not added again.
"""

from __future__ import annotations

import contextlib
import os
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import msgspec
from msgspec import Struct

from judge.atomic import new_file
from judge.errors import HistoryError
from judge.kata.rows import COLUMNS, DAMAGE, read
from judge.reading import read_ordinary

if TYPE_CHECKING:
    import sqlite3

_FOLDER, _SUFFIX = ".waiting", ".row"
_TABLES = ("runs", "help", "hacks", "answers")
_MOST, _LONGEST = 2**63 - 1, 1 << 26  # a number in the history; bytes of a file
_PATIENCE_MS = 200  # for a lock: it can wait for the next time


class _Waiting(Struct):
    """One row without its number, and the source that a run judged."""

    table: str
    row: tuple[Any, ...]
    source: tuple[str, bytes] | None = None


def keep(
    history: Path, table: str, row: Sequence[Any], source: Sequence[Any] | None, fault: HistoryError
) -> None:
    """Keep a row beside the history. Raises `fault`, which denied it the history, where that fails too."""
    folder = _folder(history)
    name = f"{time.time_ns():020}-{os.urandom(4).hex()}{_SUFFIX}"
    waiting = _Waiting(table, tuple(row), (source[0], source[1]) if source else None)
    try:
        folder.mkdir(mode=0o700, exist_ok=True)
        new_file(folder / name, msgspec.msgpack.encode(waiting))
    except OSError:
        raise fault from None


def inserted(
    connection: sqlite3.Connection, table: str, row: Sequence[Any], source: Sequence[Any] | None
) -> int:
    """Add a row within a transaction; its number."""
    if source:
        connection.execute("INSERT OR IGNORE INTO sources VALUES (?, ?)", source)
    columns = ", ".join(COLUMNS[table][1:])
    values = ", ".join("?" * len(row))
    number = connection.execute(f"INSERT INTO {table} ({columns}) VALUES ({values})", row).lastrowid
    assert number is not None
    return number


def take_in(history: Path, connection: sqlite3.Connection) -> None:
    """Add what waits beside the history, as far as it can be read, and unless the history is locked."""
    from judge.database import faults, writing
    from judge.kata.database import HISTORY

    waiting = list(_waiting(history))
    if not waiting:
        return
    with contextlib.suppress(HistoryError), faults(HISTORY, history):
        (patience,) = connection.execute("PRAGMA busy_timeout").fetchone()
        (synchronous,) = connection.execute("PRAGMA synchronous").fetchone()
        try:
            connection.execute(f"PRAGMA busy_timeout = {_PATIENCE_MS}")
            connection.execute("PRAGMA synchronous = FULL")  # the files go once it is on the disk
            with writing(HISTORY, connection, history):
                for _, each in waiting:
                    if not _is_there(connection, each):
                        inserted(connection, each.table, each.row, each.source)
        finally:
            connection.execute(f"PRAGMA busy_timeout = {patience}")
            connection.execute(f"PRAGMA synchronous = {synchronous}")
        for path, _ in waiting:
            path.unlink(missing_ok=True)
        with contextlib.suppress(OSError):  # another one has come
            _folder(history).rmdir()


def _waiting(history: Path) -> Iterator[tuple[Path, _Waiting]]:
    """The rows that wait, in order of time, each with its file; what is none is passed over."""
    try:
        names = sorted(entry.name for entry in os.scandir(_folder(history)) if entry.name.endswith(_SUFFIX))
    except OSError:
        return
    if not history.exists():  # a history in memory would swallow them
        return
    for name in names:
        path = _folder(history) / name
        with contextlib.suppress(OSError, msgspec.MsgspecError, *DAMAGE):
            found = msgspec.msgpack.decode(read_ordinary(path, _LONGEST), type=_Waiting)
            if found.table in _TABLES and not any(
                isinstance(each, int) and each > _MOST for each in found.row
            ):
                read(found.table, (0, *found.row))  # which fails where no judge wrote it
                yield path, found


def _is_there(connection: sqlite3.Connection, waiting: _Waiting) -> bool:
    same = " AND ".join(f"{column} IS ?" for column in COLUMNS[waiting.table][1:])
    query = f"SELECT 1 FROM {waiting.table} WHERE {same} LIMIT 1"
    return connection.execute(query, waiting.row).fetchone() is not None


def _folder(history: Path) -> Path:
    return history.with_name(history.name + _FOLDER)
