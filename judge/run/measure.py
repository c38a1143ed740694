"""What the timing races: a submission and the reference solution, each in a box, on the same cases."""

from __future__ import annotations

import marshal
from collections.abc import Sequence

from msgspec.structs import replace

from judge.errors import JudgeError
from judge.problem import Problem, Verdict
from judge.run.budget import Budget
from judge.run.group import GroupRun
from judge.run.reference import Reference, Track
from judge.run.replies import VERDICTS, Replies
from judge.run.runner import Runner
from judge.run.timing import Decision, race
from judge.sandbox.boundary import Box, Limits, Stop, Usage
from judge.values import Accepted

_MORE_CPU_SECONDS = 1.0  # that a turn may take beyond twice what it took to judge all cases
_MORE_WALL_SECONDS = 4.0
_LONG_WAIT_SECONDS = 1.0  # of all its turns, before there is none after the first
_LONG_IMPORT_SECONDS = 3.0  # of CPU time in the imports of all its turns, the same
_AGAIN = "when it was run again to be timed"


class Duel:
    """A submission and the reference on the cases of some groups, turn by turn.

    A turn is one series of calls, or one program. What a module does when it is imported is the same for all
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
        self._limits = limits = _limits(runner.problem, runs)
        used = sum((run.usage for run in runs), Usage())
        self._tighter = limits._replace(
            cpu_seconds=min(limits.cpu_seconds, 2 * used.cpu_seconds + _MORE_CPU_SECONDS),
            wall_seconds=min(limits.wall_seconds, 2 * used.wall_seconds + _MORE_WALL_SECONDS),
        )
        self._taken = Usage()
        self._importing = 0.0  # CPU seconds of all turns' imports
        self.imported = 0.0  # CPU seconds that the submission's import took, the least of all turns
        self._accepted: bytes | None = None  # the answers that were compared last

    def mine(self) -> float | None:
        """The submission's turn in CPU seconds; None where it is no longer accepted."""
        within = self._budget.within(self._tighter)
        replies = self._budget.booked(self._runner.timed(self._submission, self._cases, within))
        first = self._taken == Usage()
        spent = replies.imported.cpu_seconds
        self.imported = spent if first else min(self.imported, spent)
        self._importing += spent
        self._taken += replies.usage + replies.imported
        given = _exactly(replies)
        if (given is None or given != self._accepted) and not _as_before(self._runner, replies, self._places):
            return None
        self._accepted = given
        return replies.usage.cpu_seconds

    def theirs(self) -> float | None:
        """The reference's turn. Raises JudgeError where it does not come to the end of the cases."""
        replies = self._runner.timed(self._rival, self._cases, self._limits)
        if replies.trouble:
            raise JudgeError(f"the reference solution cannot be timed: {replies.trouble}")
        return replies.usage.cpu_seconds

    def goes_on(self) -> bool:
        """Whether it has not kept the judge waiting, for nothing or for its imports."""
        if self._importing > _LONG_IMPORT_SECONDS:
            return False
        # a busy machine lets it wait too, but hardly for more than twice as long as it works
        return self._taken.waiting_seconds <= _LONG_WAIT_SECONDS + 2 * self._taken.cpu_seconds


def measure(
    problem: Problem,
    runner: Runner,
    runs: Sequence[GroupRun],
    submission: Box,
    reference: Reference,
    budget: Budget,
) -> Decision:
    """Race a submission and the reference, if there is one, on the cases of accepted groups.

    There is no more racing for a submission that is no longer accepted, nor for one that has kept the judge
    waiting.

    Raises:
        JudgeError: the reference does not come to the end of the cases.
    """
    rival = reference.open(runner.reference(problem.time)) if problem.time else None
    if problem.time is None or rival is None:
        return Decision(None)
    track = track_of(reference, runner, runs)
    duel = Duel(runner, runs, submission, rival, track, budget)
    decision = race(duel.mine, duel.theirs, time_limit(problem, runs), duel.goes_on, track.pace)
    if any(run.verdict is not Verdict.AC for run in runs):
        decision = Decision(decision.ratio)
    return replace(decision, imported=duel.imported)


def track_of(reference: Reference, runner: Runner, runs: Sequence[GroupRun]) -> Track:
    """What the submission and the reference are raced on."""
    return reference.track(runner.mode.value, [run.group.name for run in runs], [run.cases for run in runs])


def time_limit(problem: Problem, runs: Sequence[GroupRun]) -> float:
    """The limit of the groups that are raced together, as a multiple of the reference's time."""
    assert problem.time is not None
    own = runs[0].group.time_limit if len(runs) == 1 else None
    return problem.time.limit if own is None else own


def _exactly(replies: Replies) -> bytes | None:
    """The answers as bytes, for 1, 1.0 and True are equal and yet three answers; None if some are missing."""
    return None if replies.trouble else marshal.dumps([reply.answer for reply in replies.replies], 2)


def _as_before(runner: Runner, replies: Replies, places: Sequence[tuple[GroupRun, int]]) -> bool:
    """Whether all answers are accepted as when they were judged; the first that is not is recorded."""
    for (run, index), reply in zip(places, replies.replies, strict=False):
        if reply.stop is not Stop.ANSWERED:
            run.unsteady(index, VERDICTS[reply.stop], f"{reply.detail}, {_AGAIN}")
            return False
        outcome = runner.decide(reply.answer, run.targets[index], run.exact(index))
        if not isinstance(outcome, Accepted):
            run.unsteady(index, Verdict.WA, f"{outcome.message}, {_AGAIN}", outcome.got)
            return False
    if replies.breakdown is None and len(replies.replies) == len(places):
        return True
    run, index = places[min(len(replies.replies), len(places) - 1)]
    verdict = replies.breakdown.verdict if replies.breakdown else Verdict.WA
    run.unsteady(index, verdict, f"{replies.trouble or 'it answered no more'}, {_AGAIN}")
    return False


def _limits(problem: Problem, runs: Sequence[GroupRun]) -> Limits:
    """The bounds of all groups together."""
    each = [problem.limits_of(run.group) for run in runs]
    return Limits(
        sum(limits.cpu_seconds for limits in each),
        sum(limits.wall_seconds for limits in each),
        problem.limits.memory_bytes,
        sum(limits.output_bytes for limits in each),
        items=problem.answer.items,
    )
