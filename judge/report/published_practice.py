"""What history, hint and solution say: frozen structs, whose field names are the JSON's keys."""

from __future__ import annotations

from datetime import datetime

from msgspec import Struct

from judge.kata.events import Run
from judge.problem import Verdict
from judge.report.published import Published
from judge.run.result import Mode, Result


class RunRow(Published, frozen=True, kw_only=True):
    """A run with its result; `source` is the sha256 of what was judged, `passed` and `failed` name groups."""

    run: int
    time: datetime
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
    source: str
    result: Result


def run_row(run: Run) -> RunRow:
    """The row of a run. Raises HistoryError where its result is damaged."""
    return RunRow(
        run=run.id,
        time=run.when,
        problem=run.problem,
        submission=run.submission,
        path=run.path,
        verdict=run.verdict,
        score=run.score,
        mode=run.mode,
        mistake=run.mistake,
        ratio=run.ratio,
        passed=run.passed,
        failed=run.failed,
        levels=run.levels,
        source=run.source_hash,
        result=run.result,
    )


class RunList(Struct, frozen=True):
    """Runs, the latest last; `more` says that older ones are left out, `csv` that CSV is wanted."""

    runs: tuple[Run, ...]
    problem: str = ""
    more: bool = False
    csv: bool = False

    @property
    def published(self) -> tuple[RunRow, ...]:
        """Each run in full."""
        return tuple(map(run_row, self.runs))

    @property
    def plain(self) -> str:
        """The CSV, where that is wanted."""
        if not self.csv:
            return ""
        from judge.report.sheet import csv_text  # only who asks for it waits for it

        names = [name for name in RunRow.__struct_fields__ if name not in ("schema", "result")]
        return csv_text(
            [names, *([_cell(getattr(row, name)) for name in names] for row in self.published)], "\n"
        )


def _cell(value: object) -> object:
    """What a cell holds: names side by side, nothing for None."""
    if isinstance(value, tuple):
        return " ".join(value)
    if isinstance(value, datetime):
        return value.isoformat()
    return "" if value is None else getattr(value, "value", value)


class RunShown(Struct, frozen=True):
    """One run in full."""

    run: Run

    @property
    def published(self) -> tuple[RunRow]:
        """The run."""
        return (run_row(self.run),)


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


class ApproachRow(Struct, frozen=True, kw_only=True):
    """An approach, by its name and by what `judge solution` calls it.

    `seconds` are CPU seconds of one case, `ratio` the same as a multiple of the first approach's. Both are
    null where nothing was measured, and `why_not` says why it could not be.
    """

    name: str
    call: str
    file: str
    language: str
    about: str
    seconds: float | None
    ratio: float | None
    why_not: str


class Yours(Struct, frozen=True, kw_only=True):
    """The latest run of the person's own that solved the kata."""

    run: int
    file: str
    seconds: float | None
    ratio: float | None


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

    @property
    def paged(self) -> bool:
        """It is longer than most terminals."""
        return True
