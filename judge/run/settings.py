"""How to judge, whatever is judged, and the solutions that a submission is raced against."""

from __future__ import annotations

from contextlib import AbstractContextManager
from importlib.util import find_spec

from msgspec import Struct, field

from judge.data import Progress as Progress
from judge.errors import UsageError
from judge.problem import Problem
from judge.problem.solutions import accepted_source
from judge.run.alone import MeasureLock
from judge.sandbox.boundary import Box, BoxFactory
from judge.sandbox.factory import Containment


def check_needs(problem: Problem) -> None:
    """Raise UsageError where a module is not installed that the reference solutions import."""
    for name in problem.time.needs if problem.time else ():
        if find_spec(name) is None:
            raise UsageError(
                f"{problem.id} is timed beside a solution that imports {name}, which is not installed",
                remedy=f"install it where the judge is: pip install {name}",
            )


class Reference(AbstractContextManager["Reference"]):
    """The solutions that set the time limit, each opened once in a box of its own and raced again and again.

    A context manager, its boxes end with it; one race at a time may use them.
    """

    def __init__(self, problem: Problem, box_factory: BoxFactory) -> None:
        self._problem = problem
        self._box_factory = box_factory
        self._boxes: dict[str, Box | None] = {}

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
        self.open((rule.function or rule.program) if rule else None)

    def open(self, name: str | None) -> Box | None:
        """The box of the solution of that name; None where there is no name or no such file."""
        if name and name not in self._boxes:
            source = accepted_source(self._problem, name)
            # A box is entered by its first use.
            self._boxes[name] = None if source is None else self._box_factory(source, name)
        return self._boxes[name] if name else None


class Settings(Struct, frozen=True):
    """How to judge, whatever is judged.

    `box_factory` opens the containment; `measured` says whether an accepted submission is raced against the
    reference, and `lock` keeps races alone; `reference` is there where several submissions share it; a
    `program` is run as one even where it defines the problem's function.
    """

    box_factory: BoxFactory = field(default_factory=Containment)
    measured: bool = True
    lock: MeasureLock = field(default_factory=MeasureLock)
    reference: Reference | None = None
    program: bool = False
