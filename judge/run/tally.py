"""A test group while it is being judged: what passed, and the first case that did not."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from judge.problem import Case, Problem, Verdict
from judge.run.result import Failure, GroupResult, Mode
from judge.sandbox import Limits, Stop, Usage
from judge.values import Accepted

if TYPE_CHECKING:
    from judge.data import GroupData, ProblemData
    from judge.problem import Tolerance
    from judge.values import Exact, Outcome, Outline

VERDICTS = {
    Stop.EXCEPTION: Verdict.RTE,
    Stop.EXITED: Verdict.RTE,
    Stop.TAMPERED: Verdict.RTE,
    Stop.CPU: Verdict.TLE,
    Stop.WALL: Verdict.TLE,
    Stop.WAITING: Verdict.TLE,
    Stop.MEMORY: Verdict.MLE,
    Stop.OUTPUT: Verdict.OLE,
}
_EXCEPTION = re.compile(r"[A-Za-z_.]{1,40}")  # the type's name, with which the detail of an exception begins


class Tally:
    """Collects the outcomes of one group's cases, in order, into a `GroupResult` and a `Failure`."""

    def __init__(self, data: ProblemData, group: GroupData, mode: Mode) -> None:
        self.problem: Problem = data.problem
        self.group = group
        self.usage = Usage()
        self.run = False  # whether it was run to its end
        self.given_up = False  # whether none of it was run that says anything
        self.passed = 0
        self.verdict = Verdict.AC
        self.failure: Failure | None = None
        self.reached = 0  # the cases before this one have all been decided
        self.wrong: dict[int, Outline] = {}  # what was given instead of a right answer, by case from 0
        self._data = data
        self._mode = mode
        self._worst: float | None = None

    def exact(self, index: int) -> Callable[[], tuple[Exact, Tolerance]]:
        """What comparing calls if it needs the exact answer of a case."""
        return lambda: self._data.exact(self.group.cases[index], self.group.group)

    def compared(self, index: int, outcome: Outcome, given: Any) -> None:
        """Record what comparing `given`, the answer of a case or its line, came to."""
        if isinstance(outcome, Accepted):
            self.passed += 1
            worst = outcome.worst_ulps
            # An exact 0 has no scale of its own: its error in ulps says nothing, and may not even be finite.
            if worst is not None and math.isfinite(worst):
                self._worst = max(self._worst or 0.0, worst)
            return
        self.wrong[index] = self._outline(given)
        if self.failure is None:
            self.verdict = Verdict.WA
            self.failure = Failure(
                outcome.message,
                self.group.group.name,
                index + 1,
                named_input(self.problem, self.group.cases[index]),
                outcome.wanted,
                outcome.got,
                outcome.where,
                outcome.absolute,
                outcome.relative,
                outcome.ulps,
                self._raw(given),
            )

    def failed(self, index: int, verdict: Verdict, message: str, got: str = "no answer") -> None:
        """Record a case without an answer to compare."""
        self.wrong.setdefault(index, (f"stopped {verdict.value}", ()))
        if self.failure is None:
            self.verdict = verdict
            self.failure = Failure(
                message,
                self.group.group.name,
                index + 1,
                named_input(self.problem, self.group.cases[index]),
                self._wanted(index),
                got,
            )

    def give_up(self, verdict: Verdict, reason: str) -> None:
        """Record that the rest of it is not run, of which nothing is known then."""
        if self.failure is None:
            self.given_up = True
            self.failed(0, verdict, f"not run: {reason}")
            del self.wrong[0]

    def stopped(self, index: int, stop: Stop, detail: str) -> None:
        """Record a case that ended otherwise than with an answer."""
        raised = _EXCEPTION.match(detail) if stop is Stop.EXCEPTION else None
        self.wrong[index] = (f"raised {raised[0]}" if raised else f"stopped {stop.value}", ())
        self.failed(index, VERDICTS[stop], detail)

    def unsteady(self, index: int, verdict: Verdict, message: str, got: str = "no answer") -> None:
        """Record a case that passed, but did not when it was run again."""
        self.passed -= 1
        self.failed(index, verdict, message, got)

    def _outline(self, given: Any) -> Outline:
        answer = self.problem.answer
        return answer.outline(given) if self._mode is Mode.FUNCTION else answer.line_outline(given)

    def _raw(self, given: Any) -> Any:
        """The answer itself; None, too, where a line holds none."""
        if self._mode is Mode.FUNCTION:
            return given
        read = self.problem.answer.read_line(given)
        return None if isinstance(read, str) else read[0]

    def too_slow(self, message: str) -> None:
        """Record that the submission as a whole takes too long, though its answers are right."""
        self.verdict = Verdict.TLE
        self.failure = Failure(message, self.group.group.name)

    def _wanted(self, index: int) -> str:
        answer, target = self.problem.answer, self.group.targets[index]
        return answer.wanted(target) if self._mode is Mode.FUNCTION else answer.line(target)

    @property
    def out_of_time(self) -> bool:
        """Whether its time is used up, whatever else it may have done: filled memory, say."""
        left = group_limits(self.problem, self.usage)
        return not (left.cpu_seconds and left.wall_seconds)

    def result(self) -> GroupResult:
        """The group's outcome; cases that were never run have not passed."""
        group = self.group.group
        return GroupResult(
            group.name,
            self.verdict,
            len(self.group.cases),
            self.passed,
            self._worst,
            self.usage.cpu_seconds,
            group.points,
            self.reached,
            self.wrong,
        )


def named_input(problem: Problem, case: Case) -> dict[str, Any]:
    """A case's arguments by parameter name."""
    return problem.named(case)


def group_limits(problem: Problem, used: Usage) -> Limits:
    """What is left of a group's limits once `used` of its time has gone."""
    limits = problem.limits
    return Limits(
        max(0.0, limits.cpu_seconds - used.cpu_seconds),
        max(0.0, limits.wall_seconds - used.wall_seconds),
        limits.memory_bytes,
        limits.output_bytes,
        items=problem.answer.items,
    )
