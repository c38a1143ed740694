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
from typing import Any, TypeVar

from msgspec import Struct

from judge.errors import HistoryError
from judge.kata.answers import Answered, Rating
from judge.kata.hacks import Hack, Outcome
from judge.problem import Verdict
from judge.problem.model import FULL_SCORE
from judge.problem.solutions import is_solution
from judge.run.result import Mode, Result, read_result

_Kind = TypeVar("_Kind")
DAMAGE = (ValueError, TypeError, OverflowError, AttributeError, zlib.error)
_START = datetime(1970, 1, 1, tzinfo=UTC)
_MICROSECOND = timedelta(microseconds=1)
_LATEST = 2**57  # microseconds: in the year 6537


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
    mistake: str | None
    ratio: float | None
    passed: tuple[str, ...]
    failed: tuple[str, ...]
    source_hash: str
    packed: bytes  # the result, compressed: of thousands of runs few are looked into

    @property
    def result(self) -> Result:
        """What it came to, as far as its judge kept that. Raises HistoryError where it is damaged."""
        try:
            plain = json.loads(zlib.decompress(self.packed), parse_float=_finite, parse_constant=_finite)
            return read_result(plain)
        except (zlib.error, ValueError, TypeError, RecursionError) as fault:
            raise HistoryError(f"the result of run {self.id} is damaged") from fault

    @property
    def levels(self) -> tuple[str, ...]:
        """The levels of the kata that it passed whole. Raises HistoryError where its result is damaged."""
        return tuple(each.level.value for each in self.result.levels if each.passed)

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
    make, readers = _TABLES[table]
    return make(*(reader(value) for reader, value in zip(readers.values(), row, strict=True) if reader))


def _when(time: int) -> datetime:
    if not 0 <= time < _LATEST:
        raise ValueError(f"{time} is no time of a run")
    return _START + time * _MICROSECOND


def _finite(number: str | float) -> float:
    """The number, which JSON can write again. Raises ValueError."""
    found = float(number)
    if not math.isfinite(found):
        raise ValueError(f"{number} is no number of a run")
    return found


def _text(value: object) -> str:
    return _of(str, value)


def _number(value: object) -> int:
    found = _of(int, value)
    if found < 0:
        raise ValueError(f"{found} is less than 0")
    return found


def _of(kind: type[_Kind], value: object) -> _Kind:
    if not isinstance(value, kind):
        raise TypeError(f"{kind.__name__} is meant")
    return value


def _names(value: object) -> tuple[str, ...]:
    return tuple(_text(value).split())


def _packed(value: object) -> bytes:
    return _of(bytes, value)


_Readers = Mapping[str, Callable[[Any], Any] | None]
_TABLES: Mapping[str, tuple[Callable[..., Any], _Readers]] = {
    "sources": (zlib.decompress, {"hash": None, "body": _packed}),
    "runs": (
        Run,
        {
            "id": _number,
            "time": _when,
            "problem": _text,
            "submission": os.fsdecode,
            "path": os.fsdecode,
            "verdict": Verdict,
            "score": _number,
            "mode": Mode,
            "mistake": lambda value: None if value is None else _text(value),
            "ratio": lambda value: None if value is None else _finite(_of(float, value)),
            "passed": _names,
            "failed": _names,
            "source": _text,
            "result": _packed,
        },
    ),
    "help": (Help, {"id": None, "time": _when, "problem": _text, "hints": _number}),
    "hacks": (
        Hack,
        {"id": None, "time": _when, "problem": _text, "mistake": _text, "line": _text, "outcome": Outcome},
    ),
    "answers": (
        Answered,
        {
            "id": None,
            "time": _when,
            "card": _text,
            "form": _text,
            "rating": Rating,
            "judged": bool,
            "given": _text,
        },
    ),
    "current": (Current, {"id": None, "problem": _text, "path": os.fsdecode, "problems": os.fsdecode}),
}
COLUMNS: Mapping[str, tuple[str, ...]] = {name: tuple(readers) for name, (_, readers) in _TABLES.items()}
"""The columns of each table, in the order in which rows are read; the first one names a row."""
