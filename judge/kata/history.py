"""Every run and its source, the kata in hand, the help that was taken, and the answers to cards.

    with History.open() as history:
        history.add(result, source, path)
        history.runs("count")                        # oldest first
        history.left_out                             # the rows that are damaged

A row that is damaged is left out of what is read, and costs nothing else. A file that cannot be read is set
aside, and a new one is begun. Where another program locks the file for long, what is to be kept is kept
beside it (`judge.kata.beside`), and goes in when it is next opened.

Importing this module imports no SQLite; opening a history does.
"""

from __future__ import annotations

import hashlib
import json
import os
import zlib
from collections.abc import Callable, Iterable, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from judge.errors import HistoryError, UsageError
from judge.kata.answers import Answered, Rating
from judge.kata.hacks import Hack, Outcome
from judge.kata.rows import COLUMNS, DAMAGE, microseconds, read, text_of
from judge.kata.rows import Current as Current
from judge.kata.rows import Help as Help
from judge.kata.rows import Run as Run
from judge.problem import Verdict
from judge.run.result import Result

if TYPE_CHECKING:
    import sqlite3

Clock = Callable[[], datetime]
_Found = TypeVar("_Found")

_MOST = 2**63 - 1  # what SQLite can be asked for


def now() -> datetime:
    """The time, with its zone."""
    return datetime.now(UTC)


