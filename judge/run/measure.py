"""What the timing races: a submission and the reference solution, each in a box, on the same cases."""

from __future__ import annotations

import marshal
from collections.abc import Sequence
from functools import partial

from judge.errors import JudgeError
from judge.problem import Case, Problem, Verdict
from judge.run.group import GroupRun
from judge.run.groups import Judging
from judge.run.runner import VERDICTS, Replies, Runner
from judge.run.timing import Against
from judge.sandbox.boundary import Box, Limits, Stop, Usage
from judge.values.check import Accepted

_MOST_CASES = 400  # in a turn; a sample of the groups' cases where there are more
_MORE_CPU_SECONDS = 1.0  # that a turn may take beyond twice what it took to judge all cases
_MORE_WALL_SECONDS = 4.0
_LONG_WAIT_SECONDS = 1.0  # of all its turns, before there is none after the first
_LONG_IMPORT_SECONDS = 3.0  # of CPU time in the imports of all its turns, the same
_AGAIN = "when it was run again to be timed"


class Race:
    """A submission and the reference on the cases of some groups, turn by turn.

    A turn is some calls, or one program. What a module does when it is imported is the same for all
    cases: it is measured apart, and has no part in the ratio. The submission's answers are compared in every
    turn: one that answers otherwise than before, or not to the end, is no longer accepted, and its group says
    why.

    `limit` is a multiple of the reference's time. `against` says whose that is, where the submission is not
    in Python: such a race needs caution with the start of a language.
    """

    against: Against | None = None

    def __init__(self, judging: Judging, runs: Sequence[GroupRun], rival: Box, limit: float) -> None:
        self.limit = limit
        self.imported = 0.0  # CPU seconds that the submission's import took, the least of all turns
        self.theirs_took: list[Usage] = []  # of the reference's turns, with its language's start
        self._judging = judging
        self._runner = runner = judging.runner
        self._rival = rival
        every = [(run, index) for run in runs for index in range(len(run.cases))]
        self._places = every[:: 1 + (len(every) - 1) // _MOST_CASES]
        self._cases = [run.cases[index] for run, index in self._places]
        self.cases = len(self._cases)  # that a turn of the reference runs
        self._limits = limits = limits_of(runner.problem, runs)
        used = sum((run.usage + run.imported for run in runs), Usage())
        self._tighter = limits._replace(
            cpu_seconds=min(limits.cpu_seconds, 2 * used.cpu_seconds + _MORE_CPU_SECONDS),
            wall_seconds=min(limits.wall_seconds, 2 * used.wall_seconds + _MORE_WALL_SECONDS),
        )
        self._taken = Usage()
        self._importing = 0.0  # CPU seconds of all turns' imports
        self._accepted: bytes | None = None  # the answers that were compared last

    def mine(self) -> float | None:
        """The submission's turn in CPU seconds; None where it is no longer accepted."""
        first = self._taken == Usage()
        replies = self._taking(self._judging.ask(self._cases, self._tighter))
        spent = replies.imported.cpu_seconds
        self.imported = spent if first else min(self.imported, spent)
        self._importing += spent
        return replies.usage.cpu_seconds if self._as_before(replies) else None

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

    def _taking(self, replies: Replies) -> Replies:
        self._taken += replies.usage + replies.imported
        return replies

    def _as_before(self, replies: Replies) -> bool:
        """Whether all answers are accepted as when they were judged; the first that is not is recorded."""
        given = exactly(replies)
        if (given is None or given != self._accepted) and not self._right(replies):
            return False
        self._accepted = given
        return True

    def _right(self, replies: Replies) -> bool:
        for (run, index), reply in zip(self._places, replies.replies, strict=False):
            if reply.stop is not Stop.ANSWERED:
                run.unsteady(index, VERDICTS[reply.stop], f"{reply.detail}, {_AGAIN}")
                return False
            outcome = self._runner.decide(reply.answer, run.targets[index], partial(run.exact, index))
            if not isinstance(outcome, Accepted):
                run.unsteady(index, Verdict.WA, f"{outcome.message}, {_AGAIN}", outcome.got)
                return False
        if replies.breakdown is None and len(replies.replies) == len(self._places):
            return True
        run, index = self._places[min(len(replies.replies), len(self._places) - 1)]
        verdict = replies.breakdown.verdict if replies.breakdown else Verdict.WA
        run.unsteady(index, verdict, f"{replies.trouble or 'it answered no more'}, {_AGAIN}")
        return False


def exactly(replies: Replies) -> bytes | None:
    """The answers as bytes, for 1, 1.0 and True are equal and yet three answers; None if some are missing."""
    return None if replies.trouble else marshal.dumps([reply.answer for reply in replies.replies], 2)


def theirs_on(runner: Runner, rival: Box, cases: Sequence[Case], limits: Limits) -> Usage:
    """What the reference took. Raises JudgeError where it does not come to the end of the cases."""
    replies = runner.ask(rival, cases, limits)
    if replies.trouble:
        raise JudgeError(f"the reference solution cannot be timed: {replies.trouble}")
    return replies.usage


def time_limit(problem: Problem, runs: Sequence[GroupRun]) -> float:
    """The limit of the groups that are raced together, as a multiple of the reference's time."""
    assert problem.time is not None
    own = runs[0].group.time_limit if len(runs) == 1 else None
    return problem.time.limit if own is None else own


def limits_of(problem: Problem, runs: Sequence[GroupRun]) -> Limits:
    """The bounds of all groups together."""
    each = [problem.limits_of(run.group) for run in runs]
    return Limits(
        sum(limits.cpu_seconds for limits in each),
        sum(limits.wall_seconds for limits in each),
        problem.limits.memory_bytes,
        sum(limits.output_bytes for limits in each),
        items=problem.answer.items,
    )
