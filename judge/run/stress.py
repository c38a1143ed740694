"""Judging one submission on fresh cases until the time is up or something breaks.

Series of fresh cases go into the box a handful at once: few enough that the clock is looked at several
times a second, enough that a process is no cost. Each series has a test group's limits to itself, so what
breaks here would have broken in a pinned group of those cases.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from itertools import islice

from msgspec import Struct
from msgspec.structs import replace

from judge.data.build import Fresh
from judge.data.model import GroupData, ProblemData
from judge.problem import Verdict
from judge.run.alone import MeasureLock
from judge.run.execute import opened, uncompiled
from judge.run.group import GroupRun
from judge.run.groups import Budget, Judging
from judge.run.result import Failure, GroupResult, Result, Timing
from judge.run.runner import Runner
from judge.sandbox.boundary import Box, Usage

MOST_SERIES = 16  # in one process: about as many cases as a problem's pinned ones, which share one too
_SHORT, _LONG = 0.1, 0.4  # seconds: more series at once below the first, fewer above the second

OnCases = Callable[[int, float], None]  # cases so far, seconds so far


class Broken(Struct, frozen=True):
    """What broke: the series, and the failure with its case counted from 1 there."""

    series: GroupData
    failure: Failure


class Stressed(Struct, frozen=True):
    """What a stress came to.

    `result` has what was judged of each group; its failure's case is counted in all the cases of its group.
    `runner` is how the submission was run; None where it could not be.
    """

    result: Result
    seed: int
    seconds: float
    cases: int = 0
    interrupted: bool = False
    broken: Broken | None = None
    runner: Runner | None = None


def stress(
    data: ProblemData,
    fresh: Fresh,
    box: Box,
    source: bytes,
    name: str,
    *,
    seconds: float,
    on_cases: OnCases | None = None,
    lock: MeasureLock | None = None,
    clock: Callable[[], float] = time.monotonic,
) -> Stressed:
    """Judge the submission in `box` on the problem's fresh cases for so many seconds; Ctrl-C ends it early.

    `data` answers for the problem's exact answers; its own cases are not judged. Who waits at the `lock` to
    measure gets in between two handfuls of series.

    Raises:
        ProblemError: a builder, the promise or the reference fails.
        JudgeError: nothing can be run on this machine.
    """
    runner = opened(box, data.problem, source)
    if isinstance(runner, Failure):
        return Stressed(uncompiled(data.problem, name, runner, box), fresh.seed, 0.0)
    run, lock = _Run(data, runner, box, clock, seconds), lock or MeasureLock()
    begun, interrupted = clock(), False
    series = fresh.series()
    try:
        while not run.over:
            with lock.judging():
                run.some(series)
            if on_cases:
                on_cases(run.cases, clock() - begun)
    except KeyboardInterrupt:
        interrupted = True
        run.close()
    result = run.result(name, [group.name for group in fresh.groups])
    return Stressed(result, fresh.seed, clock() - begun, run.cases, interrupted, run.broken, runner)


class _Run:
    """A stress under way."""

    def __init__(
        self, data: ProblemData, runner: Runner, box: Box, clock: Callable[[], float], seconds: float
    ) -> None:
        self.cases = 0
        self.broken: Broken | None = None
        self._data = data
        self._box = box
        self._runner = runner
        self._clock = clock
        self._end = clock() + seconds
        self._usage = Usage()
        self._totals: dict[str, GroupResult] = {}  # what the groups have come to so far
        self._failure: Failure | None = None
        self._at_once = 1
        self._now: Sequence[tuple[GroupData, GroupRun]] = ()

    def some(self, series: Iterator[GroupData]) -> None:
        """Judge the next few series."""
        begun = self._clock()
        self._now = [
            (each, GroupRun(self._data, each, self._runner)) for each in islice(series, self._at_once)
        ]
        budget = Budget(self._data.problem, lambda: self.over)
        Judging(self._runner, self._box, budget).run([run for _, run in self._now])
        self.close()
        took = self._clock() - begun
        if took < _SHORT:
            self._at_once = min(2 * self._at_once, MOST_SERIES)
        elif took > _LONG:
            self._at_once = max(1, self._at_once // 2)

    def close(self) -> None:
        """Count the series that were judged to their end, or until something broke."""
        now, self._now = self._now, ()
        for series, run in now:
            if run.given_up or not (run.ended or run.failure):
                continue
            name, more = series.group.name, run.result()
            total = self._totals.get(name) or replace(
                more, cases=0, passed=0, points=0, level=None, cpu_seconds=0.0, undecided=0
            )
            first = 0  # of a program that broke, the case that it broke at
            if run.failure:
                first = run.failure.case or 0
                if self.broken is None:
                    self.broken = Broken(series, run.failure)
                    self._failure = replace(run.failure, case=total.cases + first if first else None)
            reached = max(run.reached, first)
            worst = [each for each in (total.worst_ulps, more.worst_ulps) if each]
            self._totals[name] = replace(
                total,
                verdict=more.verdict if total.verdict is Verdict.AC else total.verdict,
                cases=total.cases + reached,
                passed=total.passed + more.passed,
                worst_ulps=max(worst) if worst else more.worst_ulps,
                cpu_seconds=total.cpu_seconds + more.cpu_seconds,
            )
            self.cases += reached
            self._usage += run.usage

    def result(self, name: str, groups: Sequence[str]) -> Result:
        """What it has come to, in the order of the groups."""
        failing = self._totals[self.broken.series.group.name] if self.broken else None
        return Result(
            problem=self._data.problem.id,
            submission=name,
            mode=self._runner.mode,
            verdict=failing.verdict if failing else Verdict.AC,
            groups=tuple(total for each in groups if (total := self._totals.get(each)) and total.cases),
            failure=self._runner.explained(self._failure) if self._failure else None,
            time=Timing(cpu_seconds=self._usage.cpu_seconds, wall_seconds=self._usage.wall_seconds),
            memory_bytes=self._usage.memory_bytes,
            isolation=self._box.isolation,
        )

    @property
    def over(self) -> bool:
        """Whether something broke or the time is up; it never is before a first case was judged."""
        broken = self.broken is not None or any(run.failure for _, run in self._now)
        judged = self.cases > 0 or any(run.ended for _, run in self._now)
        return broken or (judged and self._clock() >= self._end)
