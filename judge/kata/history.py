"""Every run and its source, the kata in hand, the help that was taken, and the answers to cards.

    with History.open() as history:
        history.add(result, source, path)
        history.runs("count")                        # oldest first

Importing this module imports no SQLite; opening a history does.
"""

from __future__ import annotations

import hashlib
import json
import os
import zlib
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from judge.errors import HistoryError, UsageError
from judge.kata.answers import Answered, Rating
from judge.kata.hacks import Hack, Outcome
from judge.problem import Verdict
from judge.problem.solutions import is_solution
from judge.problem.verdict import FULL_SCORE
from judge.run.result import Mode, Result

if TYPE_CHECKING:
    import sqlite3

Clock = Callable[[], datetime]

_MOST = 2**63 - 1  # what SQLite can be asked for
_START = datetime(1970, 1, 1, tzinfo=UTC)
_MICROSECOND = timedelta(microseconds=1)
_COLUMNS = (  # of a run, in the order of its table
    "id, time, problem, submission, path, verdict, score,"
    " mode, mistake, ratio, passed, failed, source, result"
)


def now() -> datetime:
    """The time, with its zone."""
    return datetime.now(UTC)


class Run(Struct, frozen=True):
    """One submission judged once.

    `submission` is the file as the person named it, `path` the same from the root (empty where it was no
    ordinary file). `passed` and `failed` name the test groups that were run. `ratio` is the median.
    """

    id: int
    when: datetime
    problem: str
    submission: str
    path: str
    verdict: Verdict
    score: int
    mode: Mode
    source_hash: str
    mistake: str | None
    ratio: float | None
    passed: tuple[str, ...]
    failed: tuple[str, ...]
    packed: bytes  # the result, compressed: of thousands of runs few are looked into

    @property
    def result(self) -> dict[str, Any]:
        """The object that `judge run --json` wrote. Raises HistoryError where it is damaged."""
        try:
            found = json.loads(zlib.decompress(self.packed))
        except (zlib.error, ValueError, TypeError, RecursionError) as fault:
            raise HistoryError(f"the result of run {self.id} is damaged") from fault
        if not isinstance(found, dict):
            raise HistoryError(f"the result of run {self.id} is damaged")
        return found

    @property
    def levels(self) -> tuple[str, ...]:
        """The levels of the kata that it passed whole. Raises HistoryError where its result is damaged."""
        try:
            return tuple(each["level"] for each in self.result.get("levels", ()) if each["passed"])
        except (TypeError, KeyError) as fault:
            raise HistoryError(f"the result of run {self.id} is damaged") from fault

    @property
    def whole(self) -> bool:
        """Whether it was accepted with no group left out."""
        return self.verdict is Verdict.AC and self.score >= FULL_SCORE

    @property
    def counts(self) -> bool:
        """Whether it says something of the person.

        A fault of the judge's own does not, nor does a problem's own solution: solutions/<problem>/<kind>/.
        """
        return self.verdict is not Verdict.JE and not self._by_the_setter

    @property
    def solved(self) -> bool:
        """Whether the person solved the problem with it."""
        return self.whole and self.counts

    @property
    def _by_the_setter(self) -> bool:
        return is_solution(self.path, self.problem)


class Current(Struct, frozen=True):
    """The kata in hand: its problem, and the absolute path of the file that will be judged.

    `problems` is the folder that the problem lies in, empty for one that every judge finds by itself.
    """

    problem: str
    path: str
    problems: str = ""


class Help(Struct, frozen=True):
    """Help taken with a problem: `hints` is how many had been seen then, 0 where it was given up."""

    when: datetime
    problem: str
    hints: int

    @property
    def gave_up(self) -> bool:
        """Whether the answer was asked for."""
        return self.hints == 0


