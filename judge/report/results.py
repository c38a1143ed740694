"""Results for the screen: one line a group, the failing case, and the verdict last."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from judge.problem.model import Verdict
from judge.report.layout import (
    Cell,
    Column,
    Line,
    Link,
    Span,
    Style,
    Table,
    beside,
    hanging,
    line,
    pad,
)
from judge.report.levels import levels_text
from judge.report.names import shown_command, shown_name
from judge.report.places import fault_place
from judge.report.values import arguments, counted, score_text, seconds, size, times
from judge.run.result import Failure, GroupResult, Pitfall, Ratio, Result, Timing

_STYLES = {
    Verdict.AC: Style.GOOD,
    Verdict.WA: Style.BAD,
    Verdict.CE: Style.BAD,
    Verdict.RTE: Style.BAD,
    Verdict.JE: Style.BAD,
    Verdict.TLE: Style.WARNING,
    Verdict.MLE: Style.WARNING,
    Verdict.OLE: Style.WARNING,
}
_LABELS = 12  # the column where what follows a label begins


def verdict_span(verdict: Verdict) -> Span:
    """The verdict's short name in its colour."""
    return Span(verdict.value, _STYLES[verdict])


def result_lines(result: Result, width: int | None, drawing: Iterable[Line] = ()) -> Iterator[Line]:
    """Everything of one submission's report, with a drawing of its failing case if there is one.

    The verdict is last. `judge.report.glance` shows what fits on a screen.
    """
    mode = "" if result.verdict in (Verdict.CE, Verdict.JE) else f", {HOW_RUN[result.mode.value]}"
    link = Link(result.submission)
    yield from beside(
        Span(shown_name(result.submission), Style.STRONG, link), f"{result.problem}{mode}", width
    )
    yield line()
    if result.groups:
        yield from group_table(result.groups).lines(width)
        yield line()
    if result.failure:
        yield from failure_lines(result.failure, width)
        yield from place_lines(result, width)
        yield line()
    if result.counterexample:
        yield from counterexample_lines(result, result.counterexample, width)
        yield line()
    drawn = list(drawing)
    if drawn:
        yield from (*drawn, line())
    if result.pitfall:
        yield from pitfall_lines(result.pitfall, width)
        yield line()
    yield from verdict_lines(result, width)


HOW_RUN = {"function": "its function called", "program": "run as a program"}  # by the mode's name


def group_table(groups: Sequence[GroupResult]) -> Table:
    """One row a group: its verdict, the cases it passed, the points it earned."""
    columns = (Column("group"), Column("verdict"), Column("passed", right=True), Column("points", right=True))
    return Table(columns, [_group_row(group) for group in groups])


def _group_row(group: GroupResult) -> list[Cell]:
    accepted = group.verdict is Verdict.AC
    quiet = Style.FAINT if accepted else Style.PLAIN
    points = str(group.points) if accepted else f"0 of {group.points}"
    if not group.points:
        points = "extra"
    return [
        Span(group.name, Style.PLAIN if accepted else Style.STRONG),
        verdict_span(group.verdict),
        Span(f"{group.passed}/{group.cases}", quiet),
        Span(points, quiet),
    ]


def failure_lines(
    failure: Failure, width: int | None, *, most: int | None = None, titled: bool = True
) -> Iterator[Line]:
    """The failing case: where it is, what went in, what was wanted and got, and why: how far off it is.

    Each of these in at most so many rows; its place only where it is `titled`.
    """
    if failure.group is not None and titled:
        yield line("  ", Span(failure_place(failure), Style.STRONG))
    rows = [
        ("input", None if failure.input is None else arguments(failure.input), Style.PLAIN),
        ("wanted", failure.expected, Style.GOOD),
        ("got", failure.got, Style.BAD),
        ("printed", failure.printed, Style.PLAIN),
        ("why", None if _says_nothing_new(failure) else failure.message, Style.PLAIN),
    ]
    for label, text, style in rows:
        if text:
            laid = hanging(Span(label, Style.FAINT), Span(text, style), width, indent=4, column=_LABELS)
            yield from clipped(laid, most)


