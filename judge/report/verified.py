"""The setter's report for the screen: every solution's verdict, then what is wrong."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import PurePath

from judge.report.layout import Cell, Column, Line, Span, Style, Table, beside, hanging, line
from judge.report.names import shown_name
from judge.report.values import counted, percent
from judge.run.matrix import Matrix, Row
from judge.run.verify import SolutionReport, VerifyReport

_MATRIX = (Column("wrong program"), Column("share", right=True), Column("rejected by", flexible=True))
_LEAST = (Column("mistake"), Column("cases", right=True), Column("group"), Column("line", flexible=True))
_EDGES = (Column("edge", flexible=True), Column("cases", right=True))
_OTHERS = 3  # groups that a row shows beside its own
_COLUMNS = (Column("solution"), Column("verdict"), Column("fails", flexible=True))


def report_lines(
    report: VerifyReport, width: int | None, *, with_matrix: bool = False, with_least: bool = False
) -> Iterator[Line]:
    """One problem: its data, its solutions or the kill matrix of the wrong ones, its faults.

    With `with_least`, the mistakes that are rejected at all.
    """
    data = f"{counted(report.groups, 'group')}, {counted(report.cases, 'case')}, pins {report.pins}"
    yield from beside(Span(report.problem, Style.STRONG), data if report.groups else "", width)
    if with_matrix and report.matrix and report.matrix.rows:
        yield line()
        yield from matrix_lines(report.matrix, width)
    elif report.solutions:
        yield line()
        yield from Table(_COLUMNS, [_row(solution) for solution in report.solutions]).lines(width)
    shown = [each for each in report.least if with_matrix or each.cases]
    if (with_matrix or with_least) and shown:
        yield line()
        rows = sorted(shown, key=lambda each: (each.name, each.cases))
        cells: list[list[Cell]] = [[each.name, str(each.cases), each.group, each.line] for each in rows]
        yield from Table(_LEAST, cells).lines(width)
    if with_matrix and report.edges:
        yield line()
        reached: list[list[Cell]] = [
            [what, str(cases) if cases else Span("none", Style.WARNING)] for what, cases in report.edges
        ]
        yield from Table(_EDGES, reached).lines(width)
    if report.choices:
        yield line()
        yield line(f"  {counted(report.choices, 'mistake')} of mistakes.py judged")
    if report.faults or report.warnings:
        yield line()
    for warning in report.warnings:
        yield from hanging(Span("warning", Style.STRONG), Span(str(warning)), width, indent=2, column=11)
    for fault in report.faults:
        yield from hanging(Span("fault", Style.BAD), Span(str(fault)), width, indent=2, column=9)


def matrix_lines(matrix: Matrix, width: int | None) -> Iterator[Line]:
    """A row for each wrong program, and what the groups are worth.

    A row tells the share of cases it gets wrong in its own group, then that group, then those that come next.
    """
    yield from Table(_MATRIX, [_matrix_row(row) for row in matrix.rows]).lines(width)
    yield line()
    for label, groups in (("no mistake named", matrix.aimless), ("no kill alone", matrix.replaceable)):
        if groups:
            yield from _remark(label, ", ".join(groups), width)
    if matrix.replaceable:
        yield from _remark(
            "", "(each program that one of these rejects is rejected by another group as well)", width
        )


def _remark(label: str, text: str, width: int | None) -> list[Line]:
    return hanging(Span(label, Style.FAINT), Span(text), width, indent=2, column=20)


def _matrix_row(row: Row) -> list[Cell]:
    own = row.own
    best = sorted(row.killing, key=lambda kill: kill.share, reverse=True)
    others = [f"{kill.group} {percent(kill.share)}" for kill in best if kill is not own]
    if len(others) > _OTHERS + 1:
        others[_OTHERS:] = [f"{len(others) - _OTHERS} others"]
    name = shown_name(PurePath(row.file).stem)
    if own is None:
        return [Span(name, Style.BAD), "", Span(", ".join(others) or "no group", Style.BAD)]
    return [name, percent(own.share), ", ".join([own.group, *others])]


def _row(report: SolutionReport) -> list[Cell]:
    if report.verdict is None:
        return [report.file, "", Span(report.unjudged, Style.WARNING)]
    verdict = Span(report.verdict.value, Style.GOOD if report.ok else Style.BAD)
    return [report.file, verdict, Span(", ".join(report.failed), Style.FAINT)]


def summary_line(reports: Sequence[VerifyReport], width: int | None) -> list[Line]:
    """What all of it comes to."""
    faults = sum(len(report.faults) for report in reports)
    checked = f"{counted(len(reports), 'problem')} checked"
    if faults:
        return beside(Span(counted(faults, "fault"), Style.BAD), checked, width)
    return beside(Span("sound", Style.GOOD), checked, width)
