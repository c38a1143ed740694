"""A case of a person's own, answered, and what a submission answered."""

from __future__ import annotations

import re
from typing import Any

from msgspec import Struct

from judge.problem import Case, Group, Problem, Verdict
from judge.problem.model import Mode
from judge.problem.module import Module
from judge.run.result import EntryError
from judge.values import show
from judge.values.answers import Exact, Target

_GAP = re.compile(r"(.*) \(gap (.*)\)\..*")  # as judge.geometry.sure writes it


class CaseResult(Struct, frozen=True):
    """What a submission answered: its answer in words, and why it is rejected if it is.

    `given` is the answer itself in its JSON form, where it is short. `mode` is None where nothing could be
    run. `printed` is what a function printed meanwhile, or a dialogue; `hurdle` keeps the file from running.
    """

    submission: str
    verdict: Verdict
    got: str
    message: str
    isolation: str
    mode: Mode | None = None
    given: Any = None
    printed: str = ""
    hurdle: EntryError | None = None


class OneCase(Struct, frozen=True):
    """A case with its exact answer, and what a submission said to it, if one was asked.

    `group` is the test group whose tolerance holds, `broken` says which promise the case breaks.
    """

    problem: Problem
    case: Case
    group: Group
    exact: Exact
    target: Target
    module: Module
    said: CaseResult | None = None
    broken: str = ""

    @property
    def no_case(self) -> str:
        """Why it is no case of the kata; nothing for one that is."""
        if found := _GAP.fullmatch(self.broken):
            return f"{found[1]}. No case of this kata: the gap is {found[2]}."
        return f"No case of this kata: {self.broken[:1].lower()}{self.broken[1:]}" if self.broken else ""

    @property
    def expected(self) -> str:
        """The right answer as a person would write it, its numbers correctly rounded."""
        return show.wanted(self.problem.answer, self.target)

    @property
    def failed(self) -> CaseResult | None:
        """What was said, where that is not accepted."""
        return self.said if self.said and self.said.verdict is not Verdict.AC else None
