"""Function mode: the submission's entry function is called once for each case."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, ClassVar

from msgspec import Struct
from msgspec.structs import replace

from judge.problem import Case, Problem, TimeRule
from judge.problem.model import Mode
from judge.run.replies import Replies
from judge.run.result import NOTHING, Behaviour, Failure
from judge.sandbox.boundary import Box, Limits, Stop
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

    def ask(self, box: Box, cases: Sequence[Case], limits: Limits) -> Replies:
        """Some calls; one that ends its process is the last one, and to blame."""
        result = box.call(self.problem.called, self.problem.calls(cases), limits)
        stop = result.replies[-1].stop if result.replies else Stop.ANSWERED
        lost = stop not in (Stop.ANSWERED, Stop.EXCEPTION)
        return Replies(
            result.replies, result.usage, stop, lost, imported=result.imported, printed=result.printed
        )

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
        """As it is, for a function is what was asked for; of calls in a row, with each of them."""
        if not self.problem.methods or failure.input is None:
            return failure
        from judge.run.transcript import transcript  # few problems have methods

        return replace(failure, shown=transcript(self.problem, failure))
