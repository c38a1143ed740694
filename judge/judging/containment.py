"""The boxes that submissions to one problem are judged in: opened early, hidden from, and shared."""

from __future__ import annotations

from judge.data.cache import cache_folder
from judge.problem import Problem
from judge.run.reference import Reference
from judge.sandbox import Boxes
from judge.sandbox.boundary import Box, BoxFactory

WEAK = "isolation is 'limits': submissions can read your files and use the network; see 'judge doctor'"


class Containment:
    """The boxes of one session; a context manager that ends those that were never used.

    The first submission's box boots while the judge still reads its data. `open_box` opens a box at the level
    that was asked for, the best where none was.
    """

    def __init__(self, problem: Problem, level: str | None) -> None:
        hidden = (problem.folder.parent, problem.solutions.parent, cache_folder())
        self.open_box: BoxFactory = Boxes(level, hidden)
        self.reference = Reference(problem, self.open_box)
        self._level = level
        self._ahead: dict[tuple[bytes, str], Box] = {}

    def __enter__(self) -> Containment:
        return self

    def __exit__(self, *exc: object) -> None:
        self.reference.__exit__(*exc)
        for box in self._ahead.values():
            box.__exit__(*exc)

    def boot(self, source: bytes, name: str) -> None:
        """Start the box of a submission that will be judged soon."""
        box = self._ahead[source, name] = self.open_box(source, name)
        box.warm_up()

    def take(self, source: bytes, name: str) -> Box:
        """The submission's box, started ahead or now."""
        return self._ahead.pop((source, name), None) or self.open_box(source, name)

    def notes(self, isolation: str) -> tuple[str, ...]:
        """What is to be said of the level that a submission was held at: that it is weak, unasked for."""
        return (WEAK,) if isolation == "limits" and self._level is None else ()
