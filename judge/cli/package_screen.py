"""What `judge run PACKAGE` shows: the first test file that each submission fails, and the verdicts last."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from judge.packs.foreign.judging import Failure, FileResult, Judged
from judge.packs.foreign.package import Package
from judge.packs.foreign.timing import TimeLimit
from judge.problem.verdict import Verdict
from judge.report.layout import Cell, Column, Line, Span, Style, Table, beside, hanging, line
from judge.report.names import shown_name
from judge.report.results import verdict_span
from judge.report.values import counted, seconds, size

if TYPE_CHECKING:
    from judge.cli.packages import Ruled

_ROWS = 8  # of an input, an answer or an output
_COLUMNS = 200  # of each
_FILES = 24  # test files that are shown one by one
_LABELS = 18  # the column where what follows a label begins


def row_lines(package: Package, ruled: Ruled, width: int | None, *, several: bool) -> Iterator[Line]:
    """One submission's report; of several only what is not as it should be."""
    judged = ruled.judged
    right = judged.verdict is Verdict.AC if ruled.as_expected is None else ruled.as_expected
    if several and (right or ruled.entrant.program is None):
        return
    aside = f"{package.name}, {judged.language or 'not run'}"
    yield from beside(Span(shown_name(judged.name), Style.STRONG), aside, width)
    yield line()
    if judged.tests and not several:
        yield from _files(judged.tests, width)
        yield line()
    if judged.failure is not None:
        yield from _failure_lines(judged.failure, judged.sensitive, width)
        yield line()


def _files(tests: Sequence[FileResult], width: int | None) -> Iterator[Line]:
    """A row for each test file, the first and the last where there are many."""
    columns = (Column("test file", broken=True), Column("verdict"), Column("CPU", right=True))
    shown = tests if len(tests) <= _FILES else (*tests[: _FILES // 2], *tests[-_FILES // 2 :])
    rows: list[list[Cell]] = [
        [test.name, verdict_span(test.verdict), Span(seconds(test.cpu_seconds), Style.FAINT)]
        for test in shown
    ]
    yield from Table(columns, rows).lines(width)
    if len(shown) < len(tests):
        left_out = tests[_FILES // 2 : -_FILES // 2]
        yield line(
            "  ", Span(f"{counted(len(left_out), 'more test file')} in between, accepted", Style.FAINT)
        )


def _failure_lines(failure: Failure, sensitive: str, width: int | None) -> Iterator[Line]:
    if failure.test:
        yield line("  ", Span(failure.test, Style.STRONG))
    rows = (
        ("input", failure.given, Style.PLAIN),
        ("answer", failure.answer, Style.GOOD),
        ("output", failure.output, Style.BAD),
        ("judge message", failure.told, Style.PLAIN),
        ("why", failure.message, Style.PLAIN),
        ("close call", sensitive, Style.WARNING),
    )
    for label, text, style in rows:
        if text or (failure.test and label in ("answer", "output")):
            laid = Span(_cut(text) or "(nothing)", style)
            yield from hanging(Span(label, Style.FAINT), laid, width, indent=4, column=_LABELS)


def _cut(text: str) -> str:
    """The first rows of a text, each as far as it is read."""
    rows = text.splitlines()
    kept = [row if len(row) <= _COLUMNS else f"{row[:_COLUMNS]}…" for row in rows[:_ROWS]]
    return "\n".join([*kept, *(["…"] if len(rows) > _ROWS else [])])


def end_lines(
    package: Package, rows: Sequence[Ruled], expected: int, limit: TimeLimit, width: int | None, *, own: bool
) -> Iterator[Line]:
    """The limits, the table of several, and what it comes to."""
    if expected > 1:
        yield from _table(rows, width, own=own)
        yield line()
    yield from beside(Span(f"limits: {limit_text(limit, package)}", Style.FAINT), "", width)
    yield from _verdict(rows, expected, width, own=own)


def limit_text(limit: TimeLimit, package: Package) -> str:
    """The bounds of a test file, in words."""
    rule = package.time
    since = (
        ""
        if limit.slowest is None
        else f" ({rule.factor:g} × {seconds(limit.slowest)}, the slowest accepted)"
    )
    time = f"{limit.seconds:g} s of CPU time{since}, margin {limit.margin:g} s"
    return f"{time}; {size(package.memory_bytes)} of memory, {size(package.output_bytes)} of output"


def _table(rows: Sequence[Ruled], width: int | None, *, own: bool) -> list[Line]:
    columns = (
        Column("submission", broken=True),
        Column("language"),
        Column("verdict"),
        Column("expected", spare=True),
        Column("passed", right=True),
        Column("slowest", right=True),
        Column("first failure", flexible=True),
    )
    return Table(columns, [_row(row, own=own) for row in rows]).lines(width)


def _row(ruled: Ruled, *, own: bool) -> list[Cell]:
    judged = ruled.judged
    name = judged.name.removeprefix("submissions/") if own else judged.name
    ran = bool(judged.tests)
    words = {True: Span("yes", Style.GOOD), False: Span("no", Style.BAD), None: Span("")}
    return [
        shown_name(name),
        judged.language,
        verdict_span(judged.verdict),
        words[ruled.as_expected],
        Span(f"{judged.passed}/{judged.out_of}" if ran else "", Style.FAINT),
        Span(seconds(judged.slowest) if ran else "", Style.FAINT),
        _place(judged),
    ]


def _place(judged: Judged) -> str:
    failure = judged.failure
    if failure is None:
        return ""
    close = ", a close call" if judged.sensitive else ""
    return f"{failure.test}{close}" if failure.test and judged.verdict is not Verdict.JE else failure.message


def _verdict(rows: Sequence[Ruled], expected: int, width: int | None, *, own: bool) -> list[Line]:
    left = f", {expected - len(rows)} not judged" if expected > len(rows) else ""
    if own:
        known = [row.as_expected for row in rows if row.as_expected is not None]
        unrun = sum(row.entrant.program is None for row in rows) + expected - len(rows)
        left = f", {unrun} not judged" if unrun else ""
        style = Style.GOOD if all(known) and not left else Style.BAD
        text = f"{sum(known)} of {counted(len(known), 'submission')} as expected{left}"
        return beside(Span(text, style), "", width)
    if expected == 1 and rows:
        judged = rows[0].judged
        aside = f"{judged.passed} of {counted(judged.out_of, 'test file')}" if judged.tests else ""
        span = verdict_span(judged.verdict)
        return [line(span, f" {judged.verdict.meaning}", Span(f"  {aside}" if aside else "", Style.FAINT))]
    accepted = sum(row.judged.verdict is Verdict.AC for row in rows)
    style = Style.GOOD if accepted == expected else Style.BAD
    return beside(Span(f"{accepted} of {expected} accepted{left}", style), "", width)
