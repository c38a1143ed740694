"""What the setter's gate says: broken promises, and what became of solutions and mistakes."""

from __future__ import annotations

from collections.abc import Callable

from msgspec import Struct

from judge.errors import ExitCode, JudgeError
from judge.problem import Verdict
from judge.published import Published
from judge.verify.edges import EdgeCoverage

ENOUGH = 5  # cases of one group that should reject a wrong program: fewer may be chance

Progress = Callable[[str, int, int], None]  # what is being done, how much of it, how much in all


class Fault(Struct, frozen=True):
    """One broken promise: what, where and what to do."""

    what: str
    where: str
    remedy: str = ""

    def __str__(self) -> str:
        return f"{self.where}: {self.what}" + (f"; {self.remedy}" if self.remedy else "")


class MistakeReport(Struct, frozen=True):
    """A mistake: its line of mistakes.py, the group that finds it in most cases, and all that find it.

    Of several programs that make it, it is the one that the fewest `cases` of its group reject.
    """

    name: str
    line: str
    group: str
    cases: int
    groups: tuple[str, ...] = ()


class SolutionReport(Struct, frozen=True):
    """One program's verdict, null where it is `unjudged`, and the groups that it `failed`.

    `name` is its first line; it is `ok` where this is the verdict that its folder wants.
    """

    file: str  # as wrong/absolute-epsilon.py
    name: str
    verdict: Verdict | None
    ok: bool
    failed: tuple[str, ...] = ()
    unjudged: str = ""


class Verified(Published, frozen=True):
    """What was checked of a kata, or of the cards of `judge quiz`, and what is wrong.

    `pins` is "matching", "written", "differing" or "missing", and empty where no data were looked at.
    `warnings` are worth a look, and no broken promise.
    """

    problem: str
    faults: tuple[Fault, ...]
    warnings: tuple[Fault, ...] = ()
    groups: int = 0
    cases: int = 0
    cards: int = 0
    pins: str = ""
    solutions: tuple[SolutionReport, ...] = ()
    mistakes: tuple[MistakeReport, ...] = ()
    edges: tuple[EdgeCoverage, ...] = ()

    @property
    def exit_code(self) -> ExitCode:
        """3 where something is wrong."""
        return ExitCode.FAULT if self.faults else ExitCode.ACCEPTED


def fault_of(error: JudgeError, where: str) -> Fault:
    """The error as a fault, of what is at `where` if it does not say itself."""
    return Fault(error.what, error.where or where, error.remedy or "")
