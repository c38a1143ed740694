"""Fresh cases without end: every group's builder with new parameters, round after round.

    series r.g    group g in round r: BUILT cases drawn from the seed text `seed/r/g`, each of them proved as
                  pinned data

So a series depends on the seed, the round and the group alone, and can be built again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import count
from typing import Any

from msgspec import Struct

from judge.data.build import new_case, target_of
from judge.data.draw import Draw, QuickDraw, RecordedDraw
from judge.data.model import GroupData
from judge.data.validate import Validator
from judge.errors import UsageError
from judge.problem import Case, Group, Problem
from judge.problem.model import EXAMPLES, group_place
from judge.problem.module import Module, blaming
from judge.values.answers import Target

BUILT = 32  # cases of a series: no more than a pinned group has


def _is_fresh(group: Group) -> bool:
    """Whether fresh cases of the group are worth building."""
    return group.name != EXAMPLES and group.size is None


class Series(Struct, frozen=True):
    """One group's cases of one round."""

    round: int
    data: GroupData


class Fresh:
    """The fresh cases of some groups of a problem, from one seed."""

    def __init__(self, problem: Problem, module: Module, groups: Sequence[Group], seed: int) -> None:
        """Raises ProblemError for a builder or parameters that do not exist, UsageError if none is left."""
        self._problem = problem
        self.module = module
        self.seed = seed
        self._validator = Validator(problem, module.solve)
        # The statement's examples are what they are.
        self.groups = tuple(each for each in groups if _is_fresh(each))
        self._builders = [module.draws[group.name] for group in self.groups]
        if not self.groups:
            names = ", ".join(group.name for group in problem.groups if _is_fresh(group))
            raise UsageError(
                "these groups have no fresh cases: the examples are no builder's, big cases take too long",
                remedy=f"name one of {names}",
            )

    def series(self) -> Iterator[Series]:
        """Every group in turn, for ever. Raises ProblemError where the problem's own code fails."""
        for number in count(1):
            for group, builder in zip(self.groups, self._builders, strict=True):
                yield self._series(number, group, builder)

    def choices_of(self, series: Series, place: int) -> tuple[int, ...] | None:
        """The choices that case `place` (from 0) of a series was built from.

        None for a case that its builder did not make alone.
        """
        group = series.data.group
        if group.neighbours:
            return None
        builder = self._builders[self.groups.index(group)]
        draw = RecordedDraw(QuickDraw(self._text(series.round, group)))

        def again(_attempt: int) -> Draw:
            draw.choices.clear()
            return draw

        for _ in range(place + 1):
            new_case(self._problem, group, builder, self._validator, again, 1)
        return tuple(draw.choices)

    def _text(self, number: int, group: Group) -> str:
        return f"{self.seed}/{number}/{group.name}"

    def _series(self, number: int, group: Group, builder: Callable[[Draw], Any]) -> Series:
        seed = self._text(number, group)
        draw = QuickDraw(seed)
        cases: list[Case] = []
        targets: list[Target] = []
        last = None
        what = f"group {group.name!r}: the problem's own code fails on a fresh case"
        with blaming(self._problem, what, lambda: group_place(self._problem, group.name)):
            for place in range(BUILT):
                case, answer = new_case(
                    self._problem, group, builder, self._validator, lambda _: draw, place + 1, (), last
                )
                last = case, answer
                cases.append(case)
                targets.append(target_of(self._problem, answer, group.tolerance))
        return Series(number, GroupData(group, cases, targets))
