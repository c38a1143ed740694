"""Function mode: the submission's entry function is called once for each case."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, ClassVar

from msgspec import Struct

from judge.problem import Case, Problem, TimeRule
from judge.run.replies import Replies
from judge.run.result import Failure, Mode
from judge.sandbox.boundary import Box, CallsResult, Limits, Stop

if TYPE_CHECKING:
    from judge.compare.check import Exact, Outcome
    from judge.compare.outline import Outline
    from judge.compare.targets import AnyTarget


class FunctionRunner(Struct, frozen=True):
    """Calls the entry function; see `judge.run.runner.Runner`."""

    problem: Problem
    mode: ClassVar[Mode] = Mode.FUNCTION
    calls: ClassVar[bool] = True
    tells_where: ClassVar[bool] = True

    def answers(self, box: Box, cases: Sequence[Case], limits: Limits) -> Replies:
        """One series of calls."""
        return _replies(box.call_many(self.problem.entry, cases, limits))

    def series(
        self,
        box: Box,
        series: Sequence[Sequence[Case]],
        limits: Limits,
        on_series: Callable[[], None] | None = None,
    ) -> list[Replies]:
        """All series in one process, as far as that goes."""
        return [_replies(each) for each in box.call_series(self.problem.entry, series, limits, on_series)]

    @property
    def decide(self) -> Callable[[Any, AnyTarget, Exact], Outcome]:
        """Compares a value that a call returned."""
        from judge.compare.check import check  # late, as all comparing: a box boots meanwhile

        return partial(check, self.problem.answer)

    def wanted(self, target: AnyTarget) -> str:
        """The right answer as Python writes it."""
        from judge.compare.check import wanted_text

        return wanted_text(target)

    def outline(self, answer: Any) -> Outline:
        """A wrong value's form and numbers."""
        from judge.compare.outline import outline

        return outline(self.problem.answer, answer)

    def reference(self, rule: TimeRule) -> str | None:
        """The accepted function that sets the time limit."""
        return rule.function

    def explained(self, failure: Failure) -> Failure:
        """As it is: a function is what was asked for."""
        return failure


def _replies(result: CallsResult) -> Replies:
    """The result of a series of calls; a call that ends its process is the last one, and to blame."""
    stop = result.replies[-1].stop if result.replies else Stop.ANSWERED
    lost = stop not in (Stop.ANSWERED, Stop.EXCEPTION)
    return Replies(result.replies, result.usage, stop, lost)
