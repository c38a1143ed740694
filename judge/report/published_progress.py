"""What `judge progress` and `judge history` say: frozen structs, whose field names are the JSON's keys."""

from __future__ import annotations

from datetime import datetime

from msgspec import Struct, to_builtins

from judge.practice.events import Run
from judge.practice.progress import Question, SkillProgress
from judge.practice.review import Review
from judge.problem import Verdict
from judge.problem.model import Mode
from judge.published import Published
from judge.report.published_look import Next
from judge.report.views import copied
from judge.run.result import Result


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
    last: datetime


class DueShown(Published, frozen=True, kw_only=True):
    """What is unfinished `now`, what to do again, and the cards that were answered, the first due first."""

    time: datetime
    now: tuple[Unfinished, ...]
    due: tuple[Review, ...]
    later: tuple[Review, ...]
    cards: tuple[Review, ...]

    @property
    def cards_due(self) -> int:
        """How many cards are due."""
        return sum(card.is_due(self.time) for card in self.cards)


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
    mistakes: dict[str, int]
    rows: tuple[Question, ...]
    next: Next | None


class ProgressPage(Struct, frozen=True):
    """The same with what is due; `whole` asks for each skill and question."""

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


class RunRow(
    Published, frozen=True, kw_only=True, rename={"id": "run", "when": "time", "source_hash": "source"}
):
    """A run with its result; `source` is the sha256 of what was judged, `passed` and `failed` name groups."""

    id: int
    when: datetime
    problem: str
    submission: str
    path: str
    verdict: Verdict
    score: int
    mode: Mode
    mistake: str | None
    ratio: float | None
    passed: tuple[str, ...]
    failed: tuple[str, ...]
    levels: tuple[str, ...]
    source_hash: str
    result: Result


class RunList(Struct, frozen=True):
    """Runs, the latest last; `more` says that older ones are left out, `csv` that CSV is wanted."""

    runs: tuple[Run, ...]
    problem: str = ""
    more: bool = False
    csv: bool = False

    @property
    def published(self) -> tuple[RunRow, ...]:
        """Each run in full."""
        return tuple(copied(RunRow, run) for run in self.runs)

    @property
    def plain(self) -> str:
        """The CSV, where that is wanted."""
        if not self.csv:
            return ""
        from judge.report.formats import csv_text  # only who asks for it waits for it

        columns = RunRow.__struct_encode_fields__[1:-1]  # without the schema and the result
        rows = (to_builtins(run, enc_hook=str) for run in self.published)
        return csv_text([columns, *([_cell(row[name]) for name in columns] for row in rows)], "\n")


def _cell(value: object) -> object:
    """What a cell holds: names side by side."""
    return " ".join(value) if isinstance(value, tuple) else value


class GroupChange(Struct, frozen=True):
    """A test group that the two runs did not end alike: `passed`, `failed`, or null where it was not run."""

    group: str
    before: str | None
    after: str | None


class RunsCompared(Published, frozen=True, kw_only=True):
    """Two runs of one kata: what became of its groups, and of the source (as a unified diff)."""

    problem: str
    before: int
    after: int
    verdicts: tuple[Verdict, Verdict]
    scores: tuple[int, int]
    groups: tuple[GroupChange, ...]
    diff: tuple[str, ...]


class Restored(Published, frozen=True, kw_only=True):
    """The source of a run in its file again; what was there is `kept_as`, unless it was the same."""

    run: int
    time: datetime
    problem: str
    source: str
    file: str
    written: bool
    kept_as: str | None
