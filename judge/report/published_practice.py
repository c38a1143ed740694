"""What history, hint and solution say: frozen structs, whose field names are the JSON's keys."""

from __future__ import annotations

from datetime import datetime
from typing import ClassVar

from msgspec import Struct, to_builtins

from judge.practice.events import Run
from judge.practice.solutions import Approach
from judge.problem import Verdict
from judge.problem.model import Mode
from judge.report.views import Published, copied
from judge.run.result import Result, Taken


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


class HintShown(Published, frozen=True, kw_only=True):
    """Hint `step` of a kata's `steps`, from 1; the text is Markdown."""

    problem: str
    step: int
    steps: int
    title: str
    text: str


class ApproachRow(Approach, frozen=True):
    """An approach with what it takes, if measured."""

    taken: Taken | None = None


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
