"""Function mode: the submission's entry function is called once for each case."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, ClassVar

from msgspec import Struct

from judge.problem import Case, Problem, TimeRule
from judge.problem.model import Mode
from judge.run.replies import Replies
from judge.run.result import NOTHING, Behaviour, Failure
from judge.sandbox.boundary import Box, CallsResult, Limits, Stop
from judge.values import check, show
from judge.values.answers import Target
from judge.values.check import ExactOf, Outcome
from judge.values.wire import Raw

if TYPE_CHECKING:
    from judge.values.outline import Outline


class FunctionRunner(Struct, frozen=True):
    """Calls the entry function; see `judge.run.runner.Runner`."""

    problem: Problem
    language: str = ""
    mode: ClassVar[Mode] = Mode.FUNCTION
    calls: ClassVar[bool] = True
    tells_where: ClassVar[bool] = True

    def answers(self, box: Box, cases: Sequence[Case], limits: Limits) -> Replies:
        """One series of calls."""
        return _replies(box.call_many(self.problem.entry, self.problem.calls(cases), limits))

    def series(
        self,
        box: Box,
        series: Sequence[Sequence[Case]],
        limits: Limits,
        on_series: Callable[[], None] | None = None,
    ) -> list[Replies]:
        """All series in one process, as far as that goes."""
        calls = [self.problem.calls(cases) for cases in series]
        return [_replies(each) for each in box.call_series(self.problem.entry, calls, limits, on_series)]

    def timed(self, box: Box, cases: Sequence[Case], limits: Limits) -> Replies:
        """One series of calls between two without any: the module's import, and the end of the process.

        That end takes time too where a large table is given back.
        """
        calls: list[Sequence[Any]] = [[], self.problem.calls(cases), []]
        imported, *called = box.call_series(self.problem.entry, calls, limits)
        if not called:  # it never came so far, or nothing is to be called
            return _replies(imported)
        return _replies(called[0])._replace(imported=imported.usage)

    @property
    def decide(self) -> Callable[[Any, Target, ExactOf], Outcome]:
        """Compares a value that a call returned."""
        return partial(check.check, self.problem.answer)

    def wanted(self, target: Target) -> str:
        """The right answer as Python writes it."""
        return show.wanted(self.problem.answer, target)

    def outline(self, answer: Any) -> Outline:
        """A wrong value's form and numbers."""
        from judge.values import outline  # only after a wrong answer

        return outline.outline(self.problem.answer, answer)

    def raw(self, answer: Any) -> Raw:
        """The value itself."""
        return answer

    def reference(self, rule: TimeRule) -> str | None:
        """The accepted function that is asked."""
        return rule.function

    def explained(self, failure: Failure, does: Behaviour = NOTHING) -> Failure:  # noqa: ARG002
        """As it is: a function is what was asked for."""
        return failure


def _replies(result: CallsResult) -> Replies:
    """The result of a series of calls; a call that ends its process is the last one, and to blame."""
    stop = result.replies[-1].stop if result.replies else Stop.ANSWERED
    lost = stop not in (Stop.ANSWERED, Stop.EXCEPTION)
    return Replies(result.replies, result.usage, stop, lost, printed=result.printed)
