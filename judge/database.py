"""Opening an SQLite file of the judge's own, and saying what is wrong with one in one line.

    FILE, FILE-wal, FILE-shm    the last two are SQLite's write-ahead log, there while somebody has it open

With the log, a reader never waits for a writer, a writer waits for another one, and a process that is killed
while it writes leaves the file as it was before. A file that is not ours is never written to.

A commit appends to the log with write(2): from then on the system has it, and killing the judge, by SIGKILL
too, loses nothing; the next to open the file reads the log. `synchronous = NORMAL` spares the fsync of every
commit: a power cut loses the last commits, never the file. `FULL` saves them too, for a disk's turn each.
"""

from __future__ import annotations

import contextlib
import os
import sqlite3
from collections.abc import Iterator
from itertools import chain
from pathlib import Path
from typing import Any
from urllib.parse import quote_from_bytes

from msgspec import Struct

from judge.errors import JudgeError, StoreError
from judge.files import read_ordinary

_PATIENCE = 5.0  # seconds to wait for another process that writes
_MAGIC = b"SQLite format 3\0"
_UNWRITABLE = ("SQLITE_READONLY", "SQLITE_CANTOPEN", "SQLITE_PERM", "SQLITE_AUTH")
# Of tables that are not ours.
_DAMAGE = ("SQLITE_ERROR", "SQLITE_SCHEMA", "SQLITE_CONSTRAINT", "SQLITE_MISMATCH")
_MOVE_AWAY = "move it away, and a new one begins"
_BUSY = ("another program is writing to it", "try again when that has ended")
_REMEDIES = {  # SQLite's names of faults begin with these; {noun} and {elsewhere} are the kind's
    "SQLITE_FULL": ("the disk is full", "make room: the {noun} is as it was before"),
    "SQLITE_BUSY": _BUSY,
    "SQLITE_LOCKED": _BUSY,
    "SQLITE_NOTADB": ("this is not a {noun} of the judge", "{elsewhere}"),
    "SQLITE_CORRUPT": ("the {noun} is damaged", _MOVE_AWAY),
    "SQLITE_IOERR": (
        "the {noun} cannot be written or read (disk full or failing?)",
        "make room: nothing in it is lost",
    ),
} | dict.fromkeys(_UNWRITABLE, ("the {noun} cannot be written", "make it writable, or {elsewhere}"))


class DatabaseKind(Struct, frozen=True):
    """A kind of file: what messages call it, how it is told from others, and how its tables come to be.

    A file at version n has had the first n of `steps`, each of some statements; the version is its
    `user_version`. A step is never changed once it was released: a file that had it would not get the change.
    `elsewhere` is what to do instead of using a file that cannot be used.
    """

    noun: str
    application: int
    steps: tuple[tuple[str, ...], ...]
    elsewhere: str
    synchronous: str = "NORMAL"

    def damaged(self, path: Path) -> StoreError:
        """The error that says so of a file."""
        return StoreError(f"the {self.noun} is damaged", where=str(path), remedy=_MOVE_AWAY)

    def check_version(self, version: int, path: Path) -> None:
        """Raises StoreError for a file that this judge does not know."""
        if not 0 <= version < 1 << 31:  # it is a number of 32 bits with a sign
            raise self.damaged(path)
        if version > (known := len(self.steps)):
            raise StoreError(
                f"the {self.noun} was written by a newer judge (version {version}, this one knows {known})",
                where=str(path),
                remedy=f"upgrade the judge, or {self.elsewhere}; the file is left as it is",
            )


def connect(kind: DatabaseKind, path: Path, *, reading: bool) -> sqlite3.Connection:
    """The file at `path`, with today's tables; made if it is not there, but never for reading only.

    Raises StoreError: it is not ours, is newer than this judge, or cannot be opened.
    """
    with faults(kind, path):
        if reading and not path.exists():
            return _ready(kind, "file::memory:?mode=memory", path)
        if not reading:
            with contextlib.suppress(FileExistsError):  # a file in its place shows when it is opened
                path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
            # The user's own, wherever it is: it holds their sources. SQLite's other files follow it.
            with contextlib.suppress(OSError):  # it is there, or cannot be made: SQLite says that better
                os.close(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600))
        _look_at(kind, path)
        address = f"file:{quote_from_bytes(os.fsencode(path.absolute()))}?mode="
        try:
            return _ready(kind, address + ("rw" if reading else "rwc"), path)
        except sqlite3.OperationalError as fault:
            if not (reading and _name(fault).startswith(_UNWRITABLE)):
                raise
        if path.with_name(path.name + "-wal").exists():  # it cannot be read without writing beside it
            raise StoreError(
                f"the folder cannot be written, and a judge has not closed the {kind.noun}",
                where=str(path),
                remedy="make the folder writable",
            )
        return _ready(kind, address + "ro&immutable=1", path)


