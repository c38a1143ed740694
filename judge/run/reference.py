"""The solutions that a submission is raced against, and what the races are run on."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.util import find_spec
from typing import NamedTuple

from judge.errors import UsageError
from judge.problem import Case, Problem
from judge.problem.solutions import accepted_source
from judge.run.timing import Pace
from judge.sandbox.boundary import Box, BoxFactory

MOST_CASES = 400  # in a turn; a sample of the groups' cases where there are more


def check_needs(problem: Problem) -> None:
    """Raise UsageError where a module is not installed that the reference solutions import."""
    for name in problem.time.needs if problem.time else ():
        if find_spec(name) is None:
            raise UsageError(
                f"{problem.id} is timed beside a solution that imports {name}, which is not installed",
                remedy=f"install it where the judge is: pip install {name}",
            )


class Track(NamedTuple):
    """What races are run on: cases by group and index, and what the reference took on them so far."""

    places: list[tuple[int, int]]
    cases: list[Case]
    pace: Pace


class Reference:
    """The solutions that set the time limit, each opened once in a box of its own and raced again and again.

    A context manager, its boxes end with it; one race at a time may use them. The races are all on the same
    data: how long the solutions took on them is remembered.
    """

    def __init__(self, problem: Problem, box_factory: BoxFactory) -> None:
        self._problem = problem
        self._box_factory = box_factory
        self._boxes: dict[str, Box | None] = {}
        self._tracks: dict[tuple[str, ...], Track] = {}

    def __enter__(self) -> Reference:
        return self

    def __exit__(self, *exc: object) -> None:
        self.close()

    def close(self) -> None:
        """End the boxes; the next race opens others."""
        for box in self._boxes.values():
            if box is not None:
                box.__exit__(None, None, None)
        self._boxes.clear()

    def warm_up(self) -> None:
        """Get the one ready that most submissions are raced against: the function, if there is one."""
        rule = self._problem.time
        name = (rule.function or rule.program) if rule else None
        box = self._box(name) if name else None
        if box is not None:
            box.warm_up()

    def open(self, name: str | None) -> Box | None:
        """The box of the solution of that name; None where there is no name or no such file."""
        return self._box(name) if name else None

    def track(self, mode: str, groups: Sequence[str], cases: Sequence[Sequence[Case]]) -> Track:
        """What submissions of that mode are raced on if these are their groups: always the same."""
        key = (mode, *groups)
        if key not in self._tracks:
            places = [(place, index) for place, each in enumerate(cases) for index in range(len(each))]
            chosen = places[:: 1 + (len(places) - 1) // MOST_CASES]
            self._tracks[key] = Track(chosen, [cases[place][index] for place, index in chosen], Pace())
        return self._tracks[key]

    def _box(self, name: str) -> Box | None:
        if name not in self._boxes:
            source = accepted_source(self._problem, name)
            # A box is entered by its first use.
            self._boxes[name] = None if source is None else self._box_factory(source, name)
        return self._boxes[name]
