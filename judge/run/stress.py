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

from judge.data import GroupData, ProblemData
from judge.data.build import Fresh
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
) -> Stressed:
    """Judge the submission in `box` on the problem's fresh cases for so many seconds.

    Ctrl-C ends it early, and the handful of series that is being judged does not count.

    `data` answers for the problem's exact answers; its own cases are not judged. Who waits at the `lock` to
    measure gets in between two handfuls of series.

    Raises:
        ProblemError: a builder, the promise or the reference fails.
        JudgeError: nothing can be run on this machine.
    """
    runner = opened(box, data.problem, source)
    if isinstance(runner, Failure):
        return Stressed(uncompiled(data.problem, name, runner, box), 0.0)
    begun, interrupted, lock = time.monotonic(), False, lock or MeasureLock()
    run, series = _Run(data, runner, box, begun + seconds), fresh.series()
    try:
        while not run.over(()):
            with lock.judging():
                run.some(series)
            if on_cases:
                on_cases(run.cases, time.monotonic() - begun)
    except KeyboardInterrupt:
        interrupted = True
    result = run.result(name, [group.name for group in fresh.groups])
    return Stressed(result, time.monotonic() - begun, run.cases, interrupted, run.broken, runner)


class _Run:
    """A stress under way, until that time."""

    def __init__(self, data: ProblemData, runner: Runner, box: Box, end: float) -> None:
        self.cases = 0
        self.broken: Broken | None = None
        self._data, self._runner, self._box, self._end = data, runner, box, end
        self._usage = Usage()
        self._totals: dict[str, GroupResult] = {}  # what the groups have come to so far
        self._failure: Failure | None = None
        self._at_once = 1

    def some(self, series: Iterator[GroupData]) -> None:
        """Judge the next few series."""
        begun, few = time.monotonic(), [*islice(series, self._at_once)]
        runs = [GroupRun(self._data, each, self._runner) for each in few]
        Judging(self._runner, self._box, Budget(self._data.problem, lambda: self.over(runs))).run(runs)
        for each, run in zip(few, runs, strict=True):
            if run.ended or (run.failure and not run.given_up):
                self._count(each, run)
        took = time.monotonic() - begun
        if took < _SHORT:
            self._at_once = min(2 * self._at_once, MOST_SERIES)
        elif took > _LONG:
            self._at_once = max(1, self._at_once // 2)

    def _count(self, series: GroupData, run: GroupRun) -> None:
        """Count a series that was judged to its end, or until something broke."""
        name, more = series.group.name, run.result()
        total = self._totals.get(name) or GroupResult(name=name, verdict=Verdict.AC, cases=0, passed=0)
        first = 0  # of a program that broke, the case that it broke at
        if run.failure:
            first = run.failure.case or 0
            if self.broken is None:
                self.broken = Broken(series, run.failure)
                self._failure = replace(run.failure, case=total.cases + first if first else None)
        reached = max(run.reached, first)
        self._totals[name] = replace(
            total,
            verdict=more.verdict if total.verdict is Verdict.AC else total.verdict,
            cases=total.cases + reached,
            passed=total.passed + more.passed,
            worst_ulps=max(filter(None, (total.worst_ulps, more.worst_ulps)), default=more.worst_ulps),
            cpu_seconds=total.cpu_seconds + more.cpu_seconds,
        )
        self.cases += reached
        self._usage += run.usage

    def over(self, runs: Sequence[GroupRun]) -> bool:
        """Whether something broke, in these or before, or the time is up; a first case is always judged."""
        if self.broken is not None or any(run.failure for run in runs):
            return True
        judged = self.cases > 0 or any(run.ended for run in runs)
        return judged and time.monotonic() >= self._end

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
