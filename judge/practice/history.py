"""The history: one SQLite file of what a person did, which several judges may write at once.

    <data folder>/history.sqlite3               the folder is the user's own; the file may be $JUDGE_DB
    <data folder>/history.sqlite3.damaged-1     one that could not be read: a new one took its place

    with History() as history:
        history.keep(run_of(result, source, path), source)
        history.runs("count")                        # oldest first
        history.left_out                             # the rows that are damaged

A damaged row is left out of what is read, and costs nothing else. A file that another program locks is waited
for, for some seconds. Importing this module imports SQLite, and raises StoreError where Python has none.
"""

from __future__ import annotations

import contextlib
import os
import zlib
from collections.abc import Callable, Iterable
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from judge.errors import StoreError, UsageError
from judge.files import LARGEST, read_ordinary, user_data
from judge.practice import events
from judge.practice.events import DAMAGE, TABLES, Event, Help, Kind, Run, Started
from judge.problem import Verdict
from judge.problem.model import is_solution

try:
    import sqlite3

    from judge import database
except ImportError as fault:  # an interpreter that was built without it
    what = f"this Python cannot keep a history: {fault}"
    raise StoreError(what, remedy="install its sqlite3 module") from fault
if TYPE_CHECKING:
    from judge.run.result import Result

VARIABLE = "JUDGE_DB"
APPLICATION = 0x4A554447  # "JUDG": tells this file from any other program's database
_STEPS = Path(__file__).with_name("history.sql").read_text(encoding="utf-8").split("-- step\n")[1:]
STEPS = tuple(tuple(filter(str.strip, step.split(";"))) for step in _STEPS)
_PLACES = """
    SELECT max(id) AS id, max(time) AS time, problem, path, max(problems) AS problems FROM (
        SELECT id, time, problem, path, problems FROM started UNION ALL
        SELECT id, time, problem, path, x'' FROM runs WHERE path <> x'' AND verdict <> 'JE')
    GROUP BY problem, path ORDER BY max(time) DESC, max(id) DESC"""
_KIND = database.DatabaseKind("history", APPLICATION, STEPS, f"name another file with --db or ${VARIABLE}")
_BESIDE = ("-wal", "-shm", "-journal", "")  # what SQLite keeps with a file, and the file itself
_HEAD, _APPLICATION = 100, 68  # bytes of SQLite's header; where it names the application
_MOST = 2**63 - 1  # what SQLite can be asked for
_Found = TypeVar("_Found")


def history_path() -> Path:
    """Where the history is: $JUDGE_DB, or a file in the user's own data folder. Raises StoreError."""
    if own := os.environ.get(VARIABLE):
        return Path(own)
    try:
        return user_data() / "history.sqlite3"
    except RuntimeError:
        what = "there is no home folder for the history"
        raise StoreError(what, remedy=f"set ${VARIABLE} to a file") from None


