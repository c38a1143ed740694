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
from pathlib import Path
from urllib.parse import quote_from_bytes

from msgspec import Struct

from judge.errors import JudgeError
from judge.reading import read_ordinary

_PATIENCE = 5.0  # seconds to wait for another process that writes
_MAGIC = b"SQLite format 3\0"
_UNWRITABLE = ("SQLITE_READONLY", "SQLITE_CANTOPEN", "SQLITE_PERM", "SQLITE_AUTH")
_DAMAGE = (
    "SQLITE_ERROR",
    "SQLITE_SCHEMA",
    "SQLITE_CONSTRAINT",
    "SQLITE_MISMATCH",
)  # tables that are not ours
_MOVE_AWAY = "move it away, and a new one begins"
_REMEDIES = {  # SQLite's names of faults begin with these; {noun} and {elsewhere} are the kind's
    "SQLITE_FULL": ("the disk is full", "make room: the {noun} is as it was before"),
    "SQLITE_BUSY": ("another program is writing to it", "try again when that has ended"),
    "SQLITE_LOCKED": ("another program is writing to it", "try again when that has ended"),
    "SQLITE_NOTADB": ("this is no {noun} of the judge", "{elsewhere}"),
    "SQLITE_CORRUPT": ("the {noun} is damaged", _MOVE_AWAY),
    "SQLITE_IOERR": (
        "the {noun} cannot be written or read (disk full or failing?)",
        "make room: nothing in it is lost",
    ),
} | dict.fromkeys(_UNWRITABLE, ("the {noun} cannot be written", "make it writable, or {elsewhere}"))


class Kind(Struct, frozen=True):
    """A kind of file: what messages call it, how it is told from others, and how its tables come to be.

    A file at version n has had the first n of `steps`, each of some statements; the version is its
    `user_version`. A step is never changed once it was released: a file that had it would not get the change.
    `elsewhere` is what to do instead of using a file that cannot be used; `error` is what is raised.
    """

    noun: str
    application: int
    steps: tuple[tuple[str, ...], ...]
    elsewhere: str
    error: type[JudgeError]
    synchronous: str = "NORMAL"


def connect(kind: Kind, path: Path, *, reading: bool) -> sqlite3.Connection:
    """The file at `path`, with today's tables; made if it is not there, but never for reading only.

    Raises the kind's error: it is not ours, is newer than this judge, or cannot be opened.
    """
    with faults(kind, path):
        if reading and not path.exists():
            return _ready(kind, _opened("file::memory:?mode=memory"), path)
        if not reading:
            _make_folder(path)
            _make_file(path)
        _look_at(kind, path)
        try:
            return _ready(kind, _opened(_address(path, "rw" if reading else "rwc")), path)
        except sqlite3.OperationalError as fault:
            if not (reading and _name(fault).startswith(_UNWRITABLE)):
                raise
        if _log_of(path).exists():  # what it holds cannot be read without writing beside it
            raise kind.error(
                f"the folder cannot be written, and a judge has not closed the {kind.noun}",
                where=str(path),
                remedy="make the folder writable",
            )
        return _ready(kind, _opened(_address(path, "ro") + "&immutable=1"), path)


@contextlib.contextmanager
def faults(kind: Kind, path: Path) -> Iterator[None]:
    """SQLite's faults and the system's as the kind's error, which says what to do."""
    try:
        yield
    except sqlite3.Error as fault:
        what, remedy = _told(kind, fault)
        raise kind.error(what, where=str(path), remedy=remedy) from fault
    except UnicodeDecodeError as fault:  # of what SQLite says of a damaged table
        raise kind.error(f"the {kind.noun} is damaged", where=str(path), remedy=_MOVE_AWAY) from fault
    except (OSError, ValueError) as fault:  # ValueError: a NUL in the name
        reason = (getattr(fault, "strerror", None) or "no name for a file").lower()
        what = f"the {kind.noun} cannot be opened ({reason})"
        raise kind.error(what, where=str(path), remedy=kind.elsewhere) from fault


@contextlib.contextmanager
def writing(kind: Kind, connection: sqlite3.Connection, path: Path) -> Iterator[sqlite3.Connection]:
    """All that is written within is written, or nothing of it. Raises the kind's error."""
    with faults(kind, path):
        connection.execute("BEGIN IMMEDIATE")
        try:
            yield connection
            connection.execute("COMMIT")
        except BaseException:
            if connection.in_transaction:  # a full disk has ended it already
                connection.execute("ROLLBACK")
            raise


def _told(kind: Kind, fault: sqlite3.Error) -> tuple[str, str]:
    """What is wrong, and what to do about it."""
    name = _name(fault)
    known = next((said for start, said in _REMEDIES.items() if name.startswith(start)), None)
    if known is not None:
        what, remedy = (text.format(noun=kind.noun, elsewhere=kind.elsewhere) for text in known)
        return what, remedy
    # Text that is no UTF-8 has no name.
    if name.startswith(_DAMAGE) or (not name and isinstance(fault, sqlite3.OperationalError)):
        return f"the {kind.noun} is damaged ({fault})", _MOVE_AWAY
    return f"the {kind.noun} cannot be used ({fault})", kind.elsewhere


