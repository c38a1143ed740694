"""Exported packages for the screen."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from judge.packs.export.job import Export, reasons
from judge.report.layout import Line, Span, Style, beside, hanging, line
from judge.report.names import shown_name
from judge.report.values import counted

_NAMED = 3  # files that are named beside a reason
_COLUMN = 17


def export_lines(export: Export, width: int | None) -> Iterator[Line]:
    """One problem: its packages, and what was left out."""
    if export.why:
        yield from beside(Span(export.problem.id, Style.STRONG), f"left out: {export.why}", width)
        return
    programs = export.programs
    limit = f"time limit {programs.seconds} s" if programs else ""
    cases = sum(group.count for group in export.problem.groups)
    told = f"{counted(len(export.problem.groups), 'file')}, {counted(cases, 'case')}, {limit}"
    yield from beside(Span(export.problem.id, Style.STRONG), told, width)
    for package in export.packages:
        places = [str(package.folder)] + ([str(package.archive)] if package.archive else [])
        written = f"{', '.join(map(shown_name, places))}  {package.bytes / 1000:,.0f} kB"
        yield from _row(package.version.value, written, width)
    if export.domjudge:
        yield from _row("DOMjudge", shown_name(str(export.domjudge)), width)
    if programs and programs.held:
        kinds = Counter(each.path.partition("/")[0].replace("_", " ") for each in programs.held)
        yield from _row("programs", ", ".join(f"{count} {kind}" for kind, count in kinds.items()), width)
    for why, files in reasons(programs.left_out if programs else ()).items():
        named = ", ".join(files[:_NAMED]) + (
            f" and {len(files) - _NAMED} more" if len(files) > _NAMED else ""
        )
        yield from _row("left out", f"{named}: {why}", width)
    for note in export.notes:
        yield from _row("note", note, width)


def total_line(exports: Sequence[Export]) -> Line:
    """How many problems there were."""
    written = sum(not each.why for each in exports)
    left = len(exports) - written
    return line(
        Span(counted(written, "problem"), Style.STRONG), " exported" + (f", {left} left out" if left else "")
    )


def _row(label: str, text: str, width: int | None) -> list[Line]:
    return hanging(Span(label, Style.FAINT), Span(text), width, indent=2, column=_COLUMN)