class History:
    """The history in one file; a context manager. Every method raises StoreError where the file fails."""

    def __init__(self, path: Path | None = None, *, reading: bool = False) -> None:
        """Open the history at `path`; by default $JUDGE_DB or the file in the user's data folder.

        With `reading`, nothing is made where there is none yet, and a folder that cannot be written will do.

        Raises:
            StoreError: it cannot be opened, is newer than this judge, or is not a history.
        """
        self.path = path or history_path()
        self.left_out: set[tuple[str, object]] = set()  # the rows that are damaged: table and number
        self.set_aside: Path | None = None  # where the file is now that could not be read
        self._reading = reading
        try:
            self._connect()
        except StoreError as fault:
            self._set_aside(fault)

    def __enter__(self) -> History:
        return self

    def __exit__(self, *exc: object) -> None:
        self._connection.close()

    def keep(self, event: Event, source: bytes = b"") -> int:
        """Keep an event, and the source that a run judged, in one transaction; its number, from 1."""
        row = events.to_row(event)
        names, marks = ", ".join(row), ", ".join("?" * len(row))

        def kept(connection: sqlite3.Connection) -> int:
            if isinstance(event, Run):
                body = zlib.compress(source)
                connection.execute("INSERT OR IGNORE INTO sources VALUES (?, ?)", (event.source_hash, body))
            query = f"INSERT INTO {TABLES[type(event)]} ({names}) VALUES ({marks})"
            return connection.execute(query, list(row.values())).lastrowid or 0

        return self._do(kept, writing=True)

    def events(self, kind: type[Kind], problem: str | None = None, limit: int | None = None) -> list[Kind]:
        """The last `limit` events of a kind (all without one), with one problem or all; oldest first."""
        where, values = ("", []) if problem is None else ("WHERE problem = ?", [problem])
        query = f"SELECT * FROM {TABLES[kind]} {where} ORDER BY id DESC LIMIT ?"
        most = -1 if limit is None else min(limit, _MOST)
        return self._sound(kind, reversed(self._rows(query, *values, most)))

    def runs(self, problem: str | None = None, limit: int | None = None) -> list[Run]:
        """The last `limit` runs (all of them without one), of one problem or of all; oldest first."""
        return self.events(Run, problem, limit)

    def with_results(self, runs: Iterable[Run]) -> list[Run]:
        """Those of the runs whose results can be read; the others are left out."""
        found = []
        for run in runs:
            try:
                run.result  # noqa: B018 - which reads it
                found.append(run)
            except StoreError:
                self.left_out.add(("runs", run.id))
        return found

    def run(self, number: int) -> Run:
        """The run of that number. Raises UsageError if there is none."""
        rows = self._rows("SELECT * FROM runs WHERE id = ?", number) if 0 < number <= _MOST else []
        if not rows:
            last, known = self.runs(limit=1), "'judge run' adds the first one"
            known = f"the last one is {last[0].id}; see 'judge history'" if last else known
            raise UsageError(f"there is no run {number}", remedy=known)
        try:
            return events.from_row(Run, dict(rows[0]))
        except DAMAGE as fault:  # no judge wrote this
            raise StoreError(f"run {number} is damaged", where=str(self.path)) from fault

    def source(self, number: int) -> bytes:
        """The submission that run judged. Raises UsageError if there is no such run."""
        digest = self.run(number).source_hash
        try:
            ((body,),) = self._rows("SELECT body FROM sources WHERE hash = ?", digest)
            return events.unpacked(body, LARGEST)
        except DAMAGE as fault:  # it is not there, or no judge wrote it
            raise StoreError(f"the source of run {number} is damaged", where=str(self.path)) from fault

    def hints_seen(self, problem: str) -> int:
        """How many hints of a problem have been seen."""
        return max((each.hints for each in self.events(Help, problem)), default=0)

    def places(self) -> list[Started]:
        """Every file that was started or judged, the last one first, each once; model solutions are not."""
        found = self._sound(Started, self._rows(_PLACES))
        return [place for place in found if not is_solution(place.path, place.problem)]

    def _sound(self, kind: type[Kind], rows: Iterable[sqlite3.Row]) -> list[Kind]:
        """The events of those rows that are not damaged."""
        found = []
        for row in rows:
            try:
                found.append(events.from_row(kind, dict(row)))
            except DAMAGE:
                self.left_out.add((TABLES[kind], row["id"]))
        return found

    def _rows(self, query: str, *values: object) -> list[sqlite3.Row]:
        return self._do(lambda connection: connection.execute(query, values).fetchall())

    def _do(self, work: Callable[[sqlite3.Connection], _Found], *, writing: bool = False) -> _Found:
        """What `work` returns; on a new file, if the old one is found to be damaged."""
        try:
            return self._done(work, writing=writing)
        except StoreError as fault:
            self._set_aside(fault)
        return self._done(work, writing=writing)

    def _done(self, work: Callable[[sqlite3.Connection], _Found], *, writing: bool) -> _Found:
        held = _KIND, self._connection, self.path
        with database.writing(*held) if writing else database.faults(_KIND, self.path):
            return work(self._connection)

    def _connect(self) -> None:
        self._file = _identity(self.path)
        self._connection = database.connect(_KIND, self.path, reading=self._reading)
        self._connection.row_factory, self._connection.text_factory = sqlite3.Row, _text_of

    def _set_aside(self, fault: StoreError) -> None:
        """Rename the file, unless another judge has put a new one in its place meanwhile; open what is there.

        Raises `fault` where that does not say that our file is damaged.
        """
        if not database.is_damaged(fault) or not _is_ours(self.path):
            raise fault
        if connection := getattr(self, "_connection", None):
            connection.close()
        if _identity(self.path) == self._file:
            names = (self.path.with_name(f"{self.path.name}.damaged-{number}") for number in count(1))
            target = next(each for each in names if not os.path.lexists(each))
            try:
                for suffix in _BESIDE:
                    with contextlib.suppress(FileNotFoundError):
                        path = self.path.with_name(self.path.name + suffix)
                        path.rename(target.with_name(target.name + suffix))
            except OSError:
                raise fault from None
            self.set_aside = target
        self._connect()


def run_of(result: Result, source: bytes, path: str) -> Run:
    """The run that judged that source to that result; `path` is that of `Run`."""
    import json  # neither is for who reads

    try:
        from _sha2 import sha256  # type: ignore[import-not-found]  # hashlib loads OpenSSL
    except ImportError:  # Python 3.11
        from _sha256 import sha256  # type: ignore[import-not-found]

    published = json.dumps(result.as_json(), separators=(",", ":")).encode()
    return Run(
        problem=result.problem,
        submission=result.submission,
        path=path,
        verdict=result.verdict,
        score=result.score,
        mode=result.mode,
        mistake=result.pitfall.name if result.pitfall and result.pitfall.names else None,
        ratio=result.time.ratio.median if result.time.ratio else None,
        passed=tuple(group.name for group in result.groups if group.verdict is Verdict.AC),
        failed=tuple(group.name for group in result.groups if group.verdict is not Verdict.AC),
        source_hash=sha256(source).hexdigest(),
        packed=zlib.compress(published),
    )


def _identity(path: Path) -> tuple[int, int] | None:
    """What tells the file at `path` from another one that takes its place; None where there is none."""
    try:
        found = path.stat()
    except (OSError, ValueError):
        return None
    return found.st_dev, found.st_ino


def _is_ours(path: Path) -> bool:
    """Whether the file there says that it is a history."""
    try:
        return read_ordinary(path, _HEAD)[_APPLICATION : _APPLICATION + 4] == APPLICATION.to_bytes(4, "big")
    except OSError:
        return False


def _text_of(content: bytes) -> str | bytes:
    """A text of the file; what is none stays bytes, so that it costs its own row alone."""
    try:
        return content.decode()
    except UnicodeDecodeError:
        return content
