"""What start, hint and solution say: frozen structs, whose field names are the JSON's keys."""

from __future__ import annotations

from typing import ClassVar

from msgspec import Struct

from judge.practice.solutions import Approach
from judge.published import Published
from judge.run.result import Taken


class Begun(Published, frozen=True):
    """A kata that was started: its file, and whether that was created now, or started over.

    `entry` is the function to write. `kept` is the file that keeps the text of before, or "".
    """

    problem: str
    title: str
    entry: str
    file: str
    created: bool
    kept: str


class HintShown(Published, frozen=True, kw_only=True):
    """Hint `step` of a kata's `steps`, from 1; the text is Markdown."""

    problem: str
    step: int
    steps: int
    title: str
    text: str


class Yours(Struct, frozen=True):
    """The latest run of the person's own that solved the kata, and what it takes."""

    run: int
    file: str
    taken: Taken | None


class SolutionShown(Published, frozen=True, kw_only=True):
    """All approaches; `file` is that of the one that is shown."""

    problem: str
    file: str
    approaches: tuple[Approach, ...]
    yours: Yours | None
    paged: ClassVar[bool] = True  # longer than most terminals

    @property
    def shown(self) -> Approach:
        """The model solution, or the one that was asked for."""
        return next(each for each in self.approaches if each.file == self.file)
