"""What a stress came to, for the screen: what broke, or how much did not."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from msgspec.structs import replace

from judge.problem import Verdict
from judge.report.glance import glance_lines
from judge.report.layout import Line, Span, Style, hanging
from judge.report.results import verdict_span
from judge.report.values import counted, seconds
from judge.run.stress import Stressed


def stress_lines(
    stressed: Stressed,
    width: int | None,
    rows: int,
    *,
    hurdle: Sequence[Line] = (),
    drawing: Iterable[Line] = (),
) -> list[Line]:
    """The report: what broke it with its smallest case, and last how many cases it came to."""
    result = replace(stressed.result, groups=())  # they say nothing about fresh cases
    verdict = _verdict_lines(stressed, width)
    return glance_lines(result, width, rows, hurdle=hurdle, drawing=drawing, verdict=verdict)


def _verdict_lines(stressed: Stressed, width: int | None) -> list[Line]:
    verdict = stressed.result.verdict
    label, what = verdict_span(verdict), verdict.meaning
    if verdict is Verdict.AC:
        label, what = (Span("interrupted", Style.WARNING) if stressed.interrupted else label), "nothing broke"
    group = stressed.result.failure.group if stressed.result.failure else None
    what += f" in {group}" if group else ""
    parts = [what] if verdict is Verdict.CE else [f"{what}: {_amount(stressed)}", *_origin(stressed)]
    return hanging(label, Span(", ".join(parts)), width, indent=0, column=len(label.text) + 2)


def _amount(stressed: Stressed) -> str:
    rate = f"{stressed.rate:,.0f} a second"
    return f"{counted(stressed.cases, 'case')} in {seconds(stressed.seconds)} ({rate})"


def _origin(stressed: Stressed) -> list[str]:
    """Where the cases came from, and how to have them again."""
    groups = counted(len(stressed.result.groups), "group")
    return [f"from {groups}", f"again with --seed {stressed.seed}"]
