"""What the rows of the history's tables say: runs, help, the kata in hand, attempts and answers.

A row that no judge wrote, because a disk failed or another program was at it, is damaged: reading it raises
one of `DAMAGE`, and costs nothing but itself.
"""

from __future__ import annotations

import json
import math
import os
import zlib
from collections.abc import Callable, Mapping, Sequence
from datetime import UTC, datetime, timedelta
from typing import Any

from msgspec import Struct

from judge.errors import HistoryError
from judge.kata.answers import Answered, Rating
from judge.kata.hacks import Hack, Outcome
from judge.problem import Verdict
from judge.problem.solutions import is_solution
from judge.problem.verdict import FULL_SCORE
from judge.run.result import Mode

COLUMNS: Mapping[str, tuple[str, ...]] = {
    "sources": ("hash", "body"),
    "runs": (
        *("id", "time", "problem", "submission", "path", "verdict", "score", "mode", "mistake", "ratio"),
        *("passed", "failed", "source", "result"),
    ),
    "help": ("id", "time", "problem", "hints"),
    "hacks": ("id", "time", "problem", "mistake", "line", "outcome"),
    "answers": ("id", "time", "card", "form", "rating", "judged", "given"),
    "current": ("id", "problem", "path", "problems"),
}
"""The columns of each table, in the order in which rows are read; the first one names a row."""

DAMAGE = (ValueError, TypeError, OverflowError, AttributeError)
_START = datetime(1970, 1, 1, tzinfo=UTC)
_MICROSECOND = timedelta(microseconds=1)


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
            found = json.loads(zlib.decompress(self.packed), parse_float=_finite, parse_constant=_finite)
        except (zlib.error, ValueError, TypeError, RecursionError) as fault:
            raise HistoryError(f"the result of run {self.id} is damaged") from fault
        if not isinstance(found, dict):
            raise HistoryError(f"the result of run {self.id} is damaged")
        return found

    @property
    def levels(self) -> tuple[str, ...]:
        """The levels of the kata that it passed whole. Raises HistoryError where its result is damaged."""
        try:
            found = tuple(each["level"] for each in self.result.get("levels", ()) if each["passed"])
            _are(str, *found)
            return found
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


def text_of(content: bytes) -> str | bytes:
    """A text of the file; what is none stays bytes, so that it costs its own row alone."""
    try:
        return content.decode()
    except UnicodeDecodeError:
        return content


def microseconds(when: datetime) -> int:
    """A moment as the history keeps it."""
    return (when - _START) // _MICROSECOND


def read(table: str, row: Sequence[Any]) -> Any:
    """What a row of a table says. Raises one of DAMAGE."""
    return _READERS[table](row)


def _run(row: Sequence[Any]) -> Run:
    number, time, problem, submission, path, verdict, score, mode, mistake, ratio, *rest = row
    passed, failed, source, packed = rest
    _are(str, problem, passed, failed, source, "" if mistake is None else mistake)
    _are(int, number, score)
    _are(float, 0.0 if ratio is None else ratio)
    _finite(ratio or 0.0)
    _are(bytes, packed)
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


def _help(row: Sequence[Any]) -> Help:
    _, time, problem, hints = row
    _are(str, problem)
    _are(int, hints)
    if hints < 0:
        raise ValueError(f"{hints} hints")
    return Help(_when(time), problem, hints)


def _hack(row: Sequence[Any]) -> Hack:
    _, time, problem, mistake, line, outcome = row
    _are(str, problem, mistake, line)
    return Hack(_when(time), problem, mistake, line, Outcome(outcome))


def _answer(row: Sequence[Any]) -> Answered:
    _, time, card, form, rating, judged, given = row
    _are(str, card, form, given)
    return Answered(_when(time), card, form, Rating(rating), bool(judged), given)


def _current(row: Sequence[Any]) -> Current:
    _, problem, path, problems = row
    _are(str, problem)
    return Current(problem, os.fsdecode(path), os.fsdecode(problems))


def _source(row: Sequence[Any]) -> bytes:
    digest, body = row
    _are(str, digest)
    try:
        return zlib.decompress(body)
    except zlib.error as fault:
        raise ValueError(str(fault)) from fault


_READERS: Mapping[str, Callable[[Sequence[Any]], Any]] = {
    "sources": _source,
    "runs": _run,
    "help": _help,
    "hacks": _hack,
    "answers": _answer,
    "current": _current,
}


def _when(time: int) -> datetime:
    return _START + time * _MICROSECOND


def _finite(number: str | float) -> float:
    """The number, which JSON can write again. Raises ValueError."""
    found = float(number)
    if not math.isfinite(found):
        raise ValueError(f"{number} is no number of a run")
    return found


def _are(kind: type, *values: object) -> None:
    """Raise TypeError unless these are of that kind."""
    if not all(isinstance(each, kind) for each in values):
        raise TypeError(f"{kind.__name__} is meant")
