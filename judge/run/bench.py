"""What programs take for a case, language beside language, each measured in turn in every round.

A case's time is the slope between one pass over the cases and as many as take long enough, so that no start
is in it, nor what a first pass costs; that one is told apart. A round measures everything once: a bare start
of Python, and of every program its start, a first pass and a long turn. What is shown is the median of the
rounds with its quartiles, and ratios are taken within a round, where the machine has one speed.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from functools import partial

from msgspec import Struct

from judge.data.model import GroupData, ProblemData
from judge.errors import JudgeError
from judge.languages import NAME as PYTHON
from judge.problem import Case
from judge.run.execute import opened
from judge.run.laps import Course, Lap, course, passes_for
from judge.run.parallel import Turnstile
from judge.run.result import Failure
from judge.run.runner import Runner
from judge.run.timing import quantile
from judge.sandbox.boundary import Box, BoxFactory, Limits
from judge.values import Accepted

LONG_SECONDS = 0.3  # of CPU time, of a long turn beyond its first pass
WARM_SECONDS = 1.0  # the same, where a compiler at run time has to warm up
MOST_CASES = 1_000
MOST_ROUNDS = 99
_BARE = [sys.executable, "-I", "-S", "-c", "pass"]
_CPU_SECONDS = 60.0
_WALL_SECONDS = 300.0
_OUTPUT_BYTES = 64 << 20

Places = Sequence[tuple[GroupData, int]]  # of cases: a group and an index in it
Tell = Callable[[str, int, int], None]  # what is measured, which turn it is, of how many


class Entrant(Struct, frozen=True):
    """A program to measure: its file's name, its source, its language's name; `own` is a person's own file.

    `missing` says why nothing in its language can be run here, `warms` that it is compiled while it runs.
    """

    name: str
    source: bytes
    language: str
    own: bool = False
    missing: str = ""
    warms: bool = False


class Spread(Struct, frozen=True):
    """A median with its quartiles."""

    median: float
    low: float
    high: float

    @classmethod
    def of(cls, values: Sequence[float]) -> Spread | None:
        """That of these values; None where there are none."""
        ordered = sorted(values)
        return cls(*(quantile(ordered, part) for part in (0.5, 0.25, 0.75))) if ordered else None


class Row(Struct, frozen=True):
    """What one program takes; the spreads are None where `why_not` says why it was not measured.

    `seconds` and `first` are CPU seconds of a case, in the long run and in the first pass, `ratio` that of
    `seconds` to the first program's, `start` the CPU time of its start in bare starts of Python. `passes` is
    how many a long turn makes; `wrong` how many of the cases it answers wrongly.
    """

    entrant: Entrant
    seconds: Spread | None = None
    ratio: Spread | None = None
    first: Spread | None = None
    start: Spread | None = None
    memory_bytes: int = 0
    passes: int = 0
    wrong: int = 0
    why_not: str = ""


class Bench(Struct, frozen=True):
    """The rows, of so many cases in so many of the rounds that were `wanted`; `bare` is a bare start.

    In the rounds `beside` others another judge was not kept out.
    """

    problem: str
    cases: int
    rounds: int
    wanted: int
    bare: Spread | None
    rows: tuple[Row, ...]
    isolation: str
    beside: int = 0

    @property
    def interrupted(self) -> bool:
        """Whether there are fewer rounds than were wanted."""
        return self.rounds < self.wanted


class _Turn(Struct, frozen=True):
    """One program in one round, in CPU seconds: its start, the first pass and the long turn without it."""

    start: float
    first: float
    long: float


class _Measured:
    """One program with what is known of it so far."""

    def __init__(self, entrant: Entrant, runner: Runner, box: Box, cases: Sequence[Case]) -> None:
        self.entrant = entrant
        self.count = len(cases)
        self.turns: list[_Turn] = []
        self.memory = self.wrong = 0
        self.passes = 1
        self._limits = Limits(
            _CPU_SECONDS, _WALL_SECONDS, runner.problem.limits.memory_bytes, _OUTPUT_BYTES,
            items=runner.problem.answer.items,
        )  # fmt: skip
        self._course: Course = course(runner, box, cases)

    def prepare(self, wrong: Callable[[Lap], int]) -> None:
        """Find how many passes are long enough, and how many answers are wrong. Raises JudgeError."""
        once = self._lap(1)
        self.wrong = wrong(once)

        def take(passes: int) -> float:
            return self._lap(1 + passes).usage.cpu_seconds - once.usage.cpu_seconds

        if self._course.most > 1 and once.usage.cpu_seconds < _CPU_SECONDS / 4:
            enough = WARM_SECONDS if self.entrant.warms else LONG_SECONDS
            more, _ = passes_for(enough, take, self._course.most - 1)
            self.passes = 1 + more

    def turn(self) -> None:
        """Measure it once more. Raises JudgeError where it does not come to the end."""
        start = self._lap(0).usage.cpu_seconds
        first = self._lap(1).usage.cpu_seconds - start
        long = self._lap(self.passes) if self.passes > 1 else None
        took = long.usage.cpu_seconds - start if long else first
        self.turns.append(_Turn(start, max(0.0, first), max(0.0, took)))

    def _lap(self, passes: int) -> Lap:
        lap = self._course.run(passes, self._limits)
        if lap.trouble:
            raise JudgeError(lap.trouble)
        if passes == 1:  # more of them hold a longer input as well
            self.memory = max(self.memory, lap.usage.memory_bytes)
        return lap

    def seconds(self, turn: _Turn) -> float:
        """Of a case, once everything is warm."""
        if self.passes == 1:
            return turn.long / self.count
        return max(0.0, turn.long - turn.first) / (self.count * (self.passes - 1))


def bench(
    data: ProblemData,
    groups: Sequence[GroupData],
    entrants: Sequence[Entrant],
    box_factory: BoxFactory,
    rounds: int,
    tell: Tell | None = None,
    turnstile: Turnstile | None = None,
) -> Bench:
    """Measure the programs on the groups' cases, or a sample of them; ratios are to the first one.

    Each round is alone, by the `turnstile`, so that the ratios within it are of one machine.

    A KeyboardInterrupt ends it with the rounds that are whole.

    Raises:
        ProblemError: the reference fails on a case.
        UsageError: the isolation cannot be had.
    """
    places = [(group, index) for group in groups for index in range(len(group.cases))]
    chosen = places[:: 1 + (len(places) - 1) // MOST_CASES]
    cases = [group.cases[index] for group, index in chosen]
    turnstile = turnstile or Turnstile()
    tell = tell or (lambda _what, _done, _total: None)
    total = len(entrants) * (rounds + 1)
    found: dict[Entrant, _Measured] = {}
    why_not = {each: each.missing for each in entrants if each.missing}
    bares: list[float] = []
    isolation, beside = "", 0
    with ExitStack() as stack:
        try:
            for done, each in enumerate(entrants):
                if each in why_not:
                    continue
                tell(f"{each.language}, getting ready", done, total)
                box = stack.enter_context(box_factory(each.source, each.name))
                with turnstile.judging():
                    made = _prepared(data, each, box, cases, chosen)
                isolation = isolation or box.isolation
                if isinstance(made, str):
                    why_not[each] = made
                else:
                    found[each] = made
            for number in range(rounds):
                with turnstile.measuring() as place:
                    bare = _bare_start()
                    for turn, each in enumerate(list(found)):
                        done = (number + 1) * len(entrants) + turn
                        tell(f"{each.language}, round {number + 1}", done, total)
                        try:
                            found[each].turn()
                        except JudgeError as fault:
                            why_not[each] = f"stopped in round {number + 1}: {fault}"
                            del found[each]
                    bares.append(bare)
                    beside += not place.alone
        except KeyboardInterrupt:
            tell("interrupted", total, total)
    whole = len(bares)
    base = found.get(entrants[0])
    rows = tuple(_row(each, found.get(each), why_not.get(each, ""), base, bares) for each in entrants)
    bare_start = Spread.of(bares)
    return Bench(data.problem.id, len(cases), whole, rounds, bare_start, rows, isolation, beside)


def _prepared(
    data: ProblemData,
    entrant: Entrant,
    box: Box,
    cases: Sequence[Case],
    places: Places,
) -> _Measured | str:
    """The program, ready to be measured; or why it cannot be."""
    runner = opened(box, data.problem, entrant.source)
    if isinstance(runner, Failure):
        return f"it does not compile: {runner.message}"
    made = _Measured(entrant, runner, box, cases)
    try:
        made.prepare(lambda lap: _wrong(data, runner, places, lap))
    except JudgeError as fault:
        return f"stopped: {fault}"
    return made


def _wrong(data: ProblemData, runner: Runner, places: Places, lap: Lap) -> int:
    """How many of its answers are wrong."""
    wrong = 0
    for (group, index), reply in zip(places, lap.answers[0].replies, strict=False):
        exact = partial(data.exact, group.cases[index], group.group)
        wrong += not isinstance(runner.decide(reply.answer, group.targets[index], exact), Accepted)
    return wrong


def _bare_start() -> float:
    """CPU seconds of a start of Python that does nothing."""
    pid = os.posix_spawn(_BARE[0], _BARE, {})
    usage = os.wait4(pid, 0)[2]
    return usage.ru_utime + usage.ru_stime


def _row(
    entrant: Entrant, made: _Measured | None, why_not: str, base: _Measured | None, bares: Sequence[float]
) -> Row:
    turns = made.turns[: len(bares)] if made else []
    if made is None or not turns:
        return Row(entrant, why_not=why_not or "not measured: it was interrupted before")
    ratios = [
        made.seconds(mine) / base.seconds(theirs)
        for mine, theirs in zip(turns, base.turns if base else (), strict=False)
        if base and base.seconds(theirs) > 0
    ]
    starts = [turn.start / bare for turn, bare in zip(turns, bares, strict=True) if bare > 0]
    return Row(
        entrant,
        Spread.of([made.seconds(turn) for turn in turns]),
        Spread.of(ratios),
        Spread.of([turn.first / made.count for turn in turns]),
        Spread.of(starts) if entrant.language != PYTHON else Spread(1.0, 1.0, 1.0),
        made.memory,
        made.passes,
        made.wrong,
    )
