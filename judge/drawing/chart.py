"""The one chart: lines of dots over two axes, linear or logarithmic, in braille.

    Chart((Series("reference", ((500, 0.01), (8000, 0.16)), Role.WANTED),), x, y)

On logarithmic axes a power law is a straight line, and its slope is the power.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import count, pairwise
from math import ceil, floor, log10
from typing import NamedTuple

from judge.drawing.braille import COLUMNS, LEAST_ROWS, LETTERS, ROWS, Raster, Span, grid, pieces, trimmed
from judge.drawing.shapes import Dot, Mark, Panel, Role, Stroke

_MOST_TICKS = 6
_HAIR = 1e-9
_LEAST = 1e-9  # a smaller value stands here on a logarithmic axis


class Axis(NamedTuple):
    """What an axis measures; `text` writes one of its values. A linear axis counts whole things."""

    label: str
    text: Callable[[float], str] = "{:,.6g}".format
    log: bool = False


class Series(NamedTuple):
    """Dots (x, y) by x, joined by a line."""

    name: str
    points: tuple[Dot, ...]
    role: Role


class Chart(NamedTuple):
    """At least one series with two different x."""

    series: tuple[Series, ...]
    x: Axis
    y: Axis


class _Scale:
    """Where the values of an axis are, from 0 to 1, and its round values."""

    def __init__(self, axis: Axis, values: Sequence[float]) -> None:
        self._axis = axis
        self._low, high = min(map(self._level, values)), max(map(self._level, values))
        self._span = (high - self._low) or 1.0

    def _level(self, value: float) -> float:
        return log10(max(_LEAST, value)) if self._axis.log else value

    def __call__(self, value: float) -> float:
        return (self._level(value) - self._low) / self._span

    def ticks(self) -> list[tuple[float, str]]:
        """At most six round values, or the two ends: where they are, and their texts."""
        low, high = self._low, self._low + self._span
        if self._axis.log:
            powers = [digit * 10.0**ten for ten in range(floor(low), ceil(high) + 1) for digit in (1, 2, 5)]
            found = [each for each in powers if low - _HAIR <= log10(each) <= high + _HAIR]
            if len(found) > _MOST_TICKS:
                tens = [each for each in found if abs(log10(each) - round(log10(each))) < _HAIR]
                found = tens[:: ceil(len(tens) / _MOST_TICKS)]
            found = found or [10.0**low, 10.0**high]
        else:
            steps = (digit * 10**ten for ten in count() for digit in (1, 2, 5))
            step = next(each for each in steps if self._span / each < _MOST_TICKS)
            found = [float(at) for at in range(ceil(low / step) * step, floor(high) + 1, step)]
        return [(self(value), self._axis.text(value)) for value in found]


def _scales(chart: Chart) -> tuple[_Scale, _Scale]:
    points = [point for series in chart.series for point in series.points]
    x, y = zip(*points, strict=True)
    return _Scale(chart.x, x), _Scale(chart.y, y)


def chart_braille(chart: Chart, rows: int = ROWS, columns: int = COLUMNS) -> list[list[Span]]:
    """Rows for a terminal, at most `rows` or `LEAST_ROWS`, of at most so many columns or `COLUMNS`."""
    across, up = _scales(chart)
    high = min(max(rows, LEAST_ROWS), ROWS) - 2
    levels = {round((1 - at) * (high - 1)): text for at, text in up.ticks()}
    left = max(map(len, levels.values()), default=0) + 1
    columns = min(columns, COLUMNS)
    raster = Raster(high, columns - left)
    strokes, marks = [], []
    for series in chart.series:
        dots = [(2 * across(a) - 1, 2 * up(b) - 1) for a, b in series.points]
        strokes += [Stroke(pair, series.role) for pair in pairwise(dots)]
        marks += [Mark(dot, series.role, series.name) for dot in dots]
    cells = grid(Panel("", tuple(strokes), tuple(marks), ()), raster)
    drawn = [[Span(f"{levels.get(at, ''):>{left - 1}} "), *pieces(row)] for at, row in cells.items()]
    foot = " " * columns
    for share, said in across.ticks():
        at = min(left + round(share * (raster.wide - 1)), columns - len(said))
        if not foot[max(0, at - 1) : at + len(said)].strip():
            foot = foot[:at] + said + foot[at + len(said) :]
    letters = [LETTERS.get(series.role, series.name[:1]) for series in chart.series]
    named = zip(letters, chart.series, strict=True)
    legend = [Span(f"{letter} {series.name}  ", series.role) for letter, series in named]
    legend.append(Span(f"{chart.y.label} over {chart.x.label}"))
    return [trimmed(row) for row in (*drawn, [Span(foot)], legend)]
