"""What try, hack, drill, quiz and interview return: the values that are shown, the lines of their JSON."""

from __future__ import annotations

from datetime import datetime
from functools import cached_property
from typing import Any

from msgspec import Struct

from judge.data.parse import line_of
from judge.diagnose.replay import encode
from judge.errors import ExitCode
from judge.mistakes.puzzles import WrongProgram
from judge.practice.drill import DrillStep
from judge.practice.events import Answer, Hack
from judge.practice.progress import HackState, hack_states
from judge.practice.quiz import Practise, Topic
from judge.problem import Problem, Verdict
from judge.published import Published
from judge.report.views import copied
from judge.run.tried import CaseResult, OneCase
from judge.values import show


class CaseRow(Struct, frozen=True):
    """A case as arguments and as program input, its exact answer, and which answers are accepted.

    `group` is the test group whose tolerance holds, `expected` the answer in the nearest doubles.
    """

    replay: str
    group: str
    input: dict[str, Any]
    line: str
    exact: Any
    expected: str
    accepted: Any


class CaseLine(Published, frozen=True, kw_only=True):
    """A case that was tried; `said` is null where no file was, `broken` says which promise it breaks."""

    schema: int = 2
    problem: str
    case: CaseRow
    said: CaseResult | None
    broken: str


class PageWritten(Published, frozen=True):
    """A page that was written."""

    problem: str
    file: str


class HackLine(Published, frozen=True, kw_only=True):
    """A wrong program; `outcome` is shown, won, lost or given-up.

    What names its mistake is null before it is broken or given up.
    """

    schema: int = 2
    problem: str
    number: int
    outcome: str
    state: HackState
    why: str
    mistake: str | None
    advice: str | None
    source: str
    case: CaseRow | None
    said: CaseResult | None


class CaseTried(Struct, frozen=True):
    """A case, its answer, and what a file said to it."""

    tried: OneCase

    @property
    def exit_code(self) -> ExitCode:
        """NOT_ACCEPTED where the file's answer is rejected."""
        return ExitCode.NOT_ACCEPTED if self.tried.failed else ExitCode.ACCEPTED

    @property
    def published(self) -> tuple[CaseLine]:
        """The line of JSON."""
        return (copied(CaseLine, self.tried, problem=self.tried.problem.id, case=_row(self.tried)),)


class HackTurn(Struct, frozen=True, dict=True):
    """A wrong program that is shown, attacked or given up, among those of the kata that are asked.

    `hacks` are the attempts at them so far, oldest first. `why` says why a case does not break it. With
    `goes_on` a terminal asks for more. So many `more` programs are asked with `--all`.
    """

    problem: Problem
    puzzles: tuple[WrongProgram, ...]
    hacks: tuple[Hack, ...]
    puzzle: WrongProgram
    outcome: str
    why: str = ""
    tried: OneCase | None = None
    goes_on: bool = False
    more: int = 0

    @cached_property
    def states(self) -> dict[str, HackState]:
        """How each program stands, by its mistake."""
        return hack_states([each.mistake for each in self.puzzles], self.hacks)

    @property
    def done(self) -> int:
        """How many are broken."""
        return [*self.states.values()].count(HackState.BROKEN)

    @property
    def following(self) -> WrongProgram | None:
        """The first that is open, or else that was given up; None where all are broken."""
        wanted = (HackState.OPEN, HackState.GIVEN_UP)
        left = (each for each in self.puzzles if self.states[each.mistake] in wanted)
        return min(left, key=lambda each: wanted.index(self.states[each.mistake]), default=None)

    @property
    def exit_code(self) -> ExitCode:
        """NOT_ACCEPTED where it is not broken, and nothing more is asked."""
        ended = self.outcome in ("lost", "given-up") and not self.goes_on
        return ExitCode.NOT_ACCEPTED if ended else ExitCode.ACCEPTED

    @property
    def published(self) -> tuple[HackLine]:
        """The line of JSON."""
        puzzle, tried = self.puzzle, self.tried
        state = self.states[puzzle.mistake]
        untold = {"mistake": None, "advice": None} if state is HackState.OPEN else {}
        line = copied(
            HackLine,
            puzzle,
            self,
            problem=self.problem.id,
            state=state,
            source=puzzle.source.decode(),
            case=_row(tried) if tried else None,
            said=tried.said if tried else None,
            **untold,
        )
        return (line,)


def _row(tried: OneCase) -> CaseRow:
    problem = tried.problem
    return CaseRow(
        encode(problem, tried.group, tried.case),
        tried.group.name,
        problem.named(tried.case),
        line_of(problem, tried.case),
        show.exact_text(tried.exact),
        tried.expected,
        show.accepted(problem.answer, tried.target),
    )


class Quizzed(Published, frozen=True):
    """How the cards went, and what to practise; `next_due` is told where none was asked."""

    asked: int
    known: int
    answers: tuple[Answer, ...]
    practise: tuple[Practise, ...]
    next_due: datetime | None = None


class Interviewed(Published, frozen=True):
    """How the interview went: the minutes it took, its cards, its kata, and what to practise.

    `verdict` and `score` are null where the file was not judged; `lacking` are skills that it did not show.
    """

    minutes: int
    out_of: int
    asked: int
    known: int
    problem: str
    file: str
    runs: int
    solved: bool
    verdict: Verdict | None
    score: int | None
    mistake: str | None
    lacking: tuple[str, ...]
    practise: tuple[Practise, ...]


class Drill(Published, frozen=True):
    """An evening of practice: how the topics stand, and the commands in their order."""

    time: datetime
    minutes: int
    topics: tuple[Topic, ...]
    steps: tuple[DrillStep, ...]
