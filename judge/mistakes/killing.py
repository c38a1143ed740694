"""Which wrong programs of a problem some cases of a person's own tell from right ones.

    jury = Jury(problem, {"ends": ["no-clamp", "open-interval"]})
    jury.why_not([case, …], "ends")         None, or why they do not do

The wrong programs are the puzzles of `judge hack`, one for each mistake, but for those that are files: those
are not trusted, and here they are called. Each case is proved before anything is called with it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property, lru_cache, partial
from typing import Any

from judge.data.build import target_of, validate
from judge.errors import ProblemError
from judge.mistakes.computed import ComputedProgram, entry_of
from judge.mistakes.puzzles import WrongProgram, read_puzzles
from judge.problem import Case, Problem
from judge.problem.declare import InvalidCase
from judge.problem.model import tupled
from judge.problem.module import load_module
from judge.sandbox.encode import encode
from judge.values.check import is_right

ENOUGH = 0.9  # of a family's wrong programs
_TOLD = 3  # of those that live, which are named


class Jury:
    """Judges lists of cases of one problem; `families` has mistakes by a name of the caller's.

    Raises ProblemError where a family names a mistake that has no trusted program.
    """

    def __init__(self, problem: Problem, families: Mapping[str, Sequence[str]]) -> None:
        self._problem = problem
        self._families = families
        self._killed = lru_cache(maxsize=64)(self._find_killed)

    def why_not(self, cases: Sequence[Any], family: str) -> str | None:
        """Why the cases do not do: one is none of the problem's, or they let too many programs live.

        Where `family` names no family, they need only be cases.
        """
        if not cases:
            return "no case is given"
        tupled_cases: list[Case] = [self._problem.kept(tupled(case)) for case in cases]
        for place, case in enumerate(tupled_cases, 1):
            try:
                validate(self._problem, self._module, case)
            except InvalidCase as fault:
                return f"case {place} is not a case of {self._problem.id}: {fault}"
        wanted = self._families.get(family, ())
        killed = self.killed(tupled_cases)
        living = [name for name in wanted if name not in killed]
        least = int(ENOUGH * len(wanted) + 0.5)
        if len(wanted) - len(living) >= least:
            return None
        named = ", ".join(living[:_TOLD]) + (", …" if len(living) > _TOLD else "")
        return (
            f"{len(wanted) - len(living)} of {len(wanted)} wrong programs found out, "
            f"{least} needed; not {named}"
        )

    def killed(self, cases: Sequence[Case]) -> frozenset[str]:
        """The mistakes whose program answers one of the cases, all of which are proved, wrongly."""
        return self._killed(tuple(cases), tuple(map(repr, cases)))  # 1 and 1.0 are two cases

    def _find_killed(self, cases: tuple[Case, ...], _shown: tuple[str, ...]) -> frozenset[str]:
        return frozenset(name for name in self._programs if any(self._kills(case, name) for case in cases))

    def _kills(self, case: Case, name: str) -> bool:
        puzzle, function = self._programs[name]
        answer = self._solved(case, repr(case))
        tolerance = puzzle.group.tolerance
        target = target_of(self._problem, answer, tolerance)
        (given,) = self._problem.calls([case])
        try:
            raw = encode(function(*given))
        except Exception:  # as a submission's would be, a wrong answer
            return True
        return not is_right(self._problem.answer, raw, target, partial(_pair, answer, tolerance))

    @cached_property
    def _programs(self) -> Mapping[str, tuple[WrongProgram, Any]]:
        problem = self._problem
        puzzles = {each.mistake: each for each in read_puzzles(problem) if each.trusted and not each.special}
        for names in self._families.values():
            for name in names:
                if name not in puzzles:
                    what = f"{problem.id} has no wrong program {name!r} that could be called here"
                    raise ProblemError(what, remedy="take it out of the families")
        wanted = dict.fromkeys(name for names in self._families.values() for name in names)
        return {
            name: (
                puzzles[name],
                entry_of(problem, ComputedProgram(puzzles[name].source, name, trusted=True)),
            )
            for name in wanted
        }

    @cached_property
    def _module(self) -> Any:
        return load_module(self._problem)

    @cached_property
    def _solved(self) -> Any:
        @lru_cache(maxsize=64)
        def solved(case: Case, _shown: str) -> Any:
            return self._module.solve(*case)

        return solved


def _pair(answer: Any, tolerance: Any) -> tuple[Any, Any]:
    return answer, tolerance