@contextlib.contextmanager
def faults(kind: DatabaseKind, path: Path) -> Iterator[None]:
    """SQLite's faults and the system's as a StoreError, which says what to do."""
    try:
        yield
    except sqlite3.Error as fault:
        what, remedy = _told(kind, fault)
        raise StoreError(what, where=str(path), remedy=remedy) from fault
    except UnicodeDecodeError as fault:  # of what SQLite says of a damaged table
        raise kind.damaged(path) from fault
    except (OSError, ValueError) as fault:  # ValueError: a NUL in the name
        reason = (getattr(fault, "strerror", None) or "no name for a file").lower()
        what = f"the {kind.noun} cannot be opened ({reason})"
        raise StoreError(what, where=str(path), remedy=kind.elsewhere) from fault


@contextlib.contextmanager
def writing(kind: DatabaseKind, connection: sqlite3.Connection, path: Path) -> Iterator[sqlite3.Connection]:
    """All that is written within is written, or nothing of it. Raises StoreError."""
    with faults(kind, path), _transaction(connection):
        yield connection


@contextlib.contextmanager
def _transaction(connection: sqlite3.Connection) -> Iterator[None]:
    connection.execute("BEGIN IMMEDIATE")
    try:
        yield
        connection.execute("COMMIT")
    except BaseException:
        if connection.in_transaction:  # a full disk has ended it already
            connection.execute("ROLLBACK")
        raise


def _told(kind: DatabaseKind, fault: sqlite3.Error) -> tuple[str, str]:
    """What is wrong, and what to do about it."""
    name = _name(fault)
    for start, (what, remedy) in _REMEDIES.items():
        if name.startswith(start):
            words = {"noun": kind.noun, "elsewhere": kind.elsewhere}
            return what.format(**words), remedy.format(**words)
    # Text that is no UTF-8 has no name.
    if name.startswith(_DAMAGE) or (not name and isinstance(fault, sqlite3.OperationalError)):
        return f"the {kind.noun} is damaged ({fault})", _MOVE_AWAY
    return f"the {kind.noun} cannot be used ({fault})", kind.elsewhere


def is_damaged(fault: JudgeError) -> bool:
    """Whether SQLite found the file's own pages damaged, or another file in its place."""
    return _name(fault.__cause__).startswith(("SQLITE_CORRUPT", "SQLITE_NOTADB", "SQLITE_READONLY_DBMOVED"))


def _name(fault: BaseException | None) -> str:
    return getattr(fault, "sqlite_errorname", "")


def _look_at(kind: DatabaseKind, path: Path) -> None:
    """Refuse what is not ours before SQLite has touched it."""
    try:
        head = read_ordinary(path, 100)
    except FileNotFoundError:
        return
    if head and not head.startswith(_MAGIC):
        raise StoreError(f"this is not a {kind.noun} of the judge", where=str(path), remedy=kind.elsewhere)
    # What is not ours says nothing by its version; SQLite says whether it is a database at all.
    if int.from_bytes(head[68:72], "big") == kind.application:
        kind.check_version(int.from_bytes(head[60:64], "big"), path)


def _ready(kind: DatabaseKind, address: str, path: Path) -> sqlite3.Connection:
    connection = sqlite3.connect(address, uri=True, timeout=_PATIENCE, isolation_level=None)
    try:
        # In this order: whoever begins the file meanwhile writes both at once.
        used = connection.execute("SELECT 1 FROM sqlite_schema LIMIT 1").fetchone() is not None
        if used and _pragma(connection, "application_id") != kind.application:
            raise StoreError("this is another program's database", where=str(path), remedy=kind.elsewhere)
        kind.check_version(_pragma(connection, "user_version"), path)
        _migrate(kind, connection)
        _keep_a_log(connection)
        connection.execute(f"PRAGMA synchronous = {kind.synchronous}")  # closing it syncs
    except BaseException:
        connection.close()
        raise
    return connection


def _pragma(connection: sqlite3.Connection, name: str) -> Any:
    return connection.execute(f"PRAGMA {name}").fetchone()[0]


def _keep_a_log(connection: sqlite3.Connection) -> None:
    if _pragma(connection, "journal_mode") != "delete":
        return
    try:
        connection.execute("PRAGMA journal_mode = WAL")
    except sqlite3.OperationalError as fault:  # somebody reads it just now; the next to open it turns it on
        if not _name(fault).startswith(("SQLITE_BUSY", "SQLITE_READONLY")):
            raise


def _migrate(kind: DatabaseKind, connection: sqlite3.Connection) -> None:
    """Take the steps that the file has not had: all of them or none. Safe where two do it at once."""
    if _pragma(connection, "user_version") >= len(kind.steps):
        return
    with _transaction(connection):
        had = _pragma(connection, "user_version")  # asked again: another process may have been first
        for statement in chain.from_iterable(kind.steps[had:]):
            connection.execute(statement)
        connection.execute(f"PRAGMA application_id = {kind.application}")
        connection.execute(f"PRAGMA user_version = {len(kind.steps)}")
