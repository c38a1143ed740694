"""A test group while it is being judged: what passed, and the first case that did not."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from judge.data import GroupData, ProblemData
from judge.problem import Case, Group, Problem, Verdict
from judge.run.result import NO_ANSWER, Answers, Failure, GroupResult, short_answer
from judge.run.runner import VERDICTS, Replies
from judge.sandbox.boundary import Limits, Stop, Usage
from judge.values.check import Accepted

if TYPE_CHECKING:
    from judge.problem import Tolerance
    from judge.run.runner import Runner
    from judge.values.answers import Exact
    from judge.values.check import Rejection
    from judge.values.outline import Outline

_ALL_BUT = 0.95  # of a limit, whatever the clocks say of the last milliseconds
_EXCEPTION = re.compile(r"[A-Za-z_.]{1,40}")  # the type's name, with which the detail of an exception begins


class GroupRun:
    """Collects the outcomes of one group's cases, in order, into a `GroupResult` and a `Failure`."""

    def __init__(self, data: ProblemData, group: GroupData, runner: Runner) -> None:
        self.problem: Problem = data.problem
        self.group = group.group
        self.cases = group.cases
        self.targets = group.targets
        self.usage = Usage()
        self.imported = Usage()  # by the longest import that was measured apart
        self.shares = False  # whether the time is a share of what several groups took together
        self.ended = False  # whether nothing more of it is to be run
        self.losses = 0  # calls that have ended their process
        self.given_up = False  # whether none of it was run that says anything
        self.passed = 0
        self.verdict = Verdict.AC
        self.failure: Failure | None = None
        self.reached = 0  # the cases before this one have all been decided
        self.wrong: dict[int, Outline] = {}  # what was given instead of a right answer, by case from 0
        self._data = data
        self._runner = runner
        self._worst: float | None = None

    @property
    def rest(self) -> Sequence[Case]:
        """The cases still to be run: at first the group's own list, which need not be packed again."""
        return self.cases[self.reached :] if self.reached else self.cases

    def exact(self, index: int) -> tuple[Exact, Tolerance]:
        """What a comparison calls if it needs the exact answer of a case."""
        return self._data.exact(self.cases[index], self.group)

    def take(self, replies: Replies) -> None:
        """Decide what came of the next cases, and record it; a breakdown is left to the caller."""
        self.usage += replies.usage
        self.imported = max(self.imported, replies.imported)
        decide, targets, worst, answered = self._runner.decide, self.targets, self._worst, Stop.ANSWERED
        for index, (stop, answer, detail) in enumerate(replies.replies, self.reached):
            if stop is not answered:
                self.stopped(index, stop, detail)
                continue
            outcome = decide(answer, targets[index], partial(self.exact, index))
            if not isinstance(outcome, Accepted):
                self._rejected(index, outcome, answer)
                continue
            self.passed += 1
            ulps = outcome.worst_ulps
            # An exact 0 has no scale of its own: its error in ulps says nothing, and may not even be finite.
            if ulps is not None and (worst is None or ulps > worst) and math.isfinite(ulps):
                worst = ulps
        self._worst = worst
        self.reached += len(replies.replies)

    def _rejected(self, index: int, outcome: Rejection, answer: Any) -> None:
        """Record a wrong answer of a case."""
        self.wrong[index] = self._runner.outline(answer)
        if self.failure is None:
            self.verdict = Verdict.WA
            absolute, relative, ulps = (
                each if each is not None and math.isfinite(each) else None
                for each in (outcome.absolute, outcome.relative, outcome.ulps)
            )
            self.failure = Failure(
                outcome.message,
                self.group.name,
                index + 1,
                self._shown_input(index),
                outcome.wanted,
                outcome.got,
                short_answer(self._runner.raw(answer)),
                where=outcome.where,
                absolute=absolute,
                relative=relative,
                ulps=ulps,
            )

    def failed(self, index: int, verdict: Verdict, message: str, got: str = NO_ANSWER) -> None:
        """Record a case without an answer to compare."""
        self.wrong.setdefault(index, (f"stopped {verdict.value}", ()))
        if self.failure is None:
            self.verdict = verdict
            self.failure = Failure(
                message,
                self.group.name,
                index + 1,
                self._shown_input(index),
                self._runner.wanted(self.targets[index]),
                got,
            )

    def failed_whole(self, verdict: Verdict, message: str) -> None:
        """Record that it fails as a whole: no case is to blame."""
        if self.failure is None:
            self.verdict = verdict
            self.failure = Failure(message, self.group.name)

    def _shown_input(self, index: int) -> dict[str, Any] | None:
        """A case's arguments by name; None for a big case, which nobody could read."""
        return self.problem.named(self.cases[index]) if self.group.size is None else None

    def give_up(self, verdict: Verdict, reason: str) -> None:
        """Record that the rest of it is not run: those cases are undecided."""
        if self.failure is None:
            self.given_up = True
            self.failed(0, verdict, f"not run: {reason}")
            del self.wrong[0]

    def stopped(self, index: int, stop: Stop, detail: str) -> None:
        """Record a case that ended otherwise than with an answer."""
        raised = _EXCEPTION.match(detail) if stop is Stop.EXCEPTION else None
        self.wrong[index] = (f"raised {raised[0]}" if raised else f"stopped {stop.value}", ())
        self.failed(index, VERDICTS[stop], detail)

    def unsteady(self, index: int, verdict: Verdict, message: str, got: str = NO_ANSWER) -> None:
        """Record a case that passed, but did not when it was run again."""
        self.passed -= 1
        self.failed(index, verdict, message, got)

    @property
    def out_of_cpu_time(self) -> bool:
        """Whether it failed because its CPU time, not only the wall clock's, is used up."""
        spent = self.usage.cpu_seconds >= _ALL_BUT * self.problem.limits_of(self.group).cpu_seconds
        return self.verdict is Verdict.TLE and spent

    @property
    def out_of_time(self) -> bool:
        """Whether its time is used up, whatever else it may have done: filled memory, say."""
        left = group_limits(self.problem, self.group, self.usage)
        return not (left.cpu_seconds and left.wall_seconds)

    def result(self) -> GroupResult:
        """The group's outcome; cases that were never run have not passed."""
        return GroupResult(
            name=self.group.name,
            verdict=self.verdict,
            cases=len(self.cases),
            passed=self.passed,
            points=self.group.points,
            level=self.group.level,
            worst_ulps=self._worst,
            cpu_seconds=self.usage.cpu_seconds,
            run=not self.given_up,
            undecided=max(0, len(self.cases) - self.passed - len(self.wrong)),
        )

    @property
    def answers(self) -> Answers:
        """What was answered wrongly so far."""
        return Answers(self.reached, self.wrong)


def one_case(data: ProblemData, group: str, case: int) -> ProblemData:
    """The data with nothing but one case, counted from 0, of the group of that name."""
    (own,) = (each for each in data.groups if each.group.name == group)
    own = replace(own, cases=[own.cases[case]], targets=[own.targets[case]])
    return ProblemData(data.problem, (own,))


def group_limits(problem: Problem, group: Group, used: Usage = Usage()) -> Limits:  # noqa: B008 - a tuple
    """What is left of a group's limits once `used` of its time has gone."""
    own, items = problem.limits_of(group), problem.answer.items
    limits = Limits(own.cpu_seconds, own.wall_seconds, own.memory_bytes, own.output_bytes, items=items)
    return limits_after(limits, used)


def limits_after(limits: Limits, used: Usage, least: float = 0.0) -> Limits:
    """The limits of what comes after this was used; of each time so many seconds are left at `least`."""
    return limits._replace(
        cpu_seconds=max(least, limits.cpu_seconds - used.cpu_seconds),
        wall_seconds=max(least, limits.wall_seconds - used.wall_seconds),
        waiting_seconds=max(least, limits.waiting_seconds - used.waiting_seconds),
    )
