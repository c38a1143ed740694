"""All that a problem.py needs of the engine.

    solve(*case) -> answer              exact (judge.values.answers); raises InvalidCase where the case breaks
                                        the statement's promise
    INTERVIEW, PRODUCTION = [...]       the test groups of each level, a row each; GROUPS alone in a kata
                                        without levels
    HOOKS = Hooks(...)                  optional: what the kata's topic draws and makes simpler
    FORMAT = Format(write, read, show)  optional: what a program reads and writes for a case, or
    FORMAT = Format(talk=talk)          how it is talked with; then `solve` answers nothing
    EXAMPLES = [case, ...]              of a kata without entry, in place of the statement's calls

The group of the examples is no row: it comes first.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from msgspec import Struct

from judge.errors import ProblemError
from judge.problem.model import Case, Problem
from judge.values.answers import AnyOf, Judged, Real, Tolerance

if TYPE_CHECKING:
    from judge.drawing import Picture

__all__ = ["AnyOf", "Declared", "Format", "Hooks", "InvalidCase", "Judged", "Real", "Tolerance", "group"]


class Decided(NamedTuple):
    """A decision of `solve`: what it is, and by how much of the size it is clear; 0 where it is exact."""

    what: str
    gap: float


T = TypeVar("T")
_told: list[list[Decided]] = []  # of those who ask, the innermost last
_broken: list[list[str]] = []  # promises, of those who are lenient


@contextmanager
def _heard(all_: list[list[T]]) -> Iterator[list[T]]:
    """What is said inside to the innermost."""
    all_.append([])
    try:
        yield all_[-1]
    finally:
        all_.pop()


def decisions() -> AbstractContextManager[list[Decided]]:
    """The decisions that are made inside, in order."""
    return _heard(_told)


def decided(what: str, gap: float) -> None:
    """Tell of a decision those who ask for them."""
    if _told:
        _told[-1].append(Decided(what, gap))


def lenient() -> AbstractContextManager[list[str]]:
    """Inside, what is nearer than the promise allows is kept, and solved all the same: no InvalidCase."""
    return _heard(_broken)


def refuse(sentence: str) -> None:
    """Raise InvalidCase for a case that is solved like any other; keep it for those who are lenient."""
    if not _broken:
        raise InvalidCase(sentence)
    _broken[-1].append(sentence)


class InvalidCase(Exception):  # noqa: N818 - of the case, not of the program
    """The case breaks the statement's promise; the text says in one sentence how."""


class Shown(Struct, frozen=True):
    """A case and its answers, to be drawn.

    `values` are the arguments by parameter name, `exact` is what the problem's `solve` answers. `wanted` and
    `got` are the two answers in words; `given` is the submission's own, JSON of any shape whatever, and None
    where there is none.
    """

    problem: Problem
    values: Mapping[str, Any]
    exact: Any
    wanted: str | None
    got: str | None
    given: Any | None = None


class Puzzle(Struct, frozen=True):
    """A small figure, and the answer to a question about it.

    Attributes:
        given: the figure in words, a line each: all that is needed for the answer.
        picture: the figure without the answer; None where it cannot be drawn.
        words: what an answer is made of, each with what it means, empty where that is plain.
        answer: the right one; empty for "none".
        one: whether one word is the whole answer.
        why: what makes it so.
    """

    given: tuple[str, ...]
    picture: Picture | None
    words: Mapping[str, str]
    answer: tuple[str, ...]
    one: bool = False
    why: str = ""


Change = Callable[[str, str, tuple[Any, ...]], tuple[Any, ...]]  # (role, name, numbers) -> other numbers


class Hooks(Struct, frozen=True):
    """What a topic adds to the engine, all of it optional.

    Attributes:
        picture: a case drawn, or None where it cannot be.
        simpler: cases that may fail as a case does and are simpler; each is validated before it is tried.
        explore: an HTML page, whole in itself, on which a person moves a case about; it begins with these
            arguments by parameter name, or a usual case. None where the problem has no such page.
        puzzle: a figure for a form of quiz cards, from chance and the problem's `solve`; None for a form
            that it has no figures for.
        figure: the case with other points, directions and lengths in it: what `change` makes of each, which
            is told its role ("point", "end" for a point that a line is given by, "way", "length"), its name
            and its numbers. None where the case has none. So a case is moved, scaled and measured.
    """

    picture: Callable[[Shown], Picture | None] | None = None
    simpler: Callable[[Problem, Case], Iterable[Case]] | None = None
    explore: Callable[[Problem, Mapping[str, Any] | None], str | None] | None = None
    puzzle: Callable[[str, Any, Callable[..., Any]], Puzzle | None] | None = None
    figure: Callable[[Problem, Case, Change], Case | None] | None = None


class Format(Struct, frozen=True):
    """What a program of the kata reads and writes for one case: each case is a run of its own.

    A program that must wait for what it reads next is talked with: `talk` stands alone.

    Attributes:
        write: the input of a case, from its arguments.
        read: the answer in an output, as plain Python; ValueError says for a person why it holds none.
        show: the output of a right answer. Without `read` and `show` the words of the whole output are the
            answer's tokens, whatever the lines.
        talk: called with the program (judge.run.formatted.Talk) and the case's arguments; None where the
            program is right, or else why it is wrong, for a person.
    """

    write: Callable[..., str] | None = None
    read: Callable[[str], Any] | None = None
    show: Callable[[Any], str] | None = None
    talk: Callable[..., str | None] | None = None

    def __post_init__(self) -> None:
        others = [name for name in ("write", "read", "show") if getattr(self, name)]
        if self.talk is not None and others:
            raise ProblemError(f"Format has talk and {others[0]}", remedy="talk stands alone")
        if self.talk is None and self.write is None:
            raise ProblemError("Format has no write", remedy="give write, or talk alone")
        has, lacks = ("show", "read") if self.read is None else ("read", "show")
        if (self.read is None) is not (self.show is None):
            raise ProblemError(f"Format has {has} without {lacks}", remedy="give both, or neither")


class Declared(Struct, frozen=True):
    """A row of problem.py as it was written: what `group` was given, how a case is drawn, and its line."""

    row: Mapping[str, Any]
    draw: Callable[[Any], Case]
    line: int  # from 1


def group(
    name: str,
    about: str,
    draw: Callable[[Any], Case],
    *,
    cases: int | None = None,
    points: int | None = None,
    skills: str | Sequence[str] = (),
    tolerance: Mapping[str, float | Fraction] | None = None,
    limits: Mapping[str, float] | None = None,
    time_limit: float | None = None,
    size: int | None = None,
    turns: bool = False,
) -> Declared:
    """A test group.

    Args:
        name: small letters, digits and hyphens.
        about: what it probes, in one sentence.
        draw: makes a case from choices; `draw.reject()` gives some up, and it is asked again.
        cases: how many; 60, or 120 that take turns, or 12 where each is a run of its own.
        points: of 100; those that no group names are shared evenly, the first groups take the remainder.
        skills: what a run shows that passes every group with the skill; problems/skills.toml explains each.
        tolerance, limits, time_limit: its own, with the keys of problem.toml.
        size: n, where its cases are big: they are built again from their seeds and never shown.
        turns: whether neighbouring cases differ in one parameter, which catches what is kept between calls.
    """
    row = dict(locals())
    del row["draw"]
    if isinstance(skills, str):
        row["skills"] = (skills,)
    return Declared(row, draw, sys._getframe(1).f_lineno)
