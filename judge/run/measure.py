"""What the timing races: a submission and the reference solution, each in a box, on the same cases."""

from __future__ import annotations

from collections.abc import Sequence

from judge.errors import JudgeError
from judge.problem import Case, Problem
from judge.run.again import as_before, exactly, limits_of
from judge.run.budget import Budget
from judge.run.group import GroupRun
from judge.run.reference import Reference, Track
from judge.run.runner import Runner
from judge.sandbox.boundary import Box, Limits, Usage

_MORE_CPU_SECONDS = 1.0  # that a turn may take beyond twice what it took to judge all cases
_MORE_WALL_SECONDS = 4.0
_LONG_WAIT_SECONDS = 1.0  # of all its turns, before there is none after the first
_LONG_IMPORT_SECONDS = 3.0  # of CPU time in the imports of all its turns, the same


class Duel:
    """A submission and the reference on the cases of some groups, turn by turn.

    A turn is some calls, or one program. What a module does when it is imported is the same for all
    cases: it is measured apart, and has no part in the ratio. The submission's answers are compared in every
    turn: one that answers otherwise than before, or not to the end, is no longer accepted, and its group says
    why.
    """

    def __init__(
        self,
        runner: Runner,
        runs: Sequence[GroupRun],
        submission: Box,
        rival: Box,
        track: Track,
        budget: Budget,
    ) -> None:
        self._runner = runner
        self._submission = submission
        self._rival = rival
        self._budget = budget
        self._cases = track.cases
        self._places = [(runs[place], index) for place, index in track.places]
        self._limits = limits = limits_of(runner.problem, runs)
        used = sum((run.usage + run.imported for run in runs), Usage())
        self._tighter = limits._replace(
            cpu_seconds=min(limits.cpu_seconds, 2 * used.cpu_seconds + _MORE_CPU_SECONDS),
            wall_seconds=min(limits.wall_seconds, 2 * used.wall_seconds + _MORE_WALL_SECONDS),
        )
        self.passes = 1
        self._taken = Usage()
        self._importing = 0.0  # CPU seconds of all turns' imports
        self.imported = 0.0  # CPU seconds that the submission's import took, the least of all turns
        self.theirs_took: list[Usage] = []  # of the reference's turns
        self._accepted: bytes | None = None  # the answers that were compared last

    def mine(self) -> float | None:
        """The submission's turn in CPU seconds; None where it is no longer accepted."""
        within = self._budget.within(self._tighter)
        replies = self._budget.booked(self._runner.ask(self._submission, self._cases, within))
        first = self._taken == Usage()
        spent = replies.imported.cpu_seconds
        self.imported = spent if first else min(self.imported, spent)
        self._importing += spent
        self._taken += replies.usage + replies.imported
        given = exactly(replies)
        if (given is None or given != self._accepted) and not as_before(self._runner, replies, self._places):
            return None
        self._accepted = given
        return replies.usage.cpu_seconds

    def theirs(self) -> float | None:
        """The reference's turn. Raises JudgeError where it does not come to the end of the cases."""
        self.theirs_took.append(theirs_on(self._runner, self._rival, self._cases, self._limits))
        return self.theirs_took[-1].cpu_seconds

    def goes_on(self) -> bool:
        """Whether it has not kept the judge waiting, for nothing or for its imports."""
        if self._importing > _LONG_IMPORT_SECONDS:
            return False
        # a busy machine lets it wait too, but hardly for more than twice as long as it works
        return self._taken.waiting_seconds <= _LONG_WAIT_SECONDS + 2 * self._taken.cpu_seconds


def theirs_on(runner: Runner, rival: Box, cases: Sequence[Case], limits: Limits) -> Usage:
    """What the reference took. Raises JudgeError where it does not come to the end of the cases."""
    replies = runner.ask(rival, cases, limits)
    if replies.trouble:
        raise JudgeError(f"the reference solution cannot be timed: {replies.trouble}")
    return replies.usage


def track_of(reference: Reference, runner: Runner, runs: Sequence[GroupRun]) -> Track:
    """What the submission and the reference are raced on."""
    return reference.track(runner.mode.value, [run.group.name for run in runs], [run.cases for run in runs])


def time_limit(problem: Problem, runs: Sequence[GroupRun]) -> float:
    """The limit of the groups that are raced together, as a multiple of the reference's time."""
    assert problem.time is not None
    own = runs[0].group.time_limit if len(runs) == 1 else None
    return problem.time.limit if own is None else own
