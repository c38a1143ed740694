"""The hooks of the katas: a case drawn, made simpler, dragged about, and asked about on a quiz card."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any

from judge.problem import Case, Problem
from judge.problem.declare import Change, Hooks, Puzzle, Shown

if TYPE_CHECKING:
    from judge.data.draw import Draw
    from judge.drawing import Picture


def hooks(kind: str) -> Hooks:
    """The hooks of a kata whose cases are of that kind, a key of `judge.geometry.views.VIEWS`.

    What they need is imported when it is wanted. They ask the `solve` of the problem.py that calls this: it
    is not run again for a picture.
    """
    page = sys._getframe(1).f_globals

    def picture(shown: Shown) -> Picture | None:
        from judge.geometry.picture import compose

        return compose(kind, shown, page["solve"])

    def simpler(problem: Problem, case: Case) -> Iterable[Case]:
        from judge.geometry.simpler import simpler

        return simpler(kind, problem, case)

    def explore(problem: Problem, values: Mapping[str, Any] | None) -> str | None:
        from judge.geometry.explore import explored

        return explored(kind, problem, values, page["solve"])

    def puzzle(form: str, draw: Draw, _solve: Callable[..., Any]) -> Puzzle | None:
        from judge.geometry.puzzle import puzzle

        return puzzle(kind, form, draw)

    def figure(problem: Problem, case: Case, change: Change) -> Case | None:
        from judge.geometry.replaced import replaced

        return replaced(problem, case, change)

    return Hooks(picture, simpler, explore, puzzle, figure)
