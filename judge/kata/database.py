"""Opening the history's SQLite file, and saying what is wrong with it in one line.

    <data folder>/history.sqlite3       the runs; the folder is the user's own, the file may be $JUDGE_DB
    …-wal, …-shm                        SQLite's write-ahead log, there while somebody has it open

With the log, a reader never waits for a writer, a writer waits for another one, and a process that is killed
while it writes leaves the file as it was before. A file that is not ours is never written to.

A commit appends to the log with write(2): from then on the system has it, and killing the judge, by SIGKILL
too, loses nothing; the next to open the file reads the log. `synchronous = NORMAL` spares the fsync of every
commit. It would save the last runs from a power cut as well, and cost a disk's turn for each submission; a
power cut without it loses those runs, never the file.
"""

from __future__ import annotations

import contextlib
import os
import sqlite3
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import quote_from_bytes

from judge.errors import HistoryError
from judge.folders import user_data
from judge.kata.migrations import APPLICATION, MIGRATIONS, migrate, version_of
from judge.reading import read_ordinary

VARIABLE = "JUDGE_DB"

_PATIENCE = 5.0  # seconds to wait for another process that writes
_MAGIC = b"SQLite format 3\0"
_ELSEWHERE = f"name another file with --db or ${VARIABLE}"
_MOVE_AWAY = "move it away, and a new one begins"
_MOST_STEPS = 1000  # no judge will ever have taken so many: such a version is damage
_UNWRITABLE = ("SQLITE_READONLY", "SQLITE_CANTOPEN", "SQLITE_PERM", "SQLITE_AUTH")
_DAMAGE = (
    "SQLITE_ERROR",
    "SQLITE_SCHEMA",
    "SQLITE_CONSTRAINT",
    "SQLITE_MISMATCH",
)  # tables that are not ours
_REMEDIES = {  # SQLite's names of faults begin with these
    "SQLITE_FULL": ("the disk is full", "make room: the history is as it was before"),
    "SQLITE_BUSY": ("another program is writing to it", "try again when that has ended"),
    "SQLITE_LOCKED": ("another program is writing to it", "try again when that has ended"),
    "SQLITE_NOTADB": ("this is no history of the judge", _ELSEWHERE),
    "SQLITE_CORRUPT": ("the history is damaged", _MOVE_AWAY),
    "SQLITE_IOERR": (
        "the history cannot be written or read (disk full or failing?)",
        "make room: nothing in it is lost",
    ),
} | dict.fromkeys(_UNWRITABLE, ("the history cannot be written", f"make it writable, or {_ELSEWHERE}"))


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


def connect(path: Path, *, reading: bool) -> sqlite3.Connection:
    """The history at `path`, with today's tables; made if it is not there, but never for reading only.

    Raises HistoryError: it is not ours, is newer than this judge, or cannot be opened.
    """
    with faults(path):
        if reading and not path.exists():
            return _ready(_opened("file::memory:?mode=memory"), path)
        if not reading:
            _make_folder(path)
            _make_file(path)
        _look_at(path)
        try:
            return _ready(_opened(_address(path, "rw" if reading else "rwc")), path)
        except sqlite3.OperationalError as fault:
            if not (reading and _name(fault).startswith(_UNWRITABLE)):
                raise
        if _log_of(path).exists():  # what it holds cannot be read without writing beside it
            raise HistoryError(
                "the folder cannot be written, and a judge has not closed the history",
                where=str(path),
                remedy="make the folder writable",
            )
        return _ready(_opened(_address(path, "ro") + "&immutable=1"), path)


