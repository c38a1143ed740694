"""What `judge try` and `judge hack` return: the values that are shown, and the lines of their JSON."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from msgspec import Struct

from judge.data.parse import line_of
from judge.diagnose.replay import encode
from judge.errors import ExitCode
from judge.mistakes.puzzles import Puzzle
from judge.practice.progress import HackState
from judge.problem import Problem, Verdict
from judge.problem.model import Mode
from judge.published import Published
from judge.report.views import copied
from judge.run.tried import Said, Tried
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


class SaidRow(Struct, frozen=True):
    """What a submission answered to it; `mode` is null where nothing could be run."""

    submission: str
    mode: Mode | None
    verdict: Verdict
    got: str
    message: str
    printed: str
    isolation: str | None


class CaseLine(Published, frozen=True, kw_only=True):
    """A case that was tried; `said` is null where no file was."""

    schema: int = 2
    problem: str
    case: CaseRow
    said: SaidRow | None


class PageWritten(Published, frozen=True):
    """A file that was written: a page, a picture or a test."""

    problem: str
    file: str


class HackLine(Published, frozen=True, kw_only=True):
    """A wrong program; `outcome` is shown, won, lost or given-up. What names its mistake is null before."""

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
    said: SaidRow | None


class HackProgram(Struct, frozen=True):
    """How a wrong program stands: open, broken or given-up; `mistake` is null while it is open."""

    number: int
    state: HackState
    mistake: str | None


class HackList(Published, frozen=True):
    """All wrong programs of a kata."""

    problem: str
    programs: tuple[HackProgram, ...]


class CaseTried(Struct, frozen=True):
    """A case, its answer, and what a file answered."""

    tried: Tried
    said: Said | None

    @property
    def exit_code(self) -> ExitCode:
        """NOT_ACCEPTED where the file's answer is rejected."""
        accepted = self.said is None or self.said.verdict is Verdict.AC
        return ExitCode.ACCEPTED if accepted else ExitCode.NOT_ACCEPTED

    @property
    def published(self) -> tuple[CaseLine]:
        """The line of JSON."""
        return (CaseLine(problem=self.tried.problem.id, case=_case(self.tried), said=_said(self.said)),)


class HackTurn(Struct, frozen=True):
    """A wrong program that is shown, attacked or given up, among all those of the kata; or these are listed.

    `states` is by mistake. `why` says why a case does not break it. With `goes_on` a terminal asks for more.
    """

    problem: Problem
    puzzles: tuple[Puzzle, ...]
    states: Mapping[str, HackState]
    puzzle: Puzzle
    outcome: str
    why: str = ""
    tried: Tried | None = None
    said: Said | None = None
    goes_on: bool = False

    @property
    def done(self) -> int:
        """How many are broken."""
        return [*self.states.values()].count(HackState.BROKEN)

    @property
    def following(self) -> Puzzle | None:
        """The first that is open, or else that was given up; None where all are broken."""
        order = (HackState.OPEN, HackState.GIVEN_UP)
        found = (each for state in order for each in self.puzzles if self.states[each.mistake] is state)
        return next(found, None)

    @property
    def exit_code(self) -> ExitCode:
        """NOT_ACCEPTED where it is not broken, and nothing more is asked."""
        ended = self.outcome in ("lost", "given-up") and not self.goes_on
        return ExitCode.NOT_ACCEPTED if ended else ExitCode.ACCEPTED

    @property
    def published(self) -> tuple[HackLine | HackList]:
        """The line of JSON."""
        if self.outcome == "listed":
            rows = ((each, self.states[each.mistake]) for each in self.puzzles)
            programs = (
                HackProgram(each.number, state, None if state is HackState.OPEN else each.mistake)
                for each, state in rows
            )
            return (HackList(self.problem.id, tuple(programs)),)
        state = self.states[self.puzzle.mistake]
        told = state is not HackState.OPEN
        line = HackLine(
            problem=self.problem.id,
            number=self.puzzle.number,
            outcome=self.outcome,
            state=state,
            why=self.why,
            mistake=self.puzzle.mistake if told else None,
            advice=self.puzzle.advice if told else None,
            source=self.puzzle.source.decode(),
            case=_case(self.tried) if self.tried else None,
            said=_said(self.said),
        )
        return (line,)


def _case(tried: Tried) -> CaseRow:
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


def _said(said: Said | None) -> SaidRow | None:
    return copied(SaidRow, said, submission=said.name, isolation=said.isolation or None) if said else None
