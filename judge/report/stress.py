"""What a stress came to, for the screen: what broke, or how much did not."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from judge.report.layout import Line, Span, Style, beside, hanging, line
from judge.report.results import counterexample_lines, failure_lines, pitfall_lines, verdict_span
from judge.report.values import counted, seconds
from judge.run.result import Mode
from judge.run.stress import Stressed
from judge.spec import Verdict

_MODES = {Mode.FUNCTION: "its function called", Mode.PROGRAM: "run as a program"}


def stress_lines(stressed: Stressed, width: int | None, drawing: Iterable[Line] = ()) -> Iterator[Line]:
    """The report: what broke it with its smallest case, and last how many cases it came to."""
    result = stressed.result
    mode = "" if result.verdict is Verdict.CE else f", {_MODES[result.mode]}"
    yield from beside(Span(result.submission, Style.STRONG), f"{result.problem}{mode}", width)
    yield line()
    if result.failure:
        yield from (*failure_lines(result.failure, width), line())
    if result.counterexample:
        yield from (*counterexample_lines(result, result.counterexample, width), line())
    drawn = list(drawing)
    if drawn:
        yield from (*drawn, line())
    if result.pitfall:
        yield from (*pitfall_lines(result.pitfall, width), line())
    yield from _verdict_lines(stressed, width)


def _verdict_lines(stressed: Stressed, width: int | None) -> list[Line]:
    verdict = stressed.result.verdict
    label = verdict_span(verdict)
    if verdict is Verdict.CE:
        parts = [verdict.meaning]
    else:
        how = (
            f"{counted(stressed.cases, 'case')} in {seconds(stressed.seconds)}, {stressed.rate:,.0f} a second"
        )
        if verdict is not Verdict.AC:
            end = f"{verdict.meaning} among {how}"
        elif stressed.interrupted:
            label, end = Span("interrupted", Style.WARNING), f"nothing broke in {how}"
        else:
            end = f"nothing broke in {how}"
        images = stressed.cases - stressed.built
        share = f"{stressed.built:,} built" + (f" and {images:,} mirror images of these" if images else "")
        groups = counted(len(stressed.result.groups), "group")
        parts = [end, f"{share}, from {groups}", f"seed {stressed.seed}"]
    return hanging(label, Span("; ".join(parts)), width, indent=0, column=len(label.text) + 2)
