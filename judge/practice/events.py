"""What the history keeps of a person: runs, help, answers to cards, attempts to break programs, katas begun.

Each struct is a row of the table `TABLES[kind]`, each field one of its columns. A row that no judge wrote,
because a disk failed or another program changed it, is damaged: reading it raises one of `DAMAGE`.
"""

from __future__ import annotations

import math
import os
import zlib
from collections.abc import Callable, Iterable, Mapping
from datetime import UTC, datetime, timedelta
from enum import Enum, IntEnum
from typing import TYPE_CHECKING, Any, TypeVar

import msgspec
from msgspec import Struct, field

from judge.errors import StoreError
from judge.problem import Verdict
from judge.problem.model import FULL_SCORE, Mode, is_solution

if TYPE_CHECKING:
    from judge.run.result import Result

_LARGEST = 16 << 20  # bytes of a result
DAMAGE = (ValueError, TypeError, OverflowError, AttributeError, zlib.error, RecursionError)
_START, _TICK = datetime(1970, 1, 1, tzinfo=UTC), timedelta(microseconds=1)
Kind = TypeVar("Kind", bound="Event")


def grouped(events: Iterable[Kind], key: Callable[[Kind], str]) -> dict[str, list[Kind]]:
    """The events by what `key` says of them, in their order."""
    found: dict[str, list[Kind]] = {}
    for event in events:
        found.setdefault(key(event), []).append(event)
    return found


def now() -> datetime:
    """The time, with its zone."""
    return datetime.now(UTC)


class Event(Struct, frozen=True, kw_only=True, rename={"when": "time"}):
    """Something that happened at that time, by default now."""

    when: datetime = field(default_factory=lambda: now())


class Run(Event, frozen=True, rename={"source_hash": "source", "packed": "result"}):
    """One submission judged once; `id` is 0 until it is kept.

    `submission` is the file as the person named it, `path` the same from the root (empty where it was no
    ordinary file). `passed` and `failed` name the test groups that were run. `ratio` is the median.
    """

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
    id: int = 0

    @property
    def result(self) -> Result:
        """What it came to, as far as its judge kept that. Raises StoreError where it is damaged."""
        import json  # neither is for who only counts runs

        from judge.run.kept import read_result

        try:
            plain = json.loads(unpacked(self.packed, _LARGEST), parse_float=_finite, parse_constant=_finite)
            return read_result(plain)
        except DAMAGE as fault:
            raise StoreError(f"the result of run {self.id} is damaged") from fault

    @property
    def levels(self) -> tuple[str, ...]:
        """The levels of the kata that it passed whole. Raises StoreError where its result is damaged."""
        return tuple(each.level.value for each in self.result.levels if each.passed)

    @property
    def whole(self) -> bool:
        """Whether it was accepted with no group left out."""
        return self.verdict is Verdict.AC and self.score >= FULL_SCORE

    @property
    def counts(self) -> bool:
        """Whether it says something of the person: a fault of the judge's and a model solution do not."""
        return self.verdict is not Verdict.JE and not is_solution(self.path, self.problem)

    @property
    def solved(self) -> bool:
        """Whether the person solved the problem with it."""
        return self.whole and self.counts


class Started(Event, frozen=True):
    """A kata was taken up: its problem, and the absolute path of the file that is to solve it.

    `problems` is the folder that the problem lies in, empty for one that every judge finds by itself.
    """

    problem: str
    path: str
    problems: str = ""


class Help(Event, frozen=True):
    """Help taken with a problem: `hints` is how many had been seen then, 0 where it was given up."""

    problem: str
    hints: int

    @property
    def gave_up(self) -> bool:
        """Whether the answer was asked for."""
        return self.hints == 0


class Outcome(Enum):
    """How an attempt to break a wrong program ended; the value is its name in JSON."""

    WON = "won"
    LOST = "lost"
    GIVEN_UP = "given-up"


class Hack(Event, frozen=True, rename={"case": "line"}):
    """One attempt at the wrong program that makes `mistake`.

    `case` is the line that a program reads; of one that was given up, the case that was shown, or nothing.
    """

    problem: str
    mistake: str
    case: str
    outcome: Outcome


class Rating(IntEnum):
    """How well something was remembered."""

    AGAIN = 1
    HARD = 2
    GOOD = 3
    EASY = 4


class Answer(Event, frozen=True):
    """One answer to a card; `judged` where the judge decided how it went, and not the person.

    `card` is the card's key, its deck and its id; `given` is what was typed.
    """

    card: str
    form: str
    rating: Rating
    judged: bool
    given: str = ""

    @property
    def known(self) -> bool:
        """Whether it was remembered at all."""
        return self.rating is not Rating.AGAIN


TABLES = {Run: "runs", Started: "started", Help: "help", Hack: "hacks", Answer: "answers"}


def to_row(event: Event) -> dict[str, Any]:
    """The event as SQLite keeps it, by column; without its number, which SQLite gives."""
    row = msgspec.to_builtins(event, builtin_types=(bytes, datetime))
    row.pop("id", None)
    return {name: _FORMS[name][1](value) if name in _FORMS else value for name, value in row.items()}


def unpacked(data: bytes, most: int) -> bytes:
    """What was compressed, which must be no longer. Raises one of DAMAGE."""
    unpacking = zlib.decompressobj()
    found = unpacking.decompress(data, most + 1)
    if len(found) > most or not unpacking.eof:
        raise ValueError(f"more than {most} bytes, or cut off")
    return found


def from_row(kind: type[Kind], row: Mapping[str, Any]) -> Kind:
    """The event that a row says. Raises one of DAMAGE."""
    values = {name: _FORMS[name][0](value) if name in _FORMS else value for name, value in row.items()}
    return msgspec.convert(values, kind, builtin_types=(bytes, datetime))


def _finite(number: str | float) -> float:
    """The number, which JSON can write again. Raises ValueError."""
    if not math.isfinite(found := float(number)):
        raise ValueError(f"{number} is not a number of a run")
    return found


def _counted(number: int) -> int:
    if number < 0:
        raise ValueError(f"{number} is less than 0")
    return number


_Forms = Mapping[str, tuple[Callable[[Any], Any], Callable[[Any], Any]]]
_FORMS: _Forms = {  # how a column is read and written, where that is not as it is
    "time": (lambda ticks: _START + _counted(ticks) * _TICK, lambda when: (when - _START) // _TICK),
    **dict.fromkeys(("submission", "path", "problems"), (os.fsdecode, os.fsencode)),
    **dict.fromkeys(("passed", "failed"), (str.split, " ".join)),
    **dict.fromkeys(("score", "hints"), (_counted, int)),
    "judged": (bool, int),
    "ratio": (lambda ratio: None if ratio is None else _finite(ratio), lambda ratio: ratio),
}
