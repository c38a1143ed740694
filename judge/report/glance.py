"""A result on one screen: the verdict first and last, what fails, the smallest case, the mistake's name.

What does not fit is left out in a fixed order, until the rest does; `judge run --all` shows it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from msgspec import Struct
from msgspec.structs import replace

from judge.problem.model import Verdict
from judge.report.layout import Line, Link, Span, Style, beside, cells, hanging, line, printable
from judge.report.names import shown_name
from judge.report.results import (
    HOW_RUN,
    again_line,
    cut_short,
    failure_lines,
    failure_place,
    group_table,
    pitfall_lines,
    place_lines,
    verdict_lines,
    verdict_span,
)
from judge.report.screen import Screen, is_terminal
from judge.report.values import counted
from judge.run.result import Result

_ROWS = 23  # of a screen of 24, whose last one the prompt takes


class Cut(Struct, frozen=True):
    """How much is shown: so many groups, so many rows of the advice and of each value (None: all)."""

    groups: int = 6
    spoilt: bool = True
    advice: int | None = None
    rows: int | None = None
    again: bool = True  # the command, whose case may hold numbers of a thousand digits


_CUTS = (
    Cut(),
    Cut(groups=3),
    Cut(groups=2),
    Cut(groups=1),
    *(Cut(groups, spoilt=False) for groups in (3, 2, 1)),
    Cut(groups=2, spoilt=False, advice=2),
    Cut(groups=1, spoilt=False, advice=1, rows=3),
    Cut(groups=1, spoilt=False, advice=0, rows=2),
    Cut(groups=1, spoilt=False, advice=0, rows=2, again=False),
    Cut(groups=1, spoilt=False, advice=0, rows=1, again=False),
)


def screen_rows(screen: Screen) -> int:
    """How many rows can be read at once; whoever reads no terminal gets what one of 24 rows shows."""
    if not is_terminal(screen.stream):
        return _ROWS
    from judge.report.terminal import height  # only who sits there waits for it

    return height(screen) - 1


def glance_lines(
    result: Result,
    width: int | None,
    rows: int,
    *,
    hurdle: Sequence[Line] = (),
    drawing: Iterable[Line] = (),
    end: Iterable[Line] = (),
    verdict: Sequence[Line] | None = None,
) -> list[Line]:
    """The report in at most so many rows, if that can be, a drawing of the failing case among them.

    `end` comes before the verdict, and `verdict` in its place. Where there is a `hurdle`, there is nothing
    else between them.
    """
    last = list(verdict_lines(result, width) if verdict is None else verdict)
    if hurdle:
        return [*_head(result, width), *hurdle, *last]
    ending, drawn = list(end), list(drawing)
    laid: list[Line] = []
    for cut in _CUTS:
        parts = [*_parts(result, width, cut, drawn), ending]
        laid = [*_head(result, width), *_spaced(parts), *last]
        if taken(laid, width) <= rows:
            break
    return laid


def rows_beside(result: Result, width: int | None) -> int:
    """How many rows are to be seen together with a drawing: the case, the mistake and the verdict."""
    parts = [part for part in _parts(replace(result, groups=()), width, Cut(), []) if part]
    return sum(taken(part, width) + 1 for part in parts) + taken(verdict_lines(result, width), width) + 1


def taken(lines: Iterable[Line], width: int | None) -> int:
    """How many rows of a terminal the lines take: a command is not broken, and may take several."""
    return sum(_rows(laid, width) for laid in lines)


def _rows(laid: Line, width: int | None) -> int:
    needed = sum(cells(printable(span.text)) for span in laid)
    return max(1, -(-needed // width)) if width else 1


def _spaced(parts: Iterable[Sequence[Line]]) -> Iterator[Line]:
    """The parts that hold anything, a blank line around each."""
    yield line()
    for part in parts:
        if part:
            yield from (*part, line())


def _head(result: Result, width: int | None) -> list[Line]:
    """The verdict, the file and how it was run."""
    mode = "" if result.verdict in (Verdict.CE, Verdict.JE) else f", {HOW_RUN[result.mode.value]}"
    label = verdict_span(result.verdict)
    column = len(label.text) + 2
    named = Span(shown_name(result.submission), Style.STRONG, Link(result.submission))
    room = None if width is None else width - column
    first, *rest = beside(named, f"{result.problem}{mode}", room)
    return [line(label, "  ", *first), *(line(" " * column, *row) for row in rest)]


def _parts(result: Result, width: int | None, cut: Cut, drawn: list[Line]) -> list[list[Line]]:
    parts = []
    if result.groups:
        parts.append(list(_groups(result, width, cut.groups)))
    parts.append(list(case_lines(result, width, cut.rows, again=cut.again)))
    parts.append(drawn)
    if result.pitfall:
        told = pitfall_lines(result.pitfall, width, most=cut.advice)
        parts.append(list(told))
    return parts


def _groups(result: Result, width: int | None, most: int) -> Iterator[Line]:
    """The first groups that were rejected, and how many there are besides."""
    groups = result.groups
    rejected = [group for group in groups if group.verdict is not Verdict.AC]
    if rejected:
        yield from group_table(rejected[:most]).lines(width)
    more = [f"{len(rejected) - most} more rejected"] if len(rejected) > most else []
    accepted = len(groups) - len(rejected)
    said = [*more, *([f"{counted(accepted, 'group')} accepted"] if accepted else [])]
    said += [f"{result.out_of - len(groups)} not run"] if result.out_of else []
    if said:
        yield line("  ", Span(", ".join(said), Style.FAINT))


def case_lines(
    result: Result, width: int | None, most: int | None = None, *, again: bool = True
) -> Iterator[Line]:
    """One case that fails, the smallest there is, each of its values in at most so many rows.

    Without `again` the command that judges it alone is only spoken of.
    """
    failure, found = result.failure, result.counterexample
    if failure is None:
        return
    smaller = found is not None and found.replay is not None and found.input != failure.input
    if found is None or found.replay is None:
        yield from failure_lines(failure, width, most=most)
    else:
        title = "smallest case found" if smaller else f"no smaller case found: {failure_place(failure)}"
        yield line("  ", Span(title + cut_short(found), Style.STRONG))
        shown = found if smaller else failure
        yield from failure_lines(shown, width, most=most, titled=False)
    yield from place_lines(result, width)
    if found is not None and found.replay is None:
        label = Span("alone", Style.FAINT)
        yield from hanging(label, Span(found.message), width, indent=4, column=12)
    elif found is not None and not again:
        label = Span("again", Style.FAINT)
        yield from hanging(label, Span("--all shows the long command"), width, indent=4, column=12)
    elif found is not None and found.replay is not None:
        yield again_line(result.submission, found.replay)


def more_lines(commands: Sequence[str], width: int | None) -> list[Line]:
    """What shows more of a failure."""
    if not commands:
        return []
    text = Span(", ".join(commands), Style.FAINT)
    return hanging(Span("more", Style.FAINT), text, width, indent=2, column=8)
