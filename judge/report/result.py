"""A result laid out for the screen: one on a screen of its own, or several as the rows of a table."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from textwrap import wrap
from typing import TYPE_CHECKING, NamedTuple

from msgspec import Struct
from rich.console import Console, ConsoleOptions, Group, RenderableType, RenderResult
from rich.text import Text

from judge.problem import Verdict
from judge.problem.find import typed
from judge.report.parts import (
    READABLE,
    Cell,
    bad,
    beside,
    blocks,
    commands,
    facts,
    faint,
    first_that_fits,
    good,
    indented,
    joined,
    label,
    solved_bar,
    strong,
    table,
    text,
    under,
    verdict_head,
    verdict_style,
)
from judge.report.published_result import RunReport, Several
from judge.report.screen import Screen
from judge.report.tell import Summary, looking, place_of, tell
from judge.report.words import counted, printable, shown_name, times
from judge.run.result import GroupResult, Result

if TYPE_CHECKING:
    from judge.report.picture import Drawing

_LABELS = {"got": bad, "expected": good}
_LEAST, _MOST = 9, 14  # rows of a picture
_AROUND = 20  # columns beside the skills that are new
_MARGIN = 16  # columns beside a value
_ROWS = 60  # of a result, on whatever screen


class _Cut(Struct, frozen=True):
    """How much is left out: a picture of so many rows (0: none), so many rows of each value and advice.

    `below` it are the groups that fail (1), and the commands too (2).
    """

    picture: int = 0
    values: int | None = None
    advice: int | None = None
    below: int = 2


PAGED = (  # little is left out; what is longer is shown in pages
    *(_Cut(picture=rows) for rows in range(_MOST, _LEAST - 1, -1)),
    *(_Cut(picture=rows, below=below) for rows in (_LEAST, 0) for below in (1, 0)),
    _Cut(values=6),
)
_CUTS = (
    *PAGED[:-1],
    *(_Cut(values=rows, below=0) for rows in (6, 3, 2, 1)),
    *(_Cut(values=1, advice=rows, below=0) for rows in (4, 2, 1)),
)


def run_report(found: RunReport, screen: Screen) -> RenderableType:
    """The screen of one result, or its line."""
    if found.several and not found.whole:
        return _line(found.result, told_of(found), kata=found.several > 1)
    if found.quiet:
        return verdict_line(told_of(found), found.result.submission)
    return screenful(found, screen, None if found.whole else min(screen.height - 1, _ROWS))


def told_of(found: RunReport, why: str = "") -> Summary:
    """The result in words; `why` is what the failing case turns on."""
    problem = found.data.problem if found.data else None
    return tell(problem, found.result, found.source, why, whole=found.whole, fresh=bool(found.fresh))


def _explained(found: RunReport, screen: Screen) -> tuple[Summary, Drawing | None]:
    """The result in words, and what draws it: None where there is nothing to draw, or no room."""
    result = found.result
    if result.hurdle or result.failure is None:
        return told_of(found), None
    from judge.report.picture import drawing, result_picture  # where something failed

    why, draw = drawing(partial(result_picture, found), screen, "the failing case")
    return told_of(found, why), draw


def screenful(
    found: RunReport, screen: Screen, rows: int | None, cuts: Sequence[_Cut] = _CUTS
) -> RenderableType:
    """One result in at most so many rows, if that can be; all there is where they are None."""
    (told, drawing), width = _explained(found, screen), screen.width
    beside: list[Cell] = [f"  {told.stars}" if told.stars else "", faint(f"  {told.how}" if told.how else "")]
    top = verdict_head(told.verdict, told.meaning, found.result.submission, *beside)
    laid = (blocks(top, *_parts(found, told, drawing, cut, width), verdict_line(told)) for cut in cuts)
    return first_that_fits(laid, screen, rows)


def begun(result: Result, name: str) -> RenderableType:
    """The verdict of a failure, as long as it is being explained."""
    told = tell(None, result)
    return blocks(verdict_head(told.verdict, told.meaning, name), indented(text(looking(result))))


def verdict_line(told: Summary, name: str = "") -> Text:
    """The verdict, and what all of it comes to; with the `name` of the file where nothing else is shown."""
    if not name:
        return joined(label(told.verdict), f"  {told.last}")
    _, name, last = told.line(name)
    return joined(label(told.verdict), "  ", strong(name), f"  {last}")


def _parts(
    found: RunReport, told: Summary, drawing: Drawing | None, cut: _Cut, width: int | None
) -> Iterator[RenderableType]:
    if told.happened:
        source = [indented(text(each), 4) for each in told.source]
        yield Group(indented(text(_cut(told.happened, cut.values, width))), *source)
    if told.case:
        yield _case(told, drawing, cut, width)
    if told.mistake:
        advice = [text(_cut(each, cut.advice, width)) for each in told.advice]
        yield Group(indented(strong(told.mistake)), *(indented(each, 4) for each in advice))
    if told.time:
        yield indented(text(told.time))
    if found.whole and found.result.groups:
        rows = map(_row, found.result.groups)
        yield indented(table(rows, "group", "verdict", "passed", "points", right=[2, 3]))
    elif told.fails and cut.below > 0:
        more = f", {told.more} more" if told.more else ""
        yield indented(facts([("fails", ", ".join(told.fails) + more)]))
    if found.fresh:
        yield indented(facts([("fresh", found.fresh)]))
    elif found.result.solved and (found.commands or found.key):
        yield _accepted(found, width)
    elif told.commands and found.commands and cut.below > 1:
        yield indented(commands(told.commands))


def magnified(found: RunReport, screen: Screen, rows: int) -> RenderableType | None:
    """The failing case, and its picture as large as so many rows allow; None where there is none to draw."""
    told, drawing = _explained(found, screen)
    cut = _Cut(picture=max(_LEAST, rows), values=2)
    return _case(told, drawing, cut, screen.width) if drawing else None


def _case(told: Summary, drawing: Drawing | None, cut: _Cut, width: int | None) -> RenderableType:
    """The failing case, and its picture where one is to be drawn."""
    wide = 2 + max((len(name) for name, _ in told.facts), default=0)
    below = [indented(_Arguments(told.input, cut.values), 2 + wide)] if told.input else []
    said = [
        row
        for name, fact in told.facts
        for row in under(name, map(_LABELS.get(name, text), _lines(fact, cut.values, width)))
    ]
    case = Group(strong(told.case), *below, *([indented(facts(said))] if said else []))
    return indented(beside(case, drawing(cut.picture)) if drawing and cut.picture else case)


class _Arguments(NamedTuple):
    """The arguments of a case in rows of whole ones, of which at most so many are shown."""

    told: Sequence[str]
    most: int | None

    def __rich_console__(self, _console: Console, options: ConsoleOptions) -> RenderResult:
        whole = "   ".join(printable(each).replace(" ", "\0") for each in self.told)
        rows = wrap(whole, options.max_width, break_long_words=False, break_on_hyphens=False)
        more = " …" if self.most is not None and len(rows) > self.most else ""
        shown = "\n".join(rows[: self.most]).replace("\0", " ") + more
        yield Text(_cut(shown, self.most, options.max_width + _MARGIN))


def _lines(said: str, rows: int | None, width: int | None) -> list[str]:
    """Its lines, of which at most about so many are shown."""
    lines = _cut(said, rows, width).split("\n")
    return lines if rows is None or len(lines) <= rows else [*lines[:rows], "…"]


def _cut(said: str, rows: int | None, width: int | None) -> str:
    """At most about so many rows of it."""
    room = None if rows is None else rows * max(20, (width or 80) - _MARGIN)
    return said if room is None or len(said) <= room else f"{said[: room - 2].rstrip(' ,')} …"


def _row(group: GroupResult) -> tuple[Cell, ...]:
    """A group: its verdict, the cases it passed, the points it earned."""
    accepted = group.verdict is Verdict.AC
    points = str(group.points) if accepted else f"0 of {group.points}"
    name, number = (text, faint) if accepted else (strong, text)
    return (
        name(group.name),
        text(group.verdict.value, verdict_style(group.verdict)),
        number(f"{group.passed}/{group.cases}" if group.run else "not run"),
        number(points if group.points else "extra"),
    )


def _line(found: Result, told: Summary, *, kata: bool = False) -> Text:
    """One of several submissions on a line, which is written as soon as it is judged."""
    ratio = f"{times(found.time.ratio.median)} ×" if found.time.ratio else ""
    first = place_of(found.failure) if found.hurdle is None else ""
    why = f"  {first or told.happened or told.last}" if found.verdict is not Verdict.AC else ""
    return joined(
        label(found.verdict, f"{found.verdict.value:<3}"),
        faint(f" {found.score if found.groups else '':>3}  {ratio:>7}  "),
        shown_name(found.submission),
        faint(f"  {found.problem}" if kata and found.problem else ""),
        why,
    )


def several(found: Several, _screen: Screen) -> Text:
    """How many of several submissions were accepted, and how many could not be, or are not yet, judged."""
    accepted = sum(each.verdict is Verdict.AC for each in found.results)
    unjudged = found.left + sum(each.verdict is Verdict.JE for each in found.results)
    every = len(found.results) + found.left
    said = f"{accepted} of {every} accepted" + (f", {unjudged} not judged" if unjudged else "")
    partial = dict.fromkeys(each.partial for each in found.results if each.partial)
    said += f", on {', '.join(partial)} only" if partial else ""
    return (good if accepted == every else bad)(said)


def _accepted(found: RunReport, width: int | None) -> RenderableType:
    """What follows an accepted result: what it took, how to go on, and how many katas are solved."""
    standing, keyed = found.standing, bool(found.key)
    go_on = "n" if keyed else "judge start"
    kata = typed(found.data.problem) if found.data else found.result.problem
    onward = [] if keyed else [(f"judge solution {kata}", "the model solution")]
    if standing is None:
        return indented(commands([*onward, (go_on, "the next kata")]))
    hints = counted(standing.hints, "hint") if standing.hints else "no hint"
    took = f"{counted(standing.runs, 'run')}, {hints}"
    if model := standing.model:
        took += f"; {counted(model.yours, 'line')}, the model has {model.lines}"
        first, *others = (idea.replace("-", " ") for idea in model.ideas)
        onward.append(("m", f"the model: {first}" + (f"; also: {', '.join(others)}" if others else "")))
    if following := standing.next:
        title = f"{following.title[:1].lower()}{following.title[1:]}"
        onward.append((go_on, f"next: {following.id}, {title}"))
    new = [("New", _new(standing.new, width))] if standing.new else []
    return blocks(
        indented(facts([*new, ("You", took)])),
        indented(commands(onward)) if onward else None,
        solved_bar(standing.solved, standing.katas, standing.stars, width),
    )


def _new(skills: Sequence[str], width: int | None) -> Text:
    """The skills that are new: as many as there is room for, and how many more."""
    room, shown = (width or READABLE) - _AROUND, [f"✓ {name}" for name in skills]
    while len("   ".join(shown)) > room and len(shown) > 1:
        shown.pop()
    left = len(skills) - len(shown)
    return joined(good("   ".join(shown)), f"   {left} more" if left else "")
