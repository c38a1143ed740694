"""What `judge progress` says: frozen structs, whose field names are the JSON's keys."""

from __future__ import annotations

from datetime import datetime

from msgspec import Struct

from judge.practice.progress import Covered, HackShare, Question, SkillProgress
from judge.practice.review import Review
from judge.report.views import Published


class SetShare(Struct, frozen=True, kw_only=True):
    """How many of a set's katas are solved, how many have one star or two, and its skills.

    One star is the interview level, two are production too; `levelled` katas have levels.
    """

    name: str
    katas: int
    solved: int
    levelled: int
    one_star: int
    two_stars: int
    skills: int
    shown: int


class Unfinished(Struct, frozen=True, kw_only=True):
    """A kata that was tried and is not solved: its most points, and its last run."""

    problem: str
    best: int
    last: datetime | None


class NextKata(Struct, frozen=True, kw_only=True):
    """The first kata of the set that was not tried, and a skill that it shows ("" for none)."""

    problem: str
    title: str
    skill: str


class CardsDue(Struct, frozen=True):
    """The cards that were answered before."""

    due: tuple[Review, ...]
    later: tuple[Review, ...]


class DueShown(Published, frozen=True, kw_only=True):
    """What is unfinished `now`, what to do again, and what cannot be found from here (`elsewhere`)."""

    time: datetime
    now: tuple[Unfinished, ...]
    due: tuple[Review, ...]
    later: tuple[Review, ...]
    elsewhere: tuple[str, ...]
    cards: CardsDue


class ProgressShown(Published, frozen=True, kw_only=True):
    """What was learned in the katas of a set: `katas` are their names, `solved` those that are solved.

    `sets` are those that it consists of, where it stands for all katas.
    """

    set: str
    title: str
    katas: tuple[str, ...]
    solved: tuple[str, ...]
    one_star: int
    two_stars: int
    sets: tuple[SetShare, ...]
    skills: tuple[SkillProgress, ...]
    levels: tuple[Covered, ...]
    mistakes: dict[str, int]
    rows: tuple[Question, ...]
    hacks: tuple[HackShare, ...]
    next: NextKata | None


class ProgressPage(Struct, frozen=True):
    """The same with what is due; `whole` asks for each skill, kata and question."""

    shown: ProgressShown
    due: DueShown
    whole: bool = False

    @property
    def published(self) -> tuple[ProgressShown]:
        """What was learned."""
        return (self.shown,)

    @property
    def paged(self) -> bool:
        """All of it is longer than most terminals."""
        return self.whole


class QuestionShown(Published, frozen=True, kw_only=True):
    """One question, and all that may tick it."""

    question: Question


class ProgressWritten(Published, frozen=True, kw_only=True):
    """A page that was written, of so many runs of these katas."""

    out: str
    bytes: int
    runs: int
    problems: tuple[str, ...]
