"""What `judge`, start, hint, solution, list, show and help say: structs, whose fields are the JSON's keys."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar

from msgspec import Struct

from judge.errors import ExitCode
from judge.practice.solutions import Approach
from judge.practice.syllabus import USUAL
from judge.problem.model import GroupLimits, GrowthRule, KataLevel, Source, Tier
from judge.published import Published
from judge.report.views import copied
from judge.run.result import Taken

if TYPE_CHECKING:
    from judge.manual import Page, SearchHit
    from judge.practice.events import Started
    from judge.practice.review import Due, Learner
    from judge.problem import Group, Problem

Words = dict[str, str]  # fields by name, each in words: numbers are exact, `n` or `n/d`


class Named(Published, frozen=True):
    """What is said of a kata wherever it is named."""

    problem: str
    title: str
    tier: Tier
    summary: str
    entry: str


class KataRow(Named, frozen=True):
    """A kata in a list; `stars` is 1 once the interview level is passed, 2 with production."""

    sets: tuple[str, ...]
    solved: bool
    stars: int


class KataList(Struct, frozen=True):
    """All katas, the sets by name, of which one is shown, and the current kata.

    `firsts` has the set in which each kata counts; in another it is only listed.
    """

    katas: Sequence[KataRow]
    sets: Mapping[str, Sequence[KataRow]]
    shown: str = ""
    about: str = ""  # the set that is shown
    current: str = ""
    todo: bool = False
    whole: bool = False
    firsts: Mapping[str, str] = {}
    exit_code: ExitCode = ExitCode.ACCEPTED

    def counts(self, row: KataRow, name: str) -> bool:
        """Whether the kata counts in the set of that name."""
        return self.firsts.get(row.problem, name) == name or name == USUAL

    def wanted(self, rows: Sequence[KataRow]) -> list[KataRow]:
        """Those of the katas that were asked for."""
        return [row for row in rows if not (self.todo and row.solved)]

    @property
    def published(self) -> list[KataRow]:
        """The katas that were asked for."""
        return self.wanted(self.sets.get(self.shown, self.katas))


class GroupRow(Struct, frozen=True):
    """A test group, with the mistakes that it finds; what it does not have of its own is null."""

    name: str
    about: str
    cases: int
    points: int
    seed: int | str
    tolerance: Words
    kills: tuple[str, ...]
    level: KataLevel | None
    size: int | None
    limits: GroupLimits | None
    time_limit: float | None


class KataInFull(Named, frozen=True):
    """A kata, whole; limits are in seconds and MB. An example has the arguments by name, and the answer."""

    answer: str
    parameters: list[Words]
    limits: GroupLimits
    growth: GrowthRule | None
    groups: list[GroupRow]
    examples: list[dict[str, Any]]
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
            parameters=[_in_words(each) for each in problem.parameters],
            groups=[_group_row(each) for each in problem.groups],
            examples=[
                {"input": problem.named(each.case), "answer": each.wanted} for each in problem.examples
            ],
        )
        return (full,)


def _group_row(group: Group) -> GroupRow:
    return copied(GroupRow, group, cases=group.count, tolerance=_in_words(group.tolerance))


def _in_words(value: Struct) -> Words:
    said = ((name, getattr(value, name)) for name in value.__struct_fields__)
    return {name: str(each) for name, each in said if each is not None}


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


class Document(Struct, frozen=True):
    """A text that is shown line by line, `plain` as it is, or `paged` as a page; and what --json writes."""

    text: str
    published: tuple[Any, ...]
    paged: bool = False
    plain: str = ""


class Topics(Struct, frozen=True):
    """All pages of the manual, to choose from."""

    published: Sequence[Page]


class Mentions(Struct, frozen=True):
    """Where the manual has the words; 1 where nowhere, as grep has it."""

    words: str
    published: Sequence[SearchHit]
    near: str = ""  # the topic or command that was most likely meant

    @property
    def exit_code(self) -> ExitCode:
        """1 where nothing was found."""
        return ExitCode.ACCEPTED if self.published else ExitCode.NOT_ACCEPTED


class ModelRow(Struct, frozen=True):
    """The model beside a person's program: the ideas of all approaches, its own first, and both lengths."""

    ideas: tuple[str, ...]
    lines: int
    yours: int


class Standing(Struct, frozen=True):
    """What a file took a person, the skills that are new, the next kata, and how many of all are solved.

    `stars` are how many katas have one star and two.
    """

    runs: int
    new: tuple[str, ...]
    hints: int
    next: Problem | None
    solved: int
    katas: int
    stars: tuple[int, ...]
    model: ModelRow | None = None


class Home(Struct, frozen=True):
    """Where a person stands, and what to do `now`: the file of a kata that is not solved; if it is `here`.

    Of a person who has not begun, `begun` is false, and `next` is the kata to begin with. `next` is None
    where all are solved. `topic` is what the katas are about.
    """

    learner: Learner
    due: Due
    begun: bool
    now: Started | None
    here: bool
    next: Problem | None
    topic: str
