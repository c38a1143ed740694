"""What start, hint and solution say: frozen structs, whose field names are the JSON's keys."""

from __future__ import annotations

from typing import ClassVar

from msgspec import Struct

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


class ApproachRow(Struct, frozen=True):
    """An approach, by its name and by what `judge solution` calls it; what it takes, if measured."""

    name: str
    call: str
    file: str
    language: str
    about: str
    taken: Taken | None


class Yours(Struct, frozen=True):
    """The latest run of the person's own that solved the kata, and what it takes."""

    run: int
    file: str
    taken: Taken | None


class SolutionShown(Published, frozen=True, kw_only=True):
    """A model solution and all approaches; `code` is the id of its language."""

    problem: str
    file: str
    language: str
    code: str
    idea: str
    explanation: str
    program: str
    approaches: tuple[ApproachRow, ...]
    yours: Yours | None
    paged: ClassVar[bool] = True  # longer than most terminals