def place_lines(result: Result, width: int | None) -> Iterator[Line]:
    """The line at fault of a file that does not compile or raised, as terminals and editors open it."""
    place = fault_place(result)
    if place is not None:
        text = f"{shown_name(result.submission)}:{place.line}" + (f":{place.column}" if place.column else "")
        shown = Span(text, link=Link(result.submission, place.line))
        yield from hanging(Span("at", Style.FAINT), shown, width, indent=4, column=_LABELS)


def counterexample_lines(result: Result, found: Failure, width: int | None) -> Iterator[Line]:
    """The smallest failing case, and the command that judges it alone, which is never broken into lines."""
    yield from smallest_lines(result, found, width)
    if found.replay is not None:
        yield again_line(result.submission, found.replay)


def smallest_lines(result: Result, found: Failure, width: int | None) -> Iterator[Line]:
    """The smallest failing case: its arguments, what was wanted and got, and why."""
    if found.replay is None:
        yield line("  ", Span("not by itself", Style.STRONG))
        yield from hanging(Span("why", Style.FAINT), Span(found.message), width, indent=4, column=_LABELS)
        return
    same = result.failure is not None and result.failure.input == found.input
    title = "no smaller case found" if same else "smallest case found"
    yield line("  ", Span(title + cut_short(found), Style.STRONG))
    if not same:
        yield from failure_lines(found, width, titled=False)


def cut_short(found: Failure) -> str:
    """What the title of a smallest case ends with where the search had not come to its end."""
    return ", the search was cut short" if found.cut_short else ""


def again_line(submission: str, replay: str) -> Line:
    """The command that judges that case alone, which is never broken into lines."""
    label = pad("again", _LABELS - 4)
    return line("    ", Span(label, Style.FAINT), shown_command("judge", "try", replay, file=submission))


def pitfall_lines(pitfall: Pitfall, width: int | None, *, most: int | None = None) -> Iterator[Line]:
    """The mistake behind the wrong answers: its name and score, what is wrong and what to do instead.

    The lines that it spoils are left out unless asked for; each advice has at most so many rows.
    """
    several = len(pitfall.names) > 1
    what = "two mistakes: " if several else ""
    perhaps = f", or perhaps {' or '.join(pitfall.perhaps)}" if pitfall.perhaps else ""
    yield from beside(
        Span(f"  {what}{pitfall.name}{perhaps}", Style.STRONG), f"likely, score {pitfall.score:.2f}", width
    )
    for name, advice in zip(pitfall.names, pitfall.advice, strict=True):
        text = f"{name}: {advice}" if several else advice
        yield from clipped(hanging(Span(""), Span(text), width, indent=4, column=4), most)


def clipped(laid: Sequence[Line], most: int | None) -> list[Line]:
    """At most so many of the lines, the last of them ending in `…` where some are left out."""
    if most is None or len(laid) <= most:
        return list(laid)
    if not most:
        return []
    *before, last = laid[:most]
    cut = last[-1]
    return [*before, (*last[:-1], Span(f"{cut.text[:-2].rstrip(' ,')} …", cut.style, cut.link))]


def _spoilt(wrong: str, right: str, width: int | None) -> Iterator[Line]:
    """A line that a mistake spoils, and the right one."""
    for row in wrong.splitlines():
        yield from hanging(Span(""), Span(row), width, indent=6, column=6)
    for row in right.splitlines():
        yield from hanging(Span("where"), Span(f"{row} is right"), width, indent=6, column=12)


def _says_nothing_new(failure: Failure) -> bool:
    """Whether the reason only repeats the two lines above it, as a wrong count's does."""
    return failure.message == f"{failure.expected} wanted, {failure.got} given"


def verdict_lines(result: Result, width: int | None, *, alone: bool = False) -> list[Line]:
    """The verdict in words, the points, the cases and what they cost; first the level that was passed.

    Where it stands alone it also says why nothing could be run.
    """
    parts = [result.verdict.meaning]
    if alone and result.failure and not result.groups:
        parts = [f"{result.verdict.meaning}: {result.failure.message}"]
    if result.groups:
        passed, cases = _cases(result)
        parts += [f"on {result.partial} only"] if result.partial else []
        parts += [_points(result), _share(passed, cases)]
        imported = result.time.import_seconds if result.time.import_tells else 0.0
        at_import = f", {seconds(imported)} of it at import" if imported else ""
        parts += [f"{seconds(result.time.cpu_seconds)} CPU{at_import}", size(result.memory_bytes)]
        if result.time.ratio:
            parts.append(_ratio_text(result.time.ratio, result.time))
        if result.time.growth and result.verdict is Verdict.AC:
            parts.append(str(result.time.growth))
    if levels := levels_text(result.levels):
        parts[0] = f"{levels}; {parts[0]}"
    label = verdict_span(result.verdict)
    return hanging(label, Span(", ".join(parts)), width, indent=0, column=len(label.text) + 2)


