"""A case of a person's own, answered, and what a submission answered."""

from __future__ import annotations

from typing import Any

from msgspec import Struct

from judge.data.load import ProblemData
from judge.problem import Case, Group, Problem, Verdict
from judge.problem.model import Mode
from judge.run.result import Hurdle
from judge.values import show
from judge.values.answers import Exact, Target


class Tried(Struct, frozen=True):
    """A valid case with its exact answer; `group` is the test group whose tolerance holds."""

    problem: Problem
    case: Case
    group: Group
    exact: Exact
    target: Target
    data: ProblemData

    @property
    def expected(self) -> str:
        """The right answer as a person would write it, its numbers correctly rounded."""
        return show.wanted(self.problem.answer, self.target)


class Said(Struct, frozen=True):
    """What the submission `name` answered: its answer in words, and why it is rejected if it is.

    `given` is the answer itself in its JSON form; None where there is none. `mode` is None where nothing
    could be run. `printed` is what a function printed meanwhile, `hurdle` what keeps the file from running.
    """

    name: str
    verdict: Verdict
    got: str
    message: str
    isolation: str
    mode: Mode | None = None
    given: Any = None
    printed: str = ""
    hurdle: Hurdle | None = None


class Hacked(Struct, frozen=True):
    """What came of a case that was to break a wrong program; `why` says why it does not, or is empty.

    `tried` and `said` are None where the case is invalid. `notes` are sentences for the person.
    """

    why: str
    tried: Tried | None = None
    said: Said | None = None
    notes: tuple[str, ...] = ()
