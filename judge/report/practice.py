"""What a person has done, on a screen: runs, hints and solutions that were seen."""

from __future__ import annotations

from collections.abc import Sequence

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
    Cell,
    blocks,
    commands,
    faint,
    good,
    head,
    indented,
    joined,
    prose,
    strong,
    table,
    text,
    verdict_style,
)
from judge.report.published_practice import HintShown, Restored, RunList, RunRow, RunsCompared, SolutionShown
from judge.report.result import Shown, result
from judge.report.screen import Screen, is_terminal
from judge.report.tell import tell
from judge.report.words import counted, day, moment, printable, seconds, shown_name, times
from judge.run.result import Taken

_DIFFERENT = {"+": GOOD, "-": BAD, "@": FAINT}  # how a line of a diff is shown, by its first character


# -- runs ----------------------------------------------------------------------------------------------------


def run_list(found: RunList, _screen: Screen) -> RenderableType:
    """One row a run, the latest last; its file only where one is not called as its kata's usually is."""
    runs = found.runs
    if not runs:
        file = f"{found.problem} FILE" if found.problem else "FILE"
        return Group(text("No runs yet."), commands([(f"judge run {file}", "adds one")]))
    year = runs[-1].when.astimezone().year
    usual = all(shown_name(run.submission) == usual_name(run.problem) for run in runs)
    rows = [_run(run, year, usual=usual) for run in runs]
    remarks = "mistake or failed group" if any(row[-1] for row in rows) else ""
    titles = ("run", "when", "kata", "" if usual else "file", "result", remarks)
    more = faint(f"The last {counted(len(runs), 'run')}; --limit N shows more.") if found.more else None
    return blocks(table(rows, *titles, right=[0]), more)


def _run(run: Run, year: int, *, usual: bool) -> tuple[Cell, ...]:
    here = run.when.astimezone()
    when = here.strftime("%m-%d %H:%M") if here.year == year else day(run.when)
    came_to = text(_result(run), verdict_style(run.verdict))
    file = "" if usual else shown_name(run.submission)
    return strong(str(run.id)), faint(when), run.problem, file, came_to, _remark(run)


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


def run_row(run: RunRow, screen: Screen) -> RenderableType:
    """When it was, what it came to, and how to get its source back."""
    return blocks(
        head(f"run {run.id}", faint(moment(run.when))),
        result(Shown(tell(None, run.result), run.submission, run.result.groups), screen, None),
        commands([(f"judge history {run.id} --restore", "write its source again")]),
    )


def runs_compared(found: RunsCompared, _screen: Screen) -> RenderableType:
    """The verdicts, the groups that ended otherwise, and the difference of the sources."""
    ends = [
        joined(text(verdict.value, verdict_style(verdict)), f" {score}")
        for verdict, score in zip(found.verdicts, found.scores, strict=True)
    ]
    titles = ("group", f"run {found.before}", f"run {found.after}")
    rows: list[tuple[Cell, ...]] = [(strong(found.problem), *ends)]
    rows += [(each.group, _ended(each.before), _ended(each.after)) for each in found.groups]
    lines = [text(row.expandtabs(4), _DIFFERENT.get(row[:1], "")) for row in found.diff]
    changed = Group(*lines) if lines else text("The sources are the same.")
    return blocks(table(rows, *titles, prose=None), indented(changed))


def _ended(how: str | None) -> Text:
    return text(how or "not run", {"passed": GOOD, "failed": BAD}.get(how or "", FAINT))


def restored(found: Restored, _screen: Screen) -> RenderableType:
    """Where a run's source is again, and where what was there is kept."""
    said = f"the source of run {found.run}, {moment(found.time)}, {found.problem}"
    became = "" if found.written else "It was there already."
    if found.kept_as is not None:
        became = f"What was there is kept as {shown_name(found.kept_as)}."
    return Group(head(shown_name(found.file), said), *([indented(faint(became))] if became else []))


# -- help ----------------------------------------------------------------------------------------------------


def hint_shown(found: HintShown, screen: Screen) -> RenderableType:
    """The hint under its title; after the last one, what is left to do."""
    place = faint(f"{found.problem}, hint {found.step} of {found.steps}")
    last: list[RenderableType] = []
    if found.step == found.steps:
        onward = commands([(f"judge solution {found.problem} --give-up", "the solution")])
        last = [text("That was the last hint."), onward]
    title = table([(strong(found.title), place)])
    return blocks(title, prose(found.text, screen), Group(*last))


def solution_shown(found: SolutionShown, screen: Screen) -> RenderableType:
    """Its idea, why it works, and the program, whose lines are never broken: they can be copied."""
    rows = [printable(row.expandtabs(4)) for row in found.program.split("\n")]
    if not is_terminal(screen.stream):
        rows = [f"```{found.code}", *rows, "```"]
    return blocks(
        head(f"{found.problem}: {found.idea.replace('-', ' ')}", found.file),
        prose(found.explanation, screen) if found.explanation else None,
        Group(*(Text(row, no_wrap=True, overflow="ignore") for row in rows)),
        _timed(found) if found.approaches[0].taken else _beside(found),
    )


def _beside(found: SolutionShown) -> RenderableType:
    """The other approaches in its language by name, and the other languages."""
    command = f"judge solution {found.problem}"
    own = [each for each in found.approaches if each.language == found.language]
    rest = [each.call for each in own if each.file != found.file]
    others = [*dict.fromkeys(each.language for each in found.approaches if each.language != found.language)]
    rows = [(strong(each.call), each.about if each.call in rest else "the one above") for each in own]
    below = [(f"{command} {call}", "another approach") for call in rest[:1]]
    below += [(f"{command} --language {each}", "one of them") for each in others[:1]]
    also = [text(f"Also in {', '.join(others)}.")] if others else []
    return blocks(
        table(rows, "approach", "idea") if len(own) > 1 else None,
        Group(*also, commands([*below, (f"{command} --times", "what each takes")])),
    )


def _timed(found: SolutionShown) -> RenderableType:
    """What each approach takes for one case, the person's own last."""
    rows = [(strong(each.call), each.language, *_taken(each.taken)) for each in found.approaches]
    if own := found.yours:
        which = faint(f"run {own.run}, {shown_name(own.file)}")
        rows.append((good("yours"), "", *_taken(own.taken)[:2], which))
    titles = ("approach", "language", "CPU, one case", f"× {found.approaches[0].call}", "")
    return table(rows, *titles, right=[2, 3])


def _taken(taken: Taken | None) -> tuple[str, str, Text]:
    """CPU seconds of a case, which are often few microseconds, the ratio, and why there are none."""
    if taken is None or taken.seconds is None:
        return "", "", faint(taken.why_not if taken else "")
    short = f"{1e6 * taken.seconds:.3g} µs" if taken.seconds < 1e-3 else seconds(taken.seconds)
    return short, times(taken.ratio) if taken.ratio is not None else "", Text()