class History:
    """The history in one file; a context manager. Every method raises HistoryError where the file fails."""

    def __init__(self, path: Path, *, reading: bool, clock: Clock = now) -> None:
        self.path = path
        self.left_out: set[tuple[str, object]] = set()  # the rows that are damaged: table and number
        self.set_aside: Path | None = None  # where the file is that could not be read
        self.waiting = 0  # how many rows are kept beside it, for it is locked
        self._reading = reading
        self._clock = clock
        self._connection: sqlite3.Connection = None  # type: ignore[assignment] # until it is open
        self._open()

    @classmethod
    def open(cls, path: Path | None = None, *, reading: bool = False, clock: Clock = now) -> History:
        """The history at `path`; by default $JUDGE_DB or the file in the user's data folder.

        With `reading`, nothing is made where there is none yet, and a folder that cannot be written will do.

        Raises:
            HistoryError: it cannot be opened, is newer than this judge, or is no history.
        """
        try:
            import sqlite3  # noqa: F401
        except ImportError as fault:  # an interpreter that was built without it
            what = f"this Python cannot keep a history: {fault}"
            raise HistoryError(what, remedy="install its sqlite3 module") from fault
        from judge.kata import beside
        from judge.kata.database import history_path

        history = cls(history_path() if path is None else path, reading=reading, clock=clock)
        beside.take_in(history.path, history._connection)
        return history

    def __enter__(self) -> History:
        return self

    def __exit__(self, *exc: object) -> None:
        self._connection.close()

    def add(self, result: Result, source: bytes, path: str) -> int:
        """Keep a run, in one transaction; its number, from 1, or 0 where it is kept beside the file."""
        return self._append("runs", *run_rows(result, source, path, self._time()))

    def runs(self, problem: str | None = None, limit: int | None = None) -> list[Run]:
        """The last `limit` runs (all of them without one), of one problem or of all; oldest first."""
        return self._all("runs", problem, limit)

    def with_results(self, runs: Iterable[Run]) -> list[Run]:
        """Those of the runs whose results can be read; the others are left out."""
        found = []
        for run in runs:
            try:
                run.levels  # noqa: B018 - which reads the result
                found.append(run)
            except HistoryError:
                self.left_out.add(("runs", run.id))
        return found

    def run(self, number: int) -> Run:
        """The run of that number. Raises UsageError if there is none."""
        rows = self._select("runs", "WHERE id = ?", (number,)) if 0 < number <= _MOST else []
        if not rows:
            raise UsageError(f"there is no run {number}", remedy=self._numbers())
        try:
            run: Run = read("runs", rows[0])
        except DAMAGE as fault:  # no judge wrote this
            raise HistoryError(f"run {number} is damaged", where=str(self.path)) from fault
        return run

    def source(self, number: int) -> bytes:
        """The submission that run judged. Raises UsageError if there is no such run."""
        digest = self.run(number).source_hash
        rows = self._select("sources", "WHERE hash = ?", (digest,))
        try:
            source: bytes = read("sources", rows[0])
        except (IndexError, *DAMAGE) as fault:  # it is not there, or no judge wrote it
            raise HistoryError(f"the source of run {number} is damaged", where=str(self.path)) from fault
        return source

    def latest_of(self, digest: str) -> int | None:
        """The latest run that judged the source of that sha256, if there is one."""
        ((number,),) = self._rows("SELECT max(id) FROM runs WHERE source = ?", (digest,))
        return number if isinstance(number, int) else None

    def current(self) -> Current | None:
        """The kata in hand, if one was taken up."""
        return next(iter(self._all("current")), None)

    def take_up(self, problem: str, path: str, problems: str = "") -> None:
        """Make that problem the kata in hand; the other arguments are those of `Current`."""
        row = (problem, os.fsencode(path), os.fsencode(problems))
        query = "REPLACE INTO current (id, problem, path, problems) VALUES (1, ?, ?, ?)"
        self._change(lambda connection: connection.execute(query, row))

    def hints_seen(self, problem: str) -> int:
        """How many of the problem's hints have been seen."""
        return max((each.hints for each in self.helps(problem)), default=0)

    def see_hints(self, problem: str, count: int) -> None:
        """Note that the first `count` hints of the problem are seen, now."""
        if count > 0:
            self._append("help", (self._time(), problem, count))

    def give_up(self, problem: str) -> None:
        """Note that the problem's solution was asked for before it was solved."""
        self._append("help", (self._time(), problem, 0))

    def gave_up(self, problem: str) -> bool:
        """Whether the problem was ever given up."""
        return any(each.gave_up for each in self.helps(problem))

    def helps(self, problem: str | None = None) -> list[Help]:
        """The help taken, with one problem or with all; oldest first."""
        return self._all("help", problem)

    def add_hack(self, problem: str, mistake: str, case: str, outcome: Outcome) -> None:
        """Note an attempt to break the wrong program that makes the mistake; `case` is that of `Hack`."""
        self._append("hacks", (self._time(), problem, mistake, case, outcome.value))

    def hacks(self, problem: str | None = None) -> list[Hack]:
        """The attempts to break wrong programs, of one problem or of all; oldest first."""
        return self._all("hacks", problem)

    def answer(self, card: str, form: str, rating: Rating, *, judged: bool, given: str = "") -> None:
        """Keep an answer to a card, now."""
        self._append("answers", (self._time(), card, form, int(rating), int(judged), given))

    def answers(self) -> list[Answered]:
        """Every answer to a card, oldest first."""
        return self._all("answers")

    def _append(self, table: str, row: Sequence[Any], source: Sequence[Any] | None = None) -> int:
        """Add a row without its number; its number, or 0 where the file is locked for too long."""
        from judge.database import is_busy
        from judge.kata import beside

        try:
            return self._change(lambda connection: beside.inserted(connection, table, row, source))
        except HistoryError as fault:
            if not is_busy(fault):
                raise
            beside.keep(self.path, table, row, source, fault)
            self.waiting += 1
            return 0

    def _numbers(self) -> str:
        ((first, last),) = self._rows("SELECT min(id), max(id) FROM runs")
        if first is None:
            return "there are none yet; 'judge run' adds one"
        return f"they go from {first} to {last}; see 'judge history'"

    def _time(self) -> int:
        return microseconds(self._clock())

    def _all(self, table: str, problem: str | None = None, limit: int | None = None) -> list[Any]:
        """What the last `limit` rows say, those of one problem or all; the damaged ones are left out."""
        where, values = ("", ()) if problem is None else ("WHERE problem = ?", (problem,))
        most = -1 if limit is None else min(limit, _MOST)
        found = []
        for row in reversed(self._select(table, f"{where} ORDER BY id DESC LIMIT ?", (*values, most))):
            try:
                found.append(read(table, row))
            except DAMAGE:
                self.left_out.add((table, row[0]))
        return found

    def _select(self, table: str, which: str, values: Sequence[object]) -> list[Any]:
        return self._rows(f"SELECT {', '.join(COLUMNS[table])} FROM {table} {which}", values)

    def _rows(self, query: str, values: Sequence[object] = ()) -> list[Any]:
        from judge.database import faults
        from judge.kata.database import HISTORY

        def rows() -> list[Any]:
            with faults(HISTORY, self.path):
                return self._connection.execute(query, values).fetchall()

        return self._again(rows)

    def _change(self, work: Callable[[sqlite3.Connection], _Found]) -> _Found:
        from judge.database import writing
        from judge.kata.database import HISTORY

        def changed() -> _Found:
            with writing(HISTORY, self._connection, self.path) as connection:
                return work(connection)

        return self._again(changed)

    def _open(self) -> None:
        """Open the file; one that is damaged is set aside, and a new one is begun."""
        from judge.database import connect
        from judge.kata.database import HISTORY, identity

        self._file = identity(self.path)
        try:
            self._connection = connect(HISTORY, self.path, reading=self._reading)
        except HistoryError as fault:
            self._set_aside(fault)
            self._connection = connect(HISTORY, self.path, reading=self._reading)
        self._connection.text_factory = text_of

    def _again(self, work: Callable[[], _Found]) -> _Found:
        """What `work` returns; on a new file, if the old one is found to be damaged."""
        try:
            return work()
        except HistoryError as fault:
            self._set_aside(fault)
            self._open()
            return work()

    def _set_aside(self, fault: HistoryError) -> None:
        """Set the file aside; raises `fault` where that does not say that our file is damaged."""
        from judge.database import is_damaged
        from judge.kata.database import is_ours, set_aside

        if not is_damaged(fault) or not is_ours(self.path):
            raise fault
        if self._connection is not None:
            self._connection.close()
        try:
            self.set_aside = set_aside(self.path, self._file) or self.set_aside
        except OSError:
            raise fault from None


def add_beside(path: Path | None, result: Result, source: bytes, file: str, fault: HistoryError) -> None:
    """Keep a run beside a history that is locked; arguments as of `History.open` and `History.add`.

    Raises `fault`, which says that it is locked, where that fails too.
    """
    from judge.kata import beside
    from judge.kata.database import history_path

    rows = run_rows(result, source, file, microseconds(now()))
    beside.keep(history_path() if path is None else path, "runs", *rows, fault)


def run_rows(result: Result, source: bytes, path: str, time: int) -> tuple[Sequence[Any], Sequence[Any]]:
    """The row of a run without its number, and that of its source."""
    digest = hashlib.sha256(source).hexdigest()
    published = json.dumps(result.as_json(), separators=(",", ":")).encode()
    accepted = [group.name for group in result.groups if group.verdict is Verdict.AC]
    rejected = [group.name for group in result.groups if group.verdict is not Verdict.AC]
    row = (
        time,
        result.problem,
        os.fsencode(result.submission),
        os.fsencode(path),
        result.verdict.value,
        result.score,
        result.mode.value,
        result.pitfall.name if result.pitfall else None,
        result.time.ratio.median if result.time.ratio else None,
        " ".join(accepted),
        " ".join(rejected),
        digest,
        zlib.compress(published),
    )
    return row, (digest, zlib.compress(source))
