"""What programs take for a case, side by side, in any languages: the median of some rounds.

A case's time is the slope between one pass over the cases and as many as take long enough: neither the start
of a language nor its first pass is in it. Ratios are taken within a round, where the machine has one speed.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import ExitStack
from operator import truediv
from statistics import median

from msgspec import Struct

from judge.data import ProblemData
from judge.errors import JudgeError
from judge.problem import Case, Problem
from judge.run.alone import MeasureLock
from judge.run.execute import opened
from judge.run.foreign import course, passes_for
from judge.run.result import Failure, Taken
from judge.sandbox.boundary import Box, BoxFactory, Limits

_LONG_SECONDS = 0.3  # of CPU time beyond the first pass
_WARM_SECONDS = 1.0  # the same, where a compiler at run time has to warm up first
_MOST_CASES = 400
_CPU_SECONDS, _WALL_SECONDS, _OUTPUT_BYTES = 60.0, 300.0, 64 << 20


class TimedProgram(Struct, frozen=True):
    """A program to measure: the name of its file and its source.

    `missing` says why its language cannot be run here, `warms` that it is compiled while it runs.
    """

    name: str
    source: bytes
    missing: str = ""
    warms: bool = False


def measure(
    data: ProblemData,
    programs: Sequence[TimedProgram],
    open_box: BoxFactory,
    rounds: int,
    tell: Callable[[int, int], None] | None = None,
) -> list[Taken]:
    """What each program takes on a sample of the cases; `tell` hears how many turns of how many are over."""
    groups = [each for each in data.groups if each.group.size is None] or data.groups
    cases = [case for group in groups for case in group.cases]
    cases = cases[:: 1 + (len(cases) - 1) // _MOST_CASES]
    slopes: list[list[float]] = [[] for _ in programs]
    ready: dict[int, _Slope] = {}
    why_not = {at: each.missing for at, each in enumerate(programs) if each.missing}
    lock, turns, done = MeasureLock(), (rounds + 1) * len(programs), 0
    with ExitStack() as stack:
        for turn in range(rounds + 1):
            with lock.measuring() if turn else lock.judging():
                for at, program in enumerate(programs):
                    try:
                        if not turn and not program.missing:
                            box = stack.enter_context(open_box(program.source, program.name))
                            ready[at] = _Slope(data.problem, program, box, cases)
                        elif at in ready:
                            slopes[at].append(ready[at].seconds())
                    except JudgeError as fault:
                        why_not[at] = str(fault)
                        ready.pop(at, None)
                    done += 1
                    if tell:
                        tell(done, turns)
    first = slopes[0] if 0 in ready else []
    return [
        Taken(why_not=why_not[at])
        if at in why_not
        else Taken(median(own), median(map(truediv, own, first)) if first else None)
        for at, own in enumerate(slopes)
    ]


class _Slope:
    """One program, and how many passes are long enough; raises JudgeError where it does not end well."""

    def __init__(self, problem: Problem, program: TimedProgram, box: Box, cases: Sequence[Case]) -> None:
        runner = opened(box, problem, program.source)
        if isinstance(runner, Failure):
            raise JudgeError(f"does not compile: {runner.message}")
        memory, items = problem.limits.memory_bytes, problem.answer.items
        self._limits = Limits(_CPU_SECONDS, _WALL_SECONDS, memory, _OUTPUT_BYTES, items=items)
        self._course, self._count = course(runner, box, cases), len(cases)
        once = self._lap(1)
        enough = _WARM_SECONDS if program.warms else _LONG_SECONDS
        more = max(self._course.most - 1, 1)
        self._more, _ = passes_for(enough, lambda passes: self._lap(1 + passes) - once, more)

    def _lap(self, passes: int) -> float:
        lap = self._course.run(passes, self._limits)
        if lap.trouble:
            raise JudgeError(f"stopped: {lap.trouble}")
        return lap.usage.cpu_seconds

    def seconds(self) -> float:
        """CPU seconds of one case, measured now."""
        return max(self._lap(1 + self._more) - self._lap(1), 1e-12) / (self._more * self._count)