def is_damaged(fault: JudgeError) -> bool:
    """Whether SQLite found the file's own pages damaged, or another file in its place."""
    return _name(fault.__cause__).startswith(("SQLITE_CORRUPT", "SQLITE_NOTADB", "SQLITE_READONLY_DBMOVED"))


def _name(fault: BaseException | None) -> str:
    return getattr(fault, "sqlite_errorname", "")


def _make_folder(path: Path) -> None:
    with contextlib.suppress(FileExistsError):  # a file in its place shows when it is opened
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)


def _make_file(path: Path) -> None:
    """Begin it as the user's own, wherever it is: it holds their sources. SQLite's other files follow it."""
    with contextlib.suppress(OSError):  # it is there, or cannot be made: SQLite says that better
        os.close(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600))


def _look_at(kind: Kind, path: Path) -> None:
    """Refuse what is not ours before SQLite has touched it."""
    try:
        head = read_ordinary(path, 100)
    except FileNotFoundError:
        return
    if not head:
        return
    if not head.startswith(_MAGIC):
        raise kind.error(f"this is no {kind.noun} of the judge", where=str(path), remedy=kind.elsewhere)
    # What is not ours says nothing by its version; SQLite says whether it is a database at all.
    if int.from_bytes(head[68:72], "big") == kind.application:
        _check_version(kind, int.from_bytes(head[60:64], "big"), path)


def _check_version(kind: Kind, version: int, path: Path) -> None:
    if not 0 <= version < 1 << 31:  # it is a number of 32 bits with a sign
        raise kind.error(f"the {kind.noun} is damaged", where=str(path), remedy=_MOVE_AWAY)
    if version <= len(kind.steps):
        return
    raise kind.error(
        f"the {kind.noun} was written by a newer judge (version {version}, this one knows {len(kind.steps)})",
        where=str(path),
        remedy=f"upgrade the judge, or {kind.elsewhere}; the file is left as it is",
    )


def _address(path: Path, mode: str) -> str:
    return f"file:{quote_from_bytes(os.fsencode(path.absolute()))}?mode={mode}"


def _opened(address: str) -> sqlite3.Connection:
    return sqlite3.connect(address, uri=True, timeout=_PATIENCE, isolation_level=None)


def _log_of(path: Path) -> Path:
    return path.with_name(path.name + "-wal")


def _ready(kind: Kind, connection: sqlite3.Connection, path: Path) -> sqlite3.Connection:
    try:
        # In this order: whoever begins the file meanwhile writes both at once.
        if _holds_anything(connection) and _application(connection) != kind.application:
            raise kind.error("this is another program's database", where=str(path), remedy=kind.elsewhere)
        _check_version(kind, _version_of(connection), path)
        _migrate(kind, connection)
        _keep_a_log(connection)
        connection.execute(f"PRAGMA synchronous = {kind.synchronous}")  # closing it syncs
    except BaseException:
        connection.close()
        raise
    return connection


def _application(connection: sqlite3.Connection) -> int:
    (application,) = connection.execute("PRAGMA application_id").fetchone()
    return int(application)


def _holds_anything(connection: sqlite3.Connection) -> bool:
    return connection.execute("SELECT 1 FROM sqlite_schema LIMIT 1").fetchone() is not None


def _keep_a_log(connection: sqlite3.Connection) -> None:
    (mode,) = connection.execute("PRAGMA journal_mode").fetchone()
    if mode != "delete":
        return
    try:
        connection.execute("PRAGMA journal_mode = WAL")
    except sqlite3.OperationalError as fault:  # somebody reads it just now; the next to open it turns it on
        if not _name(fault).startswith(("SQLITE_BUSY", "SQLITE_READONLY")):
            raise


def _version_of(connection: sqlite3.Connection) -> int:
    """How many of the steps the file has had."""
    (version,) = connection.execute("PRAGMA user_version").fetchone()
    return int(version)


def _migrate(kind: Kind, connection: sqlite3.Connection) -> None:
    """Take the steps that the file has not had: all of them or none. Safe where two do it at once."""
    if _version_of(connection) >= len(kind.steps):
        return
    connection.execute("BEGIN IMMEDIATE")
    try:
        for step in kind.steps[_version_of(connection) :]:  # asked again: another process may have been first
            for statement in step:
                connection.execute(statement)
        connection.execute(f"PRAGMA application_id = {kind.application}")
        connection.execute(f"PRAGMA user_version = {len(kind.steps)}")
        connection.execute("COMMIT")
    except BaseException:
        if connection.in_transaction:
            connection.execute("ROLLBACK")
        raise
