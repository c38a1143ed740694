"""Which wrong programs of a problem some cases of a person's own tell from right ones.

    jury = Jury(problem, {"ends": ["no-clamp", "open-interval"]})
    jury.why_not([case, …], "ends")         None, or why they do not do

The wrong programs are the puzzles of `judge hack`, one for each mistake, but for those that are files: those
are not trusted, and here they are called. Each case is proved before anything is called with it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any

from judge.data.build import target_of, validate
from judge.errors import ProblemError
from judge.mistakes.computed import ComputedProgram, answered, entry_of
from judge.mistakes.puzzles import WrongProgram, read_puzzles
from judge.problem import Case, Problem
from judge.problem.declare import InvalidCase
from judge.problem.model import tupled
from judge.problem.module import load_module
from judge.values.answers import Exact

ENOUGH = 0.9  # of a family's wrong programs
_TOLD = 3  # of those that live, which are named


class Jury:
    """Judges lists of cases of one problem; `families` has mistakes by a name of the caller's.

    Raises ProblemError where a family names a mistake that has no trusted program.
    """

    def __init__(self, problem: Problem, families: Mapping[str, Sequence[str]]) -> None:
        self._problem = problem
        self._families = families
        self._outcomes: dict[tuple[str, str], bool] = {}

    def why_not(self, cases: Sequence[Any], family: str) -> str | None:
        """Why the cases do not do: one is none of the problem's, or they let too many programs live.

        Where `family` names no family, they need only be cases.
        """
        if not cases:
            return "no case is given"
        solved: list[tuple[Case, Exact]] = []
        for place, raw in enumerate(cases, 1):
            case = self._problem.kept(tupled(raw))
            try:
                solved.append((case, validate(self._problem, self._module, case)))
            except InvalidCase as fault:
                return f"case {place} is not a case of {self._problem.id}: {fault}"
        wanted = self._families.get(family, ())
        living = [name for name in wanted if not any(self._kills(*each, name) for each in solved)]
        found, least = len(wanted) - len(living), int(ENOUGH * len(wanted) + 0.5)
        if found >= least:
            return None
        named = ", ".join(living[:_TOLD]) + (", …" if len(living) > _TOLD else "")
        return f"{found} of {len(wanted)} wrong programs found out, {least} needed; not {named}"

    def _kills(self, case: Case, exact: Exact, name: str) -> bool:
        """Whether the mistake's program answers the case wrongly."""
        key = name, repr(case)  # 1 and 1.0 are two cases
        if key not in self._outcomes:
            puzzle, function = self._programs[name]
            tolerance = puzzle.group.tolerance
            target = target_of(self._problem, exact, tolerance)
            outline = answered(self._problem, function, case, target, lambda: (exact, tolerance))
            self._outcomes[key] = outline is not None
        return self._outcomes[key]

    @cached_property
    def _programs(self) -> Mapping[str, tuple[WrongProgram, Callable[..., Any]]]:
        problem = self._problem
        puzzles = {each.mistake: each for each in read_puzzles(problem) if each.trusted and not each.special}
        wanted = dict.fromkeys(name for names in self._families.values() for name in names)
        for name in wanted:
            if name not in puzzles:
                what = f"{problem.id} has no wrong program {name!r} that could be called here"
                raise ProblemError(what, remedy="take it out of the families")
        return {
            name: (puzzles[name], entry_of(problem, ComputedProgram(puzzles[name].source, name)))
            for name in wanted
        }

    @cached_property
    def _module(self) -> Any:
        return load_module(self._problem)
