"""The race of a submission in another language than Python.

It is held to the reference in its own language where there is one, else to Python's, generously. Both make as
many passes over the cases as take the reference a tenth of a second beyond its start, which is measured in
every turn and taken off; the submission makes fewer where that is long enough too. Times are given for the
reference's passes, so that they compare.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from judge.errors import JudgeError
from judge.languages import NAME as PYTHON
from judge.problem import TimeRule
from judge.run.group import GroupRun
from judge.run.groups import Judging
from judge.run.laps import course, more_passes, passes_for
from judge.run.program import ProgramRunner
from judge.run.runner import Replies, Runner
from judge.run.settings import Reference
from judge.run.timing import CLEARLY_BELOW, Against, Race, exactly
from judge.sandbox.boundary import Box, Limits

LONG_SECONDS = 0.1  # of CPU time beyond the start, for the reference's turn
_LONG_ENOUGH_SECONDS = 0.5  # for the submission's
_COLD_SECONDS = 0.05  # of a first pass: what is less may be mostly the start's own noise
_NOISE_SECONDS = 0.005  # by which two starts of one language may differ
_CPU_SECONDS = 6.0  # that a turn may take at least
_PATIENCE = 4.0  # times the CPU time, by the clock
_READING = 2.0  # times Python's limit, for a program that is held to a function, which reads nothing


class Opponent(NamedTuple):
    """Whom it is raced against, and how; `limit` is in the rival's time."""

    box: Box
    runner: Runner
    against: Against
    limit: float


def rival_of(runner: Runner, rule: TimeRule, reference: Reference, limit: float) -> Opponent | None:
    """The reference for a submission in another language; None where there is none in Python either.

    `limit` is that of the groups, as a multiple of a reference's time.

    Raises JudgeError where the reference does not compile.
    """
    from judge.languages.model import language_called

    problem, language = runner.problem, language_called(runner.language)
    assert language is not None
    box = reference.open(rule.references.get(language.id)) if runner.calls else None
    if box is not None:
        if fault := box.inspect().fault:
            raise JudgeError(f"the reference solution in {language.name} does not compile: {fault.message}")
        if box.inspect().defines(problem.entry):
            return Opponent(box, Runner(problem, language.name), Against(language.name), limit)
    limit *= language.factor
    what = "reference" if runner.calls else "reference program"
    against = Against(PYTHON, f"no {what} in {language.name}: held to Python's")
    box = None if runner.calls else reference.open(rule.program)
    if box is not None:
        return Opponent(box, ProgramRunner(problem), against, limit)
    box = reference.open(rule.function)
    generous = limit if runner.calls else limit * _READING
    return None if box is None else Opponent(box, Runner(problem), against, generous)


