"""What a stress came to, for the screen: what broke, or how much did not."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from judge.problem import Verdict
from judge.report.layout import Line, Span, Style, beside, hanging, line
from judge.report.names import shown_name
from judge.report.results import (
    HOW_RUN,
    counterexample_lines,
    failure_lines,
    pitfall_lines,
    place_lines,
    verdict_span,
)
from judge.report.thresholds import threshold_lines
from judge.report.values import counted, seconds
from judge.run.stress import Stressed


def stress_lines(stressed: Stressed, width: int | None, drawing: Iterable[Line] = ()) -> Iterator[Line]:
    """The report: what broke it with its smallest case, and last how many cases it came to."""
    result = stressed.result
    mode = "" if result.verdict is Verdict.CE else f", {HOW_RUN[result.mode.value]}"
    yield from beside(Span(shown_name(result.submission), Style.STRONG), f"{result.problem}{mode}", width)
    yield line()
    if result.failure:
        yield from (*failure_lines(result.failure, width), *place_lines(result, width), line())
    if result.counterexample:
        yield from (*counterexample_lines(result, result.counterexample, width), line())
    drawn = list(drawing)
    if drawn:
        yield from (*drawn, line())
    if result.pitfall:
        yield from (*pitfall_lines(result.pitfall, width), line())
    if told := list(threshold_lines(result, width)):
        yield from (*told, line())
    yield from _verdict_lines(stressed, width)


def _verdict_lines(stressed: Stressed, width: int | None) -> list[Line]:
    verdict = stressed.result.verdict
    label, what = verdict_span(verdict), verdict.meaning
    if verdict is Verdict.AC:
        label, what = (Span("interrupted", Style.WARNING) if stressed.interrupted else label), "nothing broke"
    parts = [what] if verdict is Verdict.CE else [f"{what}: {_amount(stressed)}", *_origin(stressed)]
    return hanging(label, Span(", ".join(parts)), width, indent=0, column=len(label.text) + 2)


def _amount(stressed: Stressed) -> str:
    rate = f"{stressed.rate:,.0f} a second"
    return f"{counted(stressed.cases, 'case')} in {seconds(stressed.seconds)} ({rate})"


def _origin(stressed: Stressed) -> list[str]:
    """Where the cases came from, so that nobody takes images for built ones, and how to have them again."""
    images = stressed.cases - stressed.built
    built = f"{stressed.built:,} built" + (f" and {images:,} mirror images of these" if images else "")
    groups = counted(len(stressed.result.groups), "group")
    return [f"{built}, from {groups}", f"again with --seed {stressed.seed}"]
