"""The two ways to run a submission behind one interface, and which of them a source asks for.

Judging, races, stress, the search for the smallest case and `judge.testing` all go through a `Runner`: they
need not know whether a case is a call or a line of standard input.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Protocol

from judge.problem import Case, Problem, TimeRule
from judge.problem.model import Mode
from judge.run.function import FunctionRunner
from judge.run.replies import Replies
from judge.run.result import NOTHING, Behaviour, Failure
from judge.sandbox.boundary import Box, Inspection, Limits
from judge.values.answers import Target
from judge.values.check import ExactOf, Outcome
from judge.values.wire import Raw

if TYPE_CHECKING:
    from judge.values.outline import Outline


class Runner(Protocol):
    """One way to run a submission on cases and to decide what it answers.

    `mode` is its name in results, `language` that of the submission, "" for Python. `calls` says whether a
    case is a call, which a test of one's own can make as well; then it is known which case ended a process.
    """

    @property
    def problem(self) -> Problem:
        """The problem whose cases they are."""
        ...

    @property
    def mode(self) -> Mode:  # noqa: D102
        ...

    @property
    def language(self) -> str:  # noqa: D102
        ...

    @property
    def calls(self) -> bool:  # noqa: D102
        ...

    def ask(self, box: Box, cases: Sequence[Case], limits: Limits) -> Replies:
        """Run the submission on the cases, in a process of its own."""
        ...

    @property
    def decide(self) -> Callable[[Any, Target, ExactOf], Outcome]:
        """What holds a reply's answer against a target; see `judge.values.check`."""
        ...

    def wanted(self, target: Target) -> str:
        """The right answer, written as the submission would."""
        ...

    def outline(self, answer: Any) -> Outline:
        """What a wrong answer is, reduced to what tells one mistake from another."""
        ...

    def raw(self, answer: Any) -> Raw:
        """A reply's answer in its JSON form; None where it holds none."""
        ...

    def reference(self, rule: TimeRule) -> str | None:
        """The file among the accepted solutions that is run in this way; None where there is none."""
        ...

    def explained(self, failure: Failure, does: Behaviour = NOTHING) -> Failure:
        """The failure, with what a person should know of how it was run; `groups` are all that came of it."""
        ...


def runner_for(problem: Problem, inspection: Inspection, source: bytes, *, program: bool = False) -> Runner:
    """The runner of a source that compiles: its entry function is called if it has one.

    With `program` it is run as a program all the same.
    """
    defined = problem.entry and inspection.defines(problem.entry) and not program
    if defined or (problem.methods and not problem.formatted):
        return FunctionRunner(problem, inspection.language)
    if problem.formatted:
        from judge.run.formatted import FormatRunner  # few problems have a format of their own

        return FormatRunner(problem, inspection.language)
    from judge.run.program import ProgramRunner  # most submissions are functions

    return ProgramRunner(problem, source, inspection.language, asked=program)