def _points(result: Result) -> str:
    """`58 of 100 points`; where all are earned all the same, how many groups without any fail."""
    if result.verdict is Verdict.AC or result.score < result.points:
        return f"{result.score} of {counted(result.points, 'point')}"
    failed = sum(group.verdict is not Verdict.AC for group in result.groups)
    extra = f"{counted(failed, 'extra group')} {'fails' if failed == 1 else 'fail'}"
    return f"all {counted(result.points, 'point')}, but {extra}" if result.points else extra


def _ratio_text(ratio: Ratio, time: Timing) -> str:
    """`1.3 × the reference (1.2 to 1.4, 9 pairs)`, with what stands against believing it."""
    spread = f"{times(ratio.low)} to {times(ratio.high)}, {counted(ratio.pairs, 'pair')}"
    doubts = [f"unreliable: {ratio.unreliable}"] if ratio.unreliable else []
    doubts += [ratio.busy] if ratio.busy else []
    doubts += ["near the limit"] if time.borderline else []
    whose = f" in {time.reference}" if time.reference else ""
    return f"{times(ratio.median)} × the reference{whose} ({'; '.join([spread, *doubts])})"


def _share(passed: int, cases: int) -> str:
    return counted(cases, "case") if passed == cases else f"{passed:,} of {counted(cases, 'case')}"


def _cases(result: Result) -> tuple[int, int]:
    groups = result.groups
    return sum(group.passed for group in groups), sum(group.cases for group in groups)


def summary_lines(results: Sequence[Result], width: int | None, left: int = 0) -> Iterator[Line]:
    """Several submissions: a row each, and how many were accepted on the last line, and how many are left."""
    accepted = sum(result.verdict is Verdict.AC for result in results)
    all_right = accepted == len(results) and not left
    problems = list(dict.fromkeys(result.problem for result in results if result.problem))
    columns = [
        Column("submission"),
        *([Column("problem")] if len(problems) > 1 else []),
        Column("verdict"),
        Column("points", right=True),
        Column("CPU", right=True),
        Column("× reference", right=True),
        Column("first failure", flexible=True),
    ]
    shown = len(columns) - (accepted == len(results))
    rows = [_summary_row(result, several=len(problems) > 1)[:shown] for result in results]
    yield from Table(tuple(columns[:shown]), rows).lines(width)
    yield line()
    style = Style.GOOD if all_right else Style.BAD
    partial = list(dict.fromkeys(result.partial for result in results if result.partial))
    text = f"{accepted} of {len(results)} accepted" + (f" on {', '.join(partial)} only" if partial else "")
    text += f", {left} not judged" if left else ""
    yield from beside(Span(text, style), ", ".join(problems), width)


def _summary_row(result: Result, *, several: bool) -> list[Cell]:
    judged, ratio = result.verdict is not Verdict.JE, result.time.ratio
    beside = "busy " if ratio and ratio.busy else ""
    return [
        Span(shown_name(result.submission), link=Link(result.submission)),
        *([result.problem] if several else []),
        verdict_span(result.verdict),
        Span(score_text(result.score, accepted=result.verdict is Verdict.AC) if judged else "", Style.FAINT),
        Span(seconds(result.time.cpu_seconds) if judged else "", Style.FAINT),
        Span(f"{beside}{times(ratio.median)}" if ratio else "", Style.FAINT),
        result.failure.message if result.hurdle and result.failure else failure_place(result.failure),
    ]


def failure_place(failure: Failure | None) -> str:
    """Where a failure is, or what it is where it has no place."""
    if failure is None:
        return ""
    if failure.group is None:
        return failure.message
    return failure.group if failure.case is None else f"{failure.group}, case {failure.case}"
