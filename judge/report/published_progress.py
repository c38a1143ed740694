"""What `judge progress` and `judge history` say: frozen structs, whose field names are the JSON's keys."""

from __future__ import annotations

from datetime import datetime

from msgspec import Struct

from judge.practice.events import Run
from judge.practice.progress import ChecklistQuestion, SkillProgress
from judge.practice.review import Due
from judge.problem import Problem
from judge.published import Published
from judge.run.result import Result


class SetShare(Struct, frozen=True, kw_only=True):
    """A set's katas, those of them that are solved, how many have one star and two, and its skills.

    One star is the interview level, two are production too; there are none where no kata has levels.
    """

    name: str
    title: str
    katas: tuple[str, ...]
    solved: tuple[str, ...]
    stars: tuple[int, ...]
    skills: int
    shown: int


class ProgressShown(Published, frozen=True, kw_only=True):
    """What was learned in a set; `sets` are those that it consists of, where it stands for all katas."""

    set: SetShare
    sets: tuple[SetShare, ...]
    skills: tuple[SkillProgress, ...]
    mistakes: dict[str, int]
    rows: tuple[ChecklistQuestion, ...]
    next: str | None


class ProgressPage(Struct, frozen=True):
    """The same with what is due, and the next kata."""

    published: tuple[ProgressShown]
    due: Due
    next: Problem | None


class QuestionShown(Published, frozen=True):
    """One question, and all that may tick it."""

    question: ChecklistQuestion


class RunRow(Published, frozen=True):
    """A run, which judged the file at `path`, with that sha256, and came to that result."""

    run: int
    time: datetime
    path: str
    source: str
    result: Result


def row_of(run: Run) -> RunRow:
    """The run in full. Raises StoreError where its result is damaged."""
    return RunRow(run.id, run.when, run.path, run.source_hash, run.result)


class RunList(Struct, frozen=True):
    """Runs, the latest last; `more` says that older ones are left out."""

    runs: list[Run]
    problem: str
    more: bool

    @property
    def published(self) -> list[RunRow]:
        """Each run in full."""
        return list(map(row_of, self.runs))


class Restored(Published, frozen=True):
    """The source of a run in its file again; what was there is `kept_as`, unless it was the same."""

    run: int
    time: datetime
    problem: str
    file: str
    written: bool
    kept_as: str | None
