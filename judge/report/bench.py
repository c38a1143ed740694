"""A benchmark for the screen: a row a program, and a plot of the ratios with the first pass beside them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import ceil, floor, log10

from judge.report.layout import Cell, Column, Line, Span, Style, Table, beside, hanging, line, pad
from judge.report.names import shown_name
from judge.report.values import counted, seconds, size, times
from judge.run.bench import Bench, Row, Spread

COLUMNS = (
    Column("program", flexible=True),
    Column("ns a case", right=True),
    Column("quartiles", right=True),
    Column("× Python", right=True),
    Column("first pass", right=True),
    Column("starts", right=True),
    Column("memory", right=True),
)
_WIDEST, _NARROWEST = 60, 16  # columns of the plot
_USUAL = 80
_MEDIAN, _COLD, _LINE, _AXIS = "●", "○", "─", "·"


def bench_lines(bench: Bench, width: int | None) -> Iterator[Line]:
    """What was measured and how, the table, the plot, and what could not be measured."""
    yield from beside(Span(bench.problem, Style.STRONG), about(bench), width)
    yield line()
    shown = [row for row in bench.rows if row.seconds]
    if shown:
        yield from Table(COLUMNS, [cells_of(row) for row in shown]).lines(width)
        yield line()
        yield from plot_lines(shown, width)
        yield line()
        bare = f" of {seconds(bench.bare.median)}" if bench.bare else ""
        text = (
            "CPU time of a case after the start, quartiles over the rounds; first pass: the same, cold; "
            f"starts: the language's own, in bare starts of Python{bare}."
        )
        yield from hanging(Span("  "), Span(text, Style.FAINT), width, indent=0, column=2)
    said = list(remarks(bench))
    if said and shown:
        yield line()
    for label, text in said:
        yield from hanging(Span(label, Style.WARNING), Span(text), width, indent=2, column=len(label) + 4)


def about(bench: Bench) -> str:
    """How much was measured: `875 cases, 7 rounds`, and how many of them not alone."""
    rounds = counted(bench.rounds, "round")
    if bench.interrupted:
        rounds = f"{bench.rounds} of {counted(bench.wanted, 'round')}, interrupted"
    beside = f", {bench.beside} of them beside another judge" if bench.beside else ""
    return f"{counted(bench.cases, 'case')}, {rounds}{beside}"


def remarks(bench: Bench) -> Iterator[tuple[str, str]]:
    """What was not measured and why, and what answers wrongly, each with its label."""
    for row in bench.rows:
        if row.why_not:
            missing = row.entrant.missing == row.why_not
            yield label_of(row), f"not measured here: {row.why_not}" if missing else row.why_not
        elif row.wrong:
            yield label_of(row), f"it answers {counted(row.wrong, 'case')} wrongly"


def label_of(row: Row) -> str:
    """The language, or the name of a person's own file."""
    return shown_name(row.entrant.name) if row.entrant.own else row.entrant.language


def cells_of(row: Row) -> list[Cell]:
    """The row of the table, under `COLUMNS`."""
    assert row.seconds is not None
    return [
        Span(label_of(row), Style.STRONG if row.entrant.own else Style.PLAIN),
        ns(row.seconds.median),
        f"{ns(row.seconds.low)} – {ns(row.seconds.high)}",
        times(row.ratio.median) if row.ratio else "",
        ns(row.first.median) if row.first else "",
        times(row.start.median) if row.start else "",
        size(row.memory_bytes),
    ]


def ns(duration: float) -> str:
    """Nanoseconds with three digits at most, as a multiple of ten has its zeros: `4,550`, `84`."""
    value = duration * 1e9
    if value < 1:
        return "< 1"
    digits = max(0, floor(log10(value)) - 2)
    return f"{round(value / 10**digits) * 10**digits:,}"


class Scale:
    """A logarithmic scale over all ratios, cold and warm, from 0 to 1."""

    def __init__(self, rows: Sequence[Row]) -> None:
        found = [1.0, *(value for row in rows for value in _values(row))]
        self.low, self.high = floor(log10(min(found)) * 2 - 0.1) / 2, ceil(log10(max(found)) * 2 + 0.1) / 2

    def __call__(self, value: float) -> float:
        """Where a ratio lies, from 0 to 1."""
        return (log10(max(value, 10.0**self.low)) - self.low) / (self.high - self.low)

    @property
    def decades(self) -> list[float]:
        """The powers of ten within it."""
        return [10.0**power for power in range(ceil(self.low), floor(self.high) + 1)]


def cold_of(row: Row) -> float | None:
    """The first pass as a multiple of Python's time of a case, warm."""
    if row.first is None or row.seconds is None or row.ratio is None or row.seconds.median <= 0:
        return None
    return row.ratio.median * row.first.median / row.seconds.median


def _values(row: Row) -> list[float]:
    spread = row.ratio
    found = [spread.low, spread.median, spread.high, cold_of(row) or 0.0] if spread else []
    return [value for value in found if value > 0]


def plot_lines(rows: Sequence[Row], width: int | None) -> Iterator[Line]:
    """A line a program: the median with its quartiles, and the first pass; the scale is logarithmic."""
    drawn = [row for row in rows if row.ratio and row.ratio.median > 0]
    if not drawn:
        return
    scale = Scale(drawn)
    label = min(20, max(len(label_of(row)) for row in drawn))
    room = max(_NARROWEST, min(_WIDEST, (width or _USUAL) - label - 6))

    def place(value: float) -> int:
        return min(room - 1, max(0, round(scale(value) * (room - 1))))

    for row in drawn:
        assert row.ratio is not None
        marks = [" "] * room
        for decade in scale.decades:
            marks[place(decade)] = _AXIS
        _draw(marks, row.ratio, cold_of(row), place)
        name = pad(label_of(row)[:label], label)
        yield line(
            Span(f"  {name}  ", Style.STRONG if row.entrant.own else Style.PLAIN), "".join(marks).rstrip()
        )
    ticks = [" "] * (room + 8)
    for decade in scale.decades:
        text = f"{decade:g}×"
        at = max(0, place(decade) - len(text) // 2)
        ticks[at : at + len(text)] = text
    yield line(Span("  " + " " * label + "  " + "".join(ticks).rstrip(), Style.FAINT))
    key = f"{_MEDIAN} × Python's time, {_LINE} quartiles, {_COLD} the first pass"
    yield from hanging(Span(""), Span(key, Style.FAINT), width, indent=0, column=label + 4)


def _draw(marks: list[str], ratio: Spread, cold: float | None, place) -> None:  # type: ignore[no-untyped-def]
    for at in range(place(ratio.low), place(ratio.high) + 1):
        marks[at] = _LINE
    if cold:
        marks[place(cold)] = _COLD
    marks[place(ratio.median)] = _MEDIAN
