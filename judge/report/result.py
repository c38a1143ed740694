"""A result laid out for the screen: one on a screen of its own, or several as the rows of a table."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from msgspec import Struct
from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from judge.problem import Verdict
from judge.report.parts import (
    Cell,
    bad,
    blocks,
    commands,
    facts,
    faint,
    good,
    indented,
    joined,
    label,
    solved_bar,
    strong,
    table,
    text,
    verdict_style,
)
from judge.report.published_look import Standing
from judge.report.published_result import Judged, Several
from judge.report.screen import Screen, drawn
from judge.report.tell import Told, place_of, tell
from judge.report.words import counted, shown_name, times
from judge.run.result import GroupResult, Result

Drawing = Callable[[int], Sequence[Text]]  # the picture of the failing case in about so many rows
_LABELS = {"got": bad, "expected": good}
_LEAST, _MOST = 9, 14  # rows of a picture
_ROWS = 60  # of a result, on whatever screen
_GAP = 3  # columns between the case and its picture


class Shown(Struct, frozen=True):
    """What there is to show of one result.

    `told` is in words, `name` the file's. `groups` are shown in full where there are any. `drawing` draws the
    failing case; `after` is what follows: where to go from an accepted one, the keys that a loop takes.
    """

    told: Told
    name: str
    groups: tuple[GroupResult, ...] = ()
    drawing: Drawing | None = None
    after: RenderableType | None = None
    commands: bool = True  # whether those that go on from a failure are shown


class _Cut(Struct, frozen=True):
    """How much is left out: a picture of so many rows (0: none), so many rows of each value and advice."""

    picture: int = 0
    values: int | None = None
    advice: int | None = None
    fails: bool = True


_CUTS = (
    *(_Cut(picture=rows) for rows in range(_MOST, _LEAST - 1, -1)),
    _Cut(values=6),
    _Cut(values=3, advice=4),
    _Cut(values=2, advice=2, fails=False),
    _Cut(values=1, advice=1, fails=False),
    _Cut(values=1, advice=0, fails=False),
)


def judged(found: Judged, screen: Screen) -> RenderableType:
    """The screen of one result, or its line."""
    told = tell(found.problem, found.result, found.source)
    if found.several and not found.whole:
        return _line(found.result, told, kata=found.several > 1)
    if found.quiet:
        return verdict_line(told, found.result.submission)
    after: RenderableType | None = None
    if found.fresh:
        after = indented(facts([("fresh", found.fresh)]))
    elif found.result.solved and found.commands:
        after = accepted(found.result.problem, found.standing, screen.width)
    groups = found.result.groups if found.whole else ()
    drawing = found.drawing(screen) if found.drawing else None
    rows = None if found.whole else min(screen.height - 1, _ROWS)
    return result(Shown(told, found.result.submission, groups, drawing, after, found.commands), screen, rows)


def result(shown: Shown, screen: Screen, rows: int | None) -> RenderableType:
    """One result in at most so many rows, if that can be; all there is where they are None."""
    width = screen.width
    if rows is None:
        return _laid(shown, _Cut(picture=_MOST), width)
    laid: RenderableType = Text()
    for cut in _CUTS:
        if cut.picture and shown.drawing is None:
            continue
        laid = _laid(shown, cut, width)
        if drawn(laid, screen).count("\n") <= rows:
            break
    return laid


def verdict_line(told: Told, name: str = "") -> Text:
    """The verdict, and what all of it comes to; with the `name` of the file where nothing else is shown."""
    if not name:
        return joined(label(told.verdict), f"  {told.last}")
    meaning = f"{told.meaning}: " if told.verdict is not Verdict.AC else ""
    last = told.happened if told.last == "nothing was run" else told.last
    return joined(label(told.verdict), "  ", strong(shown_name(name)), f"  {meaning}{last}")


def _laid(shown: Shown, cut: _Cut, width: int | None) -> RenderableType:
    told = shown.told
    top = joined(
        label(told.verdict),
        f"  {told.meaning}  ",
        strong(shown_name(shown.name)),
        f"  {told.stars}" if told.stars else "",
        faint(f"  {told.how}" if told.how else ""),
    )
    return blocks(top, *_parts(shown, cut, width), verdict_line(told))


def _parts(shown: Shown, cut: _Cut, width: int | None) -> Iterator[RenderableType]:
    told = shown.told
    if told.happened:
        source = [indented(text(each), 4) for each in told.source]
        yield Group(indented(text(_cut(told.happened, cut.values, width))), *source)
    if told.case:
        yield indented(_with_picture(_case(told, cut, width), shown.drawing, cut, width))
    elif cut.picture and shown.drawing is not None:
        yield indented(Group(*shown.drawing(cut.picture)))
    if told.mistake:
        advice = [text(_cut(each, cut.advice, width)) for each in told.advice if cut.advice != 0]
        yield Group(indented(strong(told.mistake)), *(indented(each, 4) for each in advice))
    if told.time:
        yield indented(text(told.time))
    if shown.groups:
        yield indented(table(map(_row, shown.groups), "group", "verdict", "passed", "points", right=[2, 3]))
    elif told.fails and cut.fails:
        more = f", {told.more} more" if told.more else ""
        yield indented(facts([("fails", ", ".join(told.fails) + more)]))
    if shown.after is not None:
        yield shown.after
    elif told.commands and shown.commands:
        yield indented(commands(told.commands))


def magnified(told: Told, drawing: Drawing, rows: int, width: int | None) -> RenderableType:
    """The failing case, and its picture as large as so many rows allow, beside it or below it."""
    case = _case(told, _Cut(values=2), width)
    return indented(_with_picture(case, drawing, _Cut(picture=max(_LEAST, rows - 2)), width))


def _case(told: Told, cut: _Cut, width: int | None) -> RenderableType:
    rows: list[tuple[Cell, Cell]] = []
    if told.input:
        rows.append(("", text(_cut("   ".join(told.input), cut.values, width))))
    for name, said in told.facts:
        rows.append((faint(name), _LABELS.get(name, text)(_cut(said, cut.values, width))))
    return Group(strong(told.case), *([indented(table(rows))] if rows else []))


def _with_picture(
    case: RenderableType, drawing: Drawing | None, cut: _Cut, width: int | None
) -> RenderableType:
    """The picture beside the case where both have room, or else below it."""
    if drawing is None or not cut.picture:
        return case
    rows = drawing(cut.picture)
    wide = max((row.cell_len for row in rows), default=0)
    if width is not None and width - 4 - _GAP - wide >= width // 2:
        both = Table.grid(expand=True, padding=(0, 0, 0, _GAP))
        both.add_column(ratio=1)
        both.add_column(width=wide + _GAP, no_wrap=True)
        both.add_row(case, Group(*rows))
        return both
    return Group(case, Text(), *rows)


def _cut(said: str, rows: int | None, width: int | None) -> str:
    """At most about so many rows of it."""
    room = None if rows is None else rows * max(20, (width or 80) - 16)
    return said if room is None or len(said) <= room else f"{said[: room - 2].rstrip(' ,')} …"


def _row(group: GroupResult) -> tuple[Cell, ...]:
    """A group: its verdict, the cases it passed, the points it earned."""
    accepted = group.verdict is Verdict.AC
    points = str(group.points) if accepted else f"0 of {group.points}"
    name, number = (text, faint) if accepted else (strong, text)
    return (
        name(group.name),
        text(group.verdict.value, verdict_style(group.verdict)),
        number(f"{group.passed}/{group.cases}"),
        number(points if group.points else "extra"),
    )


def _line(found: Result, told: Told, *, kata: bool = False) -> Text:
    """One of several submissions on a line, which is written as soon as it is judged."""
    ratio = f"{times(found.time.ratio.median)} ×" if found.time.ratio else ""
    first = ""  # where it failed first, or why nothing could be run
    if found.verdict is not Verdict.AC:
        first = place_of(found.failure) if found.hurdle is None else ""
        first = f"  {first or told.happened or told.last}"
    return joined(
        label(found.verdict, f"{found.verdict.value:<3}"),
        faint(f" {found.score if found.groups else '':>3}  {ratio:>7}  "),
        shown_name(found.submission),
        faint(f"  {found.problem}" if kata and found.problem else ""),
        first,
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


def accepted(problem: str, standing: Standing | None, width: int | None, key: str = "") -> RenderableType:
    """What follows an accepted result: what it took, how to go on, and how many katas are solved.

    `key` is the one that goes on, where a loop takes keys and no commands.
    """
    onward = [] if key else [(f"judge solution {problem}", "the model solution")]
    go_on = key or "judge start"
    if standing is None:
        return blocks(indented(commands([*onward, (go_on, "the next kata")])))
    hints = f", {counted(standing.hints, 'hint')}" if standing.hints else ""
    if following := standing.next:
        title = f"{following.title[:1].lower()}{following.title[1:]}"
        onward.append((go_on, f"next: {following.problem}, {title}"))
    return blocks(
        indented(facts([("you", counted(standing.runs, "run") + hints)])),
        indented(commands(onward)) if onward else None,
        solved_bar(standing.solved, standing.katas, (), width),
    )