class History:
    """The history in one file; a context manager. Every method raises HistoryError where the file fails."""

    def __init__(self, connection: sqlite3.Connection, path: Path, clock: Clock = now) -> None:
        self.path = path
        self._connection = connection
        self._clock = clock

    @classmethod
    def open(cls, path: Path | None = None, *, reading: bool = False, clock: Clock = now) -> History:
        """The history at `path`; by default $JUDGE_DB or the file in the user's data folder.

        With `reading`, nothing is made where there is none yet, and a folder that cannot be written will do.

        Raises:
            HistoryError: it cannot be opened, is newer than this judge, or is no history.
        """
        try:
            from judge.database import connect
            from judge.kata.database import HISTORY, history_path
        except ImportError as fault:  # an interpreter that was built without it
            what = f"this Python cannot keep a history: {fault}"
            raise HistoryError(what, remedy="install its sqlite3 module") from fault
        path = history_path() if path is None else path
        return cls(connect(HISTORY, path, reading=reading), path, clock)

    def __enter__(self) -> History:
        return self

    def __exit__(self, *exc: object) -> None:
        self._connection.close()

    def add(self, result: Result, source: bytes, path: str) -> int:
        """Keep a run, in one transaction; its number, from 1."""
        digest = hashlib.sha256(source).hexdigest()
        published = json.dumps(result.as_json(), separators=(",", ":")).encode()
        accepted = [group.name for group in result.groups if group.verdict is Verdict.AC]
        rejected = [group.name for group in result.groups if group.verdict is not Verdict.AC]
        row = (
            self._time(),
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
        with self._writing() as connection:
            connection.execute("INSERT OR IGNORE INTO sources VALUES (?, ?)", (digest, zlib.compress(source)))
            values = f"(NULL, {', '.join('?' * len(row))})"
            number = connection.execute(f"INSERT INTO runs ({_COLUMNS}) VALUES {values}", row).lastrowid
        assert number is not None
        return number

    def runs(self, problem: str | None = None, limit: int | None = None) -> list[Run]:
        """The last `limit` runs (all of them without one), of one problem or of all; oldest first."""
        where, values = ("", ()) if problem is None else ("WHERE problem = ?", (problem,))
        rows = self._rows(
            f"SELECT {_COLUMNS} FROM runs {where} ORDER BY id DESC LIMIT ?",
            (*values, -1 if limit is None else min(limit, _MOST)),
        )
        return [self._run(row) for row in reversed(rows)]

    def run(self, number: int) -> Run:
        """The run of that number. Raises UsageError if there is none."""
        rows = self._rows(f"SELECT {_COLUMNS} FROM runs WHERE id = ?", (number,)) if _stored(number) else []
        if not rows:
            raise UsageError(f"there is no run {number}", remedy=self._numbers())
        return self._run(rows[0])

    def source(self, number: int) -> bytes:
        """The submission that run judged. Raises UsageError if there is no such run."""
        digest = self.run(number).source_hash
        rows = self._rows("SELECT body FROM sources WHERE hash = ?", (digest,))
        try:
            return zlib.decompress(rows[0][0])
        except (IndexError, TypeError, zlib.error) as fault:  # it is not there, or no judge wrote it
            raise HistoryError(f"the source of run {number} is damaged", where=str(self.path)) from fault

    def latest_of(self, digest: str) -> int | None:
        """The latest run that judged the source of that sha256, if there is one."""
        ((number,),) = self._rows("SELECT max(id) FROM runs WHERE source = ?", (digest,))
        return number if isinstance(number, int) else None

    def current(self) -> Current | None:
        """The kata in hand, if one was taken up."""
        rows = self._rows("SELECT problem, path, problems FROM current")
        return Current(rows[0][0], *map(os.fsdecode, rows[0][1:])) if rows else None

    def take_up(self, problem: str, path: str, problems: str = "") -> None:
        """Make that problem the kata in hand; the other arguments are those of `Current`."""
        row = (problem, os.fsencode(path), os.fsencode(problems))
        with self._writing() as connection:
            connection.execute("REPLACE INTO current (id, problem, path, problems) VALUES (1, ?, ?, ?)", row)

    def hints_seen(self, problem: str) -> int:
        """How many of the problem's hints have been seen."""
        ((seen,),) = self._rows("SELECT coalesce(max(hints), 0) FROM help WHERE problem = ?", (problem,))
        return int(seen)

    def see_hints(self, problem: str, count: int) -> None:
        """Note that the first `count` hints of the problem are seen, now."""
        if count > 0:
            self._help(problem, count)

    def give_up(self, problem: str) -> None:
        """Note that the problem's solution was asked for before it was solved."""
        self._help(problem, 0)

    def gave_up(self, problem: str) -> bool:
        """Whether the problem was ever given up."""
        return bool(self._rows("SELECT 1 FROM help WHERE problem = ? AND hints = 0 LIMIT 1", (problem,)))

    def helps(self, problem: str | None = None) -> list[Help]:
        """The help taken, with one problem or with all; oldest first."""
        where, values = ("", ()) if problem is None else ("WHERE problem = ?", (problem,))
        rows = self._rows(f"SELECT time, problem, hints FROM help {where} ORDER BY id", values)
        return [Help(_when(time), name, hints) for time, name, hints in rows]

    def add_hack(self, problem: str, mistake: str, case: str, outcome: Outcome) -> None:
        """Note an attempt to break the wrong program that makes the mistake; `case` is that of `Hack`."""
        with self._writing() as connection:
            connection.execute(
                "INSERT INTO hacks (time, problem, mistake, line, outcome) VALUES (?, ?, ?, ?, ?)",
                (self._time(), problem, mistake, case, outcome.value),
            )

    def hacks(self, problem: str | None = None) -> list[Hack]:
        """The attempts to break wrong programs, of one problem or of all; oldest first."""
        where, values = ("", ()) if problem is None else ("WHERE problem = ?", (problem,))
        rows = self._rows(
            f"SELECT time, problem, mistake, line, outcome FROM hacks {where} ORDER BY id", values
        )
        with self._reading("an attempt of judge hack"):
            return [
                Hack(_when(time), name, mistake, line, Outcome(outcome))
                for time, name, mistake, line, outcome in rows
            ]

    def answer(self, card: str, form: str, rating: Rating, *, judged: bool, given: str = "") -> None:
        """Keep an answer to a card, now."""
        row = (self._time(), card, form, int(rating), int(judged), given)
        columns = "(time, card, form, rating, judged, given)"
        with self._writing() as connection:
            connection.execute(f"INSERT INTO answers {columns} VALUES (?, ?, ?, ?, ?, ?)", row)

    def answers(self) -> list[Answered]:
        """Every answer to a card, oldest first."""
        found = []
        for row in self._rows("SELECT id, time, card, form, rating, judged, given FROM answers ORDER BY id"):
            with self._reading(f"answer {row[0]}"):
                _, time, card, form, rating, judged, given = row
                _texts(card, form, given)
                found.append(Answered(_when(time), card, form, Rating(rating), bool(judged), given))
        return found

    def _help(self, problem: str, hints: int) -> None:
        with self._writing() as connection:
            connection.execute(
                "INSERT INTO help (time, problem, hints) VALUES (?, ?, ?)", (self._time(), problem, hints)
            )

    def _numbers(self) -> str:
        ((first, last),) = self._rows("SELECT min(id), max(id) FROM runs")
        if first is None:
            return "there are none yet; 'judge run' adds one"
        return f"they go from {first} to {last}; see 'judge history'"

    def _time(self) -> int:
        return (self._clock() - _START) // _MICROSECOND

    def _run(self, row: Sequence[Any]) -> Run:
        with self._reading(f"run {row[0]}"):
            return _run(row)

    @contextmanager
    def _reading(self, what: str) -> Iterator[None]:
        """What of a row cannot be read as a HistoryError."""
        try:
            yield
        except (ValueError, TypeError, OverflowError, AttributeError) as fault:  # no judge wrote this
            remedy = "move the file away, and a new one begins"
            raise HistoryError(f"{what} is damaged", where=str(self.path), remedy=remedy) from fault

    def _rows(self, query: str, values: Sequence[object] = ()) -> list[Any]:
        from judge.database import faults
        from judge.kata.database import HISTORY

        with faults(HISTORY, self.path):
            return self._connection.execute(query, values).fetchall()

    def _writing(self) -> AbstractContextManager[sqlite3.Connection]:
        from judge.database import writing
        from judge.kata.database import HISTORY

        return writing(HISTORY, self._connection, self.path)


def _stored(number: int) -> bool:
    return 0 < number <= _MOST


def _when(microseconds: int) -> datetime:
    return _START + microseconds * _MICROSECOND


def _texts(*values: object) -> None:
    """Raise TypeError unless these are texts."""
    if not all(isinstance(each, str) for each in values):
        raise TypeError("text is meant")


def _run(row: Sequence[Any]) -> Run:
    (
        number,
        time,
        problem,
        submission,
        path,
        verdict,
        score,
        mode,
        mistake,
        ratio,
        passed,
        failed,
        source,
        packed,
    ) = row
    _texts(problem, passed, failed, source, mistake or "")
    return Run(
        number,
        _when(time),
        problem,
        os.fsdecode(submission),
        os.fsdecode(path),
        Verdict(verdict),
        score,
        Mode(mode),
        source,
        mistake,
        ratio,
        tuple(passed.split()),
        tuple(failed.split()),
        packed,
    )
