"""What `judge list` and `judge show` say of katas: frozen structs, whose field names are the JSON's keys."""

from __future__ import annotations

from typing import Any

from msgspec import Struct
from msgspec.structs import astuple

from judge.errors import ExitCode
from judge.problem import Group, GrowthRule, Problem
from judge.problem.model import GroupLimits, Listed, Source


class Published(Struct, frozen=True, kw_only=True):
    """One line of a command's JSON; `schema` rises where a key changes its meaning or goes."""

    schema: int = 1


class KataRow(Published, frozen=True):
    """A kata in a list; `stars` is 1 once the interview level is passed, 2 with production."""

    problem: str
    title: str
    tier: str
    summary: str
    entry: str
    groups: int
    cases: int
    points: int
    sets: tuple[str, ...]
    solved: bool
    stars: int


def kata_row(problem: Listed, *, solved: bool, stars: int) -> KataRow:
    """The row of a problem, as far as the person has come with it."""
    return KataRow(
        problem.id,
        problem.title,
        problem.tier.value,
        problem.summary,
        problem.entry,
        groups=len(problem.groups),
        cases=sum(group.count for group in problem.groups),
        points=sum(group.points for group in problem.groups),
        sets=problem.sets,
        solved=solved,
        stars=stars,
    )


class SetRow(Struct, frozen=True):
    """A set of katas: its name, a sentence about it, and the names of its katas in order."""

    name: str
    about: str
    katas: tuple[str, ...]


class KataList(Struct, frozen=True):
    """The sets, the rows of all katas, the set to show and the current kata; a broken kata is in `faults`."""

    sets: tuple[SetRow, ...]
    katas: tuple[KataRow, ...]
    shown: str = ""
    current: str = ""
    todo: bool = False
    whole: bool = False
    faults: int = 0

    @property
    def published(self) -> tuple[KataRow, ...]:
        """The rows of the katas that were asked for."""
        rows = {row.problem: row for row in self.katas}
        asked = next((each.katas for each in self.sets if each.name == self.shown), tuple(rows))
        return tuple(row for name in asked if (row := rows.get(name)) and not (self.todo and row.solved))

    @property
    def exit_code(self) -> ExitCode:
        """3 where a kata cannot be read."""
        return ExitCode.FAULT if self.faults else ExitCode.ACCEPTED


class Allowed(Struct, frozen=True):
    """The limits of a test group, in seconds and bytes."""

    cpu_seconds: float
    wall_seconds: float
    memory_bytes: int
    output_bytes: int


class ParameterRow(Struct, frozen=True):
    """A parameter; the bounds are exact, `n` or `n/d` as text."""

    name: str
    type: str
    low: str
    high: str
    smallest: str
    about: str


class Accuracy(Struct, frozen=True):
    """A tolerance; its parts are exact, `n` or `n/d` as text."""

    extent: str
    relative: str
    zero: str
    ulps: str


class GroupRow(Struct, frozen=True):
    """A test group, with the mistakes that it finds; what it does not have of its own is null."""

    name: str
    about: str
    cases: int
    points: int
    seed: int | str
    tolerance: Accuracy
    kills: tuple[str, ...]
    level: str | None
    size: int | None
    limits: Allowed | None
    time_limit: float | None


class ExampleRow(Struct, frozen=True):
    """A worked example: the arguments by name, and the answer."""

    input: dict[str, Any]
    answer: Any


class KataInFull(Published, frozen=True):
    """A kata, whole."""

    problem: str
    title: str
    tier: str
    summary: str
    entry: str
    answer: str
    parameters: tuple[ParameterRow, ...]
    limits: Allowed
    growth: GrowthRule | None
    groups: tuple[GroupRow, ...]
    examples: tuple[ExampleRow, ...]
    statement: str
    source: Source


class KataShown(Struct, frozen=True):
    """A kata to show: its statement, or what its test groups test."""

    problem: Problem
    groups: bool = False

    @property
    def published(self) -> tuple[KataInFull, ...]:
        """Both, in one object."""
        return (kata_in_full(self.problem),)


def kata_in_full(problem: Problem) -> KataInFull:
    """All that is published of a problem."""
    return KataInFull(
        problem.id,
        problem.title,
        problem.tier.value,
        problem.summary,
        problem.entry,
        str(problem.answer),
        parameters=tuple(
            ParameterRow(*map(str, (each.name, each.type, each.low, each.high, each.smallest, each.about)))
            for each in problem.parameters
        ),
        limits=_allowed(problem.limits),
        growth=problem.growth,
        groups=tuple(map(_group, problem.groups)),
        examples=tuple(ExampleRow(problem.named(each.case), each.wanted) for each in problem.examples),
        statement=problem.statement,
        source=problem.source,
    )


def _group(each: Group) -> GroupRow:
    return GroupRow(
        each.name,
        each.about,
        each.count,
        each.points,
        each.seed,
        tolerance=Accuracy(*map(str, astuple(each.tolerance))),
        kills=each.kills,
        level=each.level.value if each.level else None,
        size=each.size,
        limits=_allowed(each.limits) if each.limits else None,
        time_limit=each.time_limit,
    )


def _allowed(limits: GroupLimits) -> Allowed:
    return Allowed(limits.cpu_seconds, limits.wall_seconds, limits.memory_bytes, limits.output_bytes)


class PageText(Published, frozen=True):
    """A page of the manual, as Markdown."""

    topic: str
    title: str
    text: str


class Mention(Published, frozen=True):
    """A section of the manual that has the words, and its line that has most of them."""

    topic: str
    section: str
    line: str


class Topics(Struct, frozen=True):
    """All pages of the manual, to choose from."""

    published: tuple[PageText, ...]


class PageShown(Struct, frozen=True):
    """One page to read."""

    published: tuple[PageText]
    paged: bool = True


class Mentions(Struct, frozen=True):
    """Where the manual has the words; 1 where nowhere, as grep has it."""

    words: str
    published: tuple[Mention, ...]
    near: str = ""  # the topic or command that was most likely meant

    @property
    def exit_code(self) -> ExitCode:
        """1 where nothing was found."""
        return ExitCode.ACCEPTED if self.published else ExitCode.NOT_ACCEPTED


class Document(Struct, frozen=True):
    """A text that is shown as it is, and what goes out with --json."""

    text: str
    published: tuple[Any, ...]
