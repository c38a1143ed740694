"""The ways to run a submission behind one interface, and what comes back.

Judging, races, stress, the search for the smallest case and `judge.testing` all go through a `Runner`: they
need not know whether a case is a call, a line of standard input or a run of its own.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

from msgspec import Struct
from msgspec.structs import replace

from judge.problem import Case, Problem, TimeRule, Verdict
from judge.problem.model import Mode
from judge.run.result import NO_ANSWER, NOTHING, Behaviour, Failure
from judge.sandbox.boundary import Box, Limits, Reply, Stop, Usage
from judge.values import check, show
from judge.values.answers import Target
from judge.values.check import ExactOf, Outcome
from judge.values.wire import Raw

if TYPE_CHECKING:
    from judge.values.outline import Outline

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
OWN_ENDS = (Stop.ANSWERED, Stop.EXCEPTION, Stop.EXITED)  # many a program has an exit status of its own


class Breakdown(NamedTuple):
    """What is wrong with a run as a whole, where no case in particular is to blame.

    `verdict` is what it earns and `detail` says why, for a person. It is shown at `case` (from 0), with `got`
    in place of an answer; `so_far` says how much of the run there was.
    """

    verdict: Verdict
    detail: str
    case: int
    got: str = NO_ANSWER
    so_far: str = ""


class Replies(NamedTuple):
    """One reply for each case of a series, in order, as far as the run came.

    An answer is what the submission gave: a value in its JSON form, or a line of its output. A call that
    raised or ended its process is a reply too. `stop` is how the process ended, ANSWERED if by itself.
    """

    replies: Sequence[Reply]
    usage: Usage
    stop: Stop = Stop.ANSWERED
    lost: bool = False  # the process was ended by force or in mid-call
    breakdown: Breakdown | None = None
    imported: Usage = Usage()  # what the import took, where that was measured apart from the calls
    printed: bytes = b""  # the beginning of what its calls printed

    @property
    def trouble(self) -> str:
        """The first thing that is not as it should be, for a person; empty where all replies are answers."""
        stopped = next((reply for reply in self.replies if reply.stop is not Stop.ANSWERED), None)
        if stopped is not None:
            return stopped.detail
        return self.breakdown.detail if self.breakdown is not None else ""

    def told(self, detail: str) -> Replies:
        """The same, with another text for how the process ended."""
        if self.breakdown is None:
            return self._replace(replies=[*self.replies[:-1], self.replies[-1]._replace(detail=detail)])
        if self.breakdown.verdict is Verdict.WA:  # which says what was printed
            return self
        return self._replace(breakdown=self.breakdown._replace(detail=detail))


class Runner(Struct, frozen=True):
    """One way to run a submission on cases and to decide what it answers: this one calls its entry function.

    `mode` is its name in results, `language` that of the submission, "" for Python. `calls` says whether a
    case is a call, which a test of one's own can make as well; then it is known which case ended a process.
    `asked` says that a program is what it was to be run as.
    """

    problem: Problem
    language: str = ""
    asked: bool = False
    mode: ClassVar[Mode] = Mode.FUNCTION
    calls: ClassVar[bool] = True

    def ask(self, box: Box, cases: Sequence[Case], limits: Limits) -> Replies:
        """Run the submission on the cases, in a process of its own.

        A call that ends its process is the last one, and to blame.
        """
        result = box.call(self.problem.called, self.problem.calls(cases), limits)
        stop = result.replies[-1].stop if result.replies else Stop.ANSWERED
        lost = stop not in (Stop.ANSWERED, Stop.EXCEPTION)
        return Replies(
            result.replies, result.usage, stop, lost, imported=result.imported, printed=result.printed
        )

    def decide(self, answer: Any, target: Target, exact: ExactOf) -> Outcome:
        """Holds a reply's answer against a target; see `judge.values.check`."""
        return check.check(self.problem.answer, answer, target, exact)

    def wanted(self, target: Target) -> str:
        """The right answer, written as the submission would."""
        return show.wanted(self.problem.answer, target)

    def outline(self, answer: Any) -> Outline:
        """What a wrong answer is, reduced to what tells one mistake from another: its form and numbers."""
        from judge.values import outline  # only after a wrong answer

        return outline.outline(self.problem.answer, answer)

    def raw(self, answer: Any) -> Raw:
        """A reply's answer in its JSON form; None where it holds none."""
        return answer

    def reference(self, rule: TimeRule) -> str | None:
        """The file among the accepted solutions that is run in this way; None where there is none."""
        return rule.function if self.calls else rule.program

    def explained(self, failure: Failure, does: Behaviour = NOTHING) -> Failure:  # noqa: ARG002
        """The failure, with what a person should know of how it was run: each of calls in a row.

        What the submission `does` is all that came of it.
        """
        if not self.problem.methods or failure.input is None:
            return failure
        from judge.run.transcript import transcript  # few problems have methods

        return replace(failure, shown=transcript(self.problem, failure))
