"""Past runs on a screen: the list, one run in full, what changed between two, a source that is back."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import date, datetime

from rich.console import Group, RenderableType
from rich.text import Text

from judge.errors import StoreError
from judge.practice.events import Run
from judge.practice.stub import usual_name
from judge.problem.model import FULL_SCORE, Verdict
from judge.report.parts import (
    BAD,
    FAINT,
    GOOD,
    STRONG,
    commands,
    indented,
    joined,
    table,
    text,
    verdict_style,
)
from judge.report.published_practice import Restored, RunList, RunsCompared, RunShown
from judge.report.result import Shown, result
from judge.report.screen import Screen
from judge.report.tell import tell
from judge.report.words import counted, shown_name, times

_DIFFERENT = {"+": GOOD, "-": BAD, "@": FAINT}  # how a line of a diff is shown, by its first character


def moment(when: datetime) -> str:
    """A time as the clock on the wall shows it."""
    return when.astimezone().strftime("%Y-%m-%d %H:%M")


def day(when: datetime | date) -> str:
    """A day as the calendar on the wall shows it."""
    return (when.astimezone() if isinstance(when, datetime) else when).strftime("%Y-%m-%d")


def run_list(found: RunList, _screen: Screen) -> RenderableType:
    """One row a run, the latest last; its file only where one is not called as its kata's usually is."""
    runs = found.runs
    if not runs:
        file = f"{found.problem} FILE" if found.problem else "FILE"
        return Group(text("No runs yet."), commands([(f"judge run {file}", "adds one")]))
    year = runs[-1].when.astimezone().year
    usual = all(shown_name(run.submission) == usual_name(run.problem) for run in runs)
    rows = [_row(run, year, usual=usual) for run in runs]
    remarks = "mistake or failed group" if any(row[-1].plain for row in rows) else ""
    titles = ("run", "when", "kata", "" if usual else "file", "result", remarks)
    listed = table(titles, rows, right=[0])
    if not found.more:
        return listed
    return Group(listed, Text(), text(f"The last {counted(len(runs), 'run')}; --limit N shows more.", FAINT))


def _row(run: Run, year: int, *, usual: bool) -> tuple[Text, ...]:
    here = run.when.astimezone()
    when = here.strftime("%m-%d %H:%M") if here.year == year else day(run.when)
    return (
        text(str(run.id), STRONG),
        text(when, FAINT),
        text(run.problem),
        text("" if usual else shown_name(run.submission)),
        text(_result(run), verdict_style(run.verdict)),
        text(_remark(run)),
    )


def _result(run: Run) -> str:
    """The verdict with the multiple of the reference's time, or with the points."""
    if not run.whole:
        full = run.score == FULL_SCORE and run.verdict is not Verdict.AC  # those that fail are worth none
        return f"{run.verdict.value} {'extra fails' if full else run.score}"
    return f"{run.verdict.value} {times(run.ratio)} ×" if run.ratio is not None else run.verdict.value


def _remark(run: Run) -> str:
    """The level that it passed without the other, and its mistake, first failed group, or its only groups."""
    try:
        passed: Sequence[str] = () if run.whole else run.levels
    except StoreError:  # of a damaged result the other columns are still true
        passed = ()
    partial = run.verdict is Verdict.AC and not run.whole
    left_out = f"only {', '.join(run.passed)}" if partial else ""
    why = run.mistake or (run.failed[0] if run.failed else left_out)
    return ", ".join([*(f"{level} level passed" for level in passed), *([why] if why else [])])


def run_shown(found: RunShown, screen: Screen) -> RenderableType:
    """When it was, what it came to, and how to get its source back."""
    run = found.run
    below = [(f"judge history {run.id} --restore", "write its source again")]
    return Group(_head(run.id, run.when), Text(), _came_to(run, screen), Text(), commands(below))


def _came_to(run: Run, screen: Screen) -> RenderableType:
    """What `judge run` said of it."""
    told = tell(None, run.result)
    return result(Shown(told, run.submission, run.result.groups), screen, None)


def _head(number: int, when: datetime) -> Text:
    return joined(text(f"run {number}", STRONG), text(f"  {moment(when)}", FAINT))


def runs_compared(found: RunsCompared, _screen: Screen) -> RenderableType:
    """The verdicts, the groups that ended otherwise, and the difference of the sources."""
    ends = [
        joined(text(verdict.value, verdict_style(verdict)), f" {score}")
        for verdict, score in zip(found.verdicts, found.scores, strict=True)
    ]
    numbers = (f"run {found.before}", f"run {found.after}")
    rows: list[tuple[str | Text, ...]] = [(text(found.problem, STRONG), *ends)]
    rows += [(each.group, _ended(each.before), _ended(each.after)) for each in found.groups]
    lines = [text(row.expandtabs(4), _DIFFERENT.get(row[:1], "")) for row in found.diff]
    changed = Group(*lines) if lines else text("The sources are the same.")
    return Group(table(("group", *numbers), rows, prose=None), Text(), indented(changed))


def _ended(how: str | None) -> Text:
    return text(how or "not run", {"passed": GOOD, "failed": BAD}.get(how or "", FAINT))


def restored(found: Restored, _screen: Screen) -> RenderableType:
    """Where a run's source is again, and where what was there is kept."""
    head = joined(
        text(shown_name(found.file), STRONG),
        f"  the source of run {found.run}, {moment(found.time)}, {found.problem}",
    )
    became = "" if found.written else "It was there already."
    if found.kept_as is not None:
        became = f"What was there is kept as {shown_name(found.kept_as)}."
    return Group(head, indented(text(became, FAINT))) if became else head
