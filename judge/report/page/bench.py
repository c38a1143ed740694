"""A benchmark as one HTML page: the ratios drawn with their quartiles, cold beside warm, and the table."""

from __future__ import annotations

from datetime import datetime

from msgspec import Struct

from judge import __version__
from judge.report.bench import COLUMNS, Scale, about, cells_of, cold_of, label_of, remarks
from judge.report.layout import Span
from judge.report.page.render import filled
from judge.report.values import seconds, times
from judge.run.bench import Bench, Row

MARK = "judge bench page"  # what tells a file that is such a page
_ROW = 34  # pixels


class BenchLine(Struct, frozen=True):
    """A program in the plot: where everything of it is, across in percent, down in pixels."""

    label: str
    own: bool
    y: int
    low: str
    median: str
    high: str
    title: str
    cold: str
    cold_title: str


class BenchLevel(Struct, frozen=True):
    """A round ratio."""

    x: str
    label: str
    one: bool


class BenchRow(Struct, frozen=True):
    """A line of the table."""

    label: str
    cells: tuple[str, ...]


def render_bench(bench: Bench, generated: datetime) -> bytes:
    """The whole file. The same benchmark always gives the same bytes."""
    measured = [row for row in bench.rows if row.seconds]
    drawn = [row for row in measured if row.ratio and row.ratio.median > 0]
    scale = Scale(drawn) if drawn else None
    lines = tuple(_line(row, place, scale) for place, row in enumerate(drawn)) if scale else ()
    levels = _levels(scale) if scale else ()
    return filled(
        "bench.html.j2",
        mark=MARK,
        version=__version__,
        bench=bench,
        about=about(bench),
        generated=generated,
        lines=lines,
        levels=levels,
        height=_ROW * len(lines),
        words="; ".join(_words(row) for row in drawn) + ".",
        heads=[column.title for column in COLUMNS[1:]],
        rows=[BenchRow(label_of(row), tuple(map(_text, cells_of(row)[1:]))) for row in measured],
        bare=f" ({seconds(bench.bare.median)})" if bench.bare else "",
        remarks=list(remarks(bench)),
    )


def is_bench_page(head: bytes) -> bool:
    """Whether a file that begins like this is such a page."""
    return b"<!doctype html>" in head[:40] and f'content="{MARK}'.encode() in head


def _levels(scale: Scale) -> tuple[BenchLevel, ...]:
    return tuple(BenchLevel(_percent(scale(value)), f"{value:g} ×", value == 1) for value in scale.decades)


def _line(row: Row, place: int, scale: Scale) -> BenchLine:
    ratio, cold = row.ratio, cold_of(row)
    assert ratio is not None
    return BenchLine(
        label=label_of(row),
        own=row.entrant.own,
        y=_ROW * place + _ROW // 2,
        low=_percent(scale(ratio.low)),
        median=_percent(scale(ratio.median)),
        high=_percent(scale(ratio.high)),
        title=_words(row),
        cold=_percent(scale(cold)) if cold else "",
        cold_title=f"first pass: {times(cold)} × Python's time" if cold else "",
    )


def _words(row: Row) -> str:
    ratio, cold = row.ratio, cold_of(row)
    assert ratio is not None
    first = f", {times(cold)} in the first pass" if cold else ""
    spread = f"{times(ratio.low)} to {times(ratio.high)}"
    return f"{label_of(row)} {times(ratio.median)} × Python's time ({spread}){first}"


def _percent(share: float) -> str:
    return f"{100 * min(1.0, max(0.0, share)):.2f}%"


def _text(cell: str | Span) -> str:
    return cell.text if isinstance(cell, Span) else cell