class LongRace(Race):
    """A submission and its rival on the cases of some groups, turn by turn, in as many passes as it takes.

    A learner's program that ends badly on several passes, of which nobody told it, has single ones from then
    on. A function's answers are compared in every pass.
    """

    def __init__(self, judging: Judging, runs: Sequence[GroupRun], rival: Opponent) -> None:
        super().__init__(judging, runs, rival.box, rival.limit)
        self.against, self._whose = rival.against, rival.against.language
        self._mine = course(judging.runner, judging.box, self._cases)
        self._theirs = course(rival.runner, rival.box, self._cases)
        self._same = judging.runner.language == rival.runner.language
        self._start = 0.0  # CPU seconds that the rival's language takes to begin, in the turn of now
        self._cold = 0.0  # of the rival's first pass
        self._last = 0.0  # of the rival's latest turn
        self._ready: float | None = None  # that turn, where it was taken while the passes were counted
        self._near = CLEARLY_BELOW * rival.limit
        self._own_passes = 0  # of a turn of the submission; unknown before its first one
        most = min(self._mine.most, self._theirs.most)
        self._begin()
        self.passes, self._ready = passes_for(LONG_SECONDS, self._counted, most)
        self.cases *= self.passes

    def _counted(self, passes: int) -> float:
        took = self._rivals(passes)
        self._cold = took if passes == 1 else self._cold
        return took

    def _begin(self) -> None:
        """Measure the start of now where it is the start of both."""
        if self._same:
            self._start = self._theirs.run(0, self._limits).usage.cpu_seconds

    def _rivals(self, passes: int) -> float:
        cpu, wall = self._limits.cpu_seconds * passes, self._limits.wall_seconds * passes
        lap = self._theirs.run(passes, self._limits._replace(cpu_seconds=cpu, wall_seconds=wall))
        if lap.trouble:
            raise JudgeError(f"the reference solution in {self._whose} cannot be timed: {lap.trouble}")
        self.theirs_took.append(lap.usage)
        self._last = max(0.0, lap.usage.cpu_seconds - self._start)
        return self._last

    def theirs(self) -> float | None:
        """The reference's turn. Raises JudgeError where it does not come to the end of the cases."""
        if self._ready is not None:
            took, self._ready = self._ready, None
            return took
        self._begin()
        return self._rivals(self.passes)

    def mine(self) -> float | None:
        """The submission's turn, as if it were as many passes; None where it is no longer accepted."""
        took = self._turn(self._own_passes) if self._own_passes else self._first_turn()
        return None if took is None else self._scaled(took, self._own_passes)

    def _first_turn(self) -> float | None:
        """A turn that is long enough, or of as many passes as the rival's.

        Who remembers answers makes only the first pass slowly: where that is near the limit by itself, first
        passes are what is raced.
        """
        passes, took = 1, self._turn(1)
        slow = took is not None and took >= _COLD_SECONDS and self._scaled(took, 1) > self._near * self._last
        while took is not None and not slow and not self._own_passes:
            if took >= _LONG_ENOUGH_SECONDS or passes >= self.passes:
                break
            expected = took * self.passes / passes
            more = more_passes(passes, took, _LONG_ENOUGH_SECONDS)
            passes = self.passes if expected <= 2 * _LONG_ENOUGH_SECONDS else min(self.passes, more)
            took = self._turn(passes)
        self._own_passes = self._own_passes or passes
        return took

    def _scaled(self, took: float, passes: int) -> float:
        """What so many passes come to beside the rival's, whose first one is cold as well."""
        if passes == 1 < self.passes:
            took = max(0.0, took - _NOISE_SECONDS)
        cold = max(self._cold, self._last / self.passes, 1e-9)
        later = max(0.0, self._last - cold) / max(1, self.passes - 1)
        return took * self._last / (cold + (passes - 1) * later)

    def _turn(self, passes: int) -> float | None:
        """CPU seconds of so many passes; of a single one, from then on, where it cannot make several."""
        budget = self._judging.budget
        lap = self._mine.run(passes, budget.within(self._within()))
        budget.booked(self._taking(Replies((), lap.usage)))
        alike = self._runner.calls or all(exactly(each) == self._accepted for each in lap.answers)
        if passes > 1 and (lap.trouble or not alike):
            self._own_passes = 1
            return self._turn(1)
        if lap.trouble:
            return self._plainly()
        if not all(self._as_before(each) for each in lap.answers):
            return None
        own = self._start if self._same else self._mine.start
        return max(0.0, lap.usage.cpu_seconds - own)

    def _plainly(self) -> float | None:
        """One pass as when it was judged, so that it is told what has become of which case."""
        replies = self._taking(self._judging.ask(self._cases, self._within()))
        return replies.usage.cpu_seconds if self._as_before(replies) else None

    def _within(self) -> Limits:
        cpu = max(self._limits.cpu_seconds, _CPU_SECONDS)
        wall = max(self._limits.wall_seconds, _PATIENCE * cpu)
        return self._limits._replace(cpu_seconds=cpu, wall_seconds=wall)
