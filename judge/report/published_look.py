"""What `judge`, list, show and help say: frozen structs, whose field names are JSON's keys."""

from __future__ import annotations

from typing import Any

from msgspec import Struct

from judge.errors import ExitCode
from judge.problem import Problem
from judge.problem.model import GroupLimits, GrowthRule, KataLevel, Source, Tier
from judge.published import Published
from judge.report.views import copied, in_words


class KataRow(Published, frozen=True):
    """A kata in a list; `stars` is 1 once the interview level is passed, 2 with production."""

    problem: str
    title: str
    tier: Tier
    summary: str
    entry: str
    groups: int
    cases: int
    points: int
    sets: tuple[str, ...]
    solved: bool
    stars: int


class SetRow(Struct, frozen=True):
    """A set of katas: its name, a sentence about it, and its katas in order."""

    name: str
    about: str
    katas: tuple[KataRow, ...]


class KataList(Struct, frozen=True):
    """All katas, their sets, the set to show, and the current kata; `faults` katas or sets are broken."""

    katas: tuple[KataRow, ...]
    sets: tuple[SetRow, ...]
    shown: SetRow | None = None
    current: str = ""
    todo: bool = False
    whole: bool = False
    faults: int = 0

    def wanted(self, rows: tuple[KataRow, ...]) -> tuple[KataRow, ...]:
        """Those of the katas that were asked for."""
        return tuple(row for row in rows if not (self.todo and row.solved))

    @property
    def published(self) -> tuple[KataRow, ...]:
        """The katas that were asked for."""
        return self.wanted(self.shown.katas if self.shown else self.katas)

    @property
    def exit_code(self) -> ExitCode:
        """3 where a kata cannot be read."""
        return ExitCode.FAULT if self.faults else ExitCode.ACCEPTED


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
    level: KataLevel | None
    size: int | None
    limits: GroupLimits | None
    time_limit: float | None


class ExampleRow(Struct, frozen=True):
    """A worked example: the arguments by name, and the answer."""

    input: dict[str, Any]
    answer: Any


class KataInFull(Published, frozen=True):
    """A kata, whole; limits are in seconds and MB."""

    problem: str
    title: str
    tier: Tier
    summary: str
    entry: str
    answer: str
    parameters: tuple[ParameterRow, ...]
    limits: GroupLimits
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
    def published(self) -> tuple[KataInFull]:
        """Both, in one object."""
        problem = self.problem
        full = copied(
            KataInFull,
            problem,
            problem=problem.id,
            answer=str(problem.answer),
            parameters=tuple(in_words(ParameterRow, each) for each in problem.parameters),
            groups=tuple(
                copied(GroupRow, each, cases=each.count, tolerance=in_words(Accuracy, each.tolerance))
                for each in problem.groups
            ),
            examples=tuple(ExampleRow(problem.named(each.case), each.wanted) for each in problem.examples),
        )
        return (full,)


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


class Next(Struct, frozen=True):
    """A kata to take up: its id, its title and a sentence about it."""

    problem: str
    title: str
    summary: str


class Now(Struct, frozen=True):
    """The kata a person is at, which is not solved: its file, and the folder where that is not this one.

    `points` and `mistake` are those of the last run; None and "" where there was none.
    """

    problem: str
    file: str
    folder: str
    points: int | None
    mistake: str


class Again(Struct, frozen=True):
    """A kata to solve again today, and how many days ago it was solved."""

    problem: str
    days: int


class Standing(Struct, frozen=True):
    """What a kata took a person, the skills that are new, the next kata, and how many of all are solved."""

    runs: int
    new: tuple[str, ...]
    hints: int
    next: Next | None
    solved: int
    katas: int


class Home(Published, frozen=True):
    """Where a person stands: katas solved, those with one star and with two, and what to do now.

    Of a person who has not begun, `begun` is false, and `next` is the kata to begin with. `next` is None
    where all are solved.
    """

    katas: int
    begun: bool
    solved: int
    stars: tuple[int, int]
    now: Now | None
    again: Again | None
    next: Next | None
    cards_due: int
