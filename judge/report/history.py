"""Past runs for the screen."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from datetime import date, datetime

from judge.errors import HistoryError
from judge.kata.events import Run
from judge.kata.stub import usual_name
from judge.problem.model import Verdict
from judge.report.layout import Cell, Column, Line, Span, Style, Table, beside, hanging, line
from judge.report.names import shown_name
from judge.report.results import verdict_span
from judge.report.values import counted, score_text, times


def moment(when: datetime) -> str:
    """A time as the clock on the wall shows it."""
    return when.astimezone().strftime("%Y-%m-%d %H:%M")


def day(when: datetime | date) -> str:
    """A day as the calendar on the wall shows it."""
    return (when.astimezone() if isinstance(when, datetime) else when).strftime("%Y-%m-%d")


def history_lines(runs: Sequence[Run], width: int | None, *, more: bool = False) -> Iterator[Line]:
    """One row a run, the latest last; `more` says that older ones are left out.

    Files are named where one is not called as its problem's usually is. A result is the verdict with the
    multiple of the reference's time, or with the points.
    """
    columns = (
        Column("run", right=True),
        Column("when"),
        Column("problem"),
        Column("file", broken=True),
        Column("result"),
        Column("mistake or failed group", flexible=True),
    )
    year = runs[-1].when.astimezone().year if runs else 0
    usual = all(shown_name(run.submission) == usual_name(run.problem) for run in runs)
    left_out = {"file"} if usual else set()
    left_out |= {columns[-1].title} if all(run.whole for run in runs) else set()
    kept = [place for place, column in enumerate(columns) if column.title not in left_out]
    rows = [[cell for place, cell in enumerate(_row(run, year)) if place in kept] for run in runs]
    yield from Table(tuple(columns[place] for place in kept), rows, indent=0).lines(width)
    if more:
        yield line()
        text = f"The last {counted(len(runs), 'run')}; --limit N shows more."
        yield from hanging(Span(""), Span(text, Style.FAINT), width, indent=0, column=0)


def _row(run: Run, year: int) -> list[Cell]:
    return [
        Span(str(run.id), Style.STRONG),
        Span(_lately(run.when, year), Style.FAINT),
        run.problem,
        shown_name(run.submission),
        Span(_result(run), verdict_span(run.verdict).style),
        _remark(run),
    ]


def _remark(run: Run) -> str:
    """The level that it passed without passing the other, and its mistake, the first group that failed, or
    that it was judged on some of the groups only.
    """
    try:
        passed = () if run.whole else run.levels
    except HistoryError:  # of a damaged result the other columns are still true
        passed = ()
    why = run.mistake or (run.failed[0] if run.failed else _left_out(run))
    return ", ".join([*(f"{level} level passed" for level in passed), *([why] if why else [])])


def _left_out(run: Run) -> str:
    """That a run which passed was judged on some of the groups only."""
    partial = run.verdict is Verdict.AC and not run.whole
    return f"only {', '.join(run.passed)}" if partial else ""


def restored_lines(
    run: Run, file: str, kept_as: str | None, width: int | None, *, written: bool
) -> Iterator[Line]:
    """Where a run's source is again, and where what was there is kept."""
    what = f"the source of run {run.id}, {moment(run.when)}, {run.problem}"
    yield from beside(Span(shown_name(file), Style.STRONG), what, width)
    became = "It was there already." if not written else ""
    if kept_as is not None:
        became = f"What was there is kept as {shown_name(kept_as)}."
    if became:
        yield from hanging(Span(""), Span(became, Style.FAINT), width, indent=2, column=2)


def _lately(when: datetime, year: int) -> str:
    """A moment of this year, and only the day of another."""
    here = when.astimezone()
    return here.strftime("%m-%d %H:%M") if here.year == year else day(when)


def _result(run: Run) -> str:
    if not run.whole:
        return f"{run.verdict.value} {_score(run)}"
    return f"{run.verdict.value} {times(run.ratio)} ×" if run.ratio is not None else run.verdict.value


def _score(run: Run) -> str:
    return score_text(run.score, accepted=run.verdict is Verdict.AC)