@contextlib.contextmanager
def faults(path: Path) -> Iterator[None]:
    """SQLite's faults and the system's as a HistoryError that says what to do."""
    try:
        yield
    except sqlite3.Error as fault:
        what, remedy = _told(fault)
        raise HistoryError(what, where=str(path), remedy=remedy) from fault
    except UnicodeDecodeError as fault:  # of what SQLite says of a damaged table
        raise HistoryError("the history is damaged", where=str(path), remedy=_MOVE_AWAY) from fault
    except (OSError, ValueError) as fault:  # ValueError: a NUL in the name
        reason = (getattr(fault, "strerror", None) or "no name for a file").lower()
        what = f"the history cannot be opened ({reason})"
        raise HistoryError(what, where=str(path), remedy=_ELSEWHERE) from fault


@contextlib.contextmanager
def writing(connection: sqlite3.Connection, path: Path) -> Iterator[sqlite3.Connection]:
    """All that is written within is written, or nothing of it. Raises HistoryError."""
    with faults(path):
        connection.execute("BEGIN IMMEDIATE")
        try:
            yield connection
            connection.execute("COMMIT")
        except BaseException:
            if connection.in_transaction:  # a full disk has ended it already
                connection.execute("ROLLBACK")
            raise


def _told(fault: sqlite3.Error) -> tuple[str, str]:
    """What is wrong, and what to do about it."""
    name = _name(fault)
    known = next((said for start, said in _REMEDIES.items() if name.startswith(start)), None)
    if known is not None:
        return known
    # Text that is no UTF-8 has no name.
    if name.startswith(_DAMAGE) or (not name and isinstance(fault, sqlite3.OperationalError)):
        return f"the history is damaged ({fault})", _MOVE_AWAY
    return f"the history cannot be used ({fault})", _ELSEWHERE


def _name(fault: sqlite3.Error) -> str:
    return getattr(fault, "sqlite_errorname", "")


def _make_folder(path: Path) -> None:
    with contextlib.suppress(FileExistsError):  # a file in its place shows when the history is opened
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)


def _make_file(path: Path) -> None:
    """Begin it as the user's own, wherever it is: it holds their sources. SQLite's other files follow it."""
    with contextlib.suppress(OSError):  # it is there, or cannot be made: SQLite says that better
        os.close(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600))


def _look_at(path: Path) -> None:
    """Refuse what is not ours before SQLite has touched it."""
    try:
        head = read_ordinary(path, 100)
    except FileNotFoundError:
        return
    if not head:
        return
    if not head.startswith(_MAGIC):
        raise HistoryError("this is no history of the judge", where=str(path), remedy=_ELSEWHERE)
    # What is not ours says nothing by its version; SQLite says whether it is a database at all.
    if int.from_bytes(head[68:72], "big") == APPLICATION:
        _check_version(int.from_bytes(head[60:64], "big"), path)


def _check_version(version: int, path: Path) -> None:
    if not 0 <= version <= _MOST_STEPS:
        raise HistoryError("the history is damaged", where=str(path), remedy=_MOVE_AWAY)
    if version <= len(MIGRATIONS):
        return
    raise HistoryError(
        f"the history was written by a newer judge (version {version}, this one knows {len(MIGRATIONS)})",
        where=str(path),
        remedy=f"upgrade the judge, or {_ELSEWHERE}; the file is left as it is",
    )


def _address(path: Path, mode: str) -> str:
    return f"file:{quote_from_bytes(os.fsencode(path.absolute()))}?mode={mode}"


def _opened(address: str) -> sqlite3.Connection:
    return sqlite3.connect(address, uri=True, timeout=_PATIENCE, isolation_level=None)


def _log_of(path: Path) -> Path:
    return path.with_name(path.name + "-wal")


def _ready(connection: sqlite3.Connection, path: Path) -> sqlite3.Connection:
    try:
        (application,) = connection.execute("PRAGMA application_id").fetchone()
        if application != APPLICATION and _holds_anything(connection):
            raise HistoryError("this is another program's database", where=str(path), remedy=_ELSEWHERE)
        _check_version(version_of(connection), path)
        migrate(connection)
        _keep_a_log(connection)
        connection.execute("PRAGMA synchronous = NORMAL")  # closing it syncs
    except BaseException:
        connection.close()
        raise
    return connection


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
