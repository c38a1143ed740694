"""The setter's report for the screen: every solution's verdict, then what is wrong."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from judge.report.layout import Cell, Column, Line, Span, Style, Table, beside, hanging, line
from judge.report.values import counted
from judge.run.verify import SolutionReport, VerifyReport

_COLUMNS = (Column("solution"), Column("verdict"), Column("fails", flexible=True))


def report_lines(report: VerifyReport, width: int | None) -> Iterator[Line]:
    """One problem: its data, its solutions, its faults."""
    data = f"{counted(report.groups, 'group')}, {counted(report.cases, 'case')}, pins {report.pins}"
    yield from beside(Span(report.problem, Style.STRONG), data if report.groups else "", width)
    if report.solutions:
        yield line()
        yield from Table(_COLUMNS, [_row(solution) for solution in report.solutions]).lines(width)
    if report.faults:
        yield line()
    for fault in report.faults:
        yield from hanging(Span("fault", Style.BAD), Span(str(fault)), width, indent=2, column=9)


def _row(report: SolutionReport) -> list[Cell]:
    verdict = Span(report.verdict.value, Style.GOOD if report.ok else Style.BAD)
    return [report.file, verdict, Span(", ".join(report.failed), Style.FAINT)]


def summary_line(reports: Sequence[VerifyReport], width: int | None) -> list[Line]:
    """What all of it comes to."""
    faults = sum(len(report.faults) for report in reports)
    checked = f"{counted(len(reports), 'problem')} checked"
    if faults:
        return beside(Span(counted(faults, "fault"), Style.BAD), checked, width)
    return beside(Span("sound", Style.GOOD), checked, width)
