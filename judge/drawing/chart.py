"""The one chart: lines of dots over two axes, linear or logarithmic, as SVG and in braille.

    Chart("CPU time of a case", (Series("reference", ((500, 0.01), (8000, 0.16)), Role.WANTED),), x, y)

On logarithmic axes a power law is a straight line, and its slope is the power.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import count, pairwise
from math import ceil, floor, log10
from typing import NamedTuple

from judge.drawing.braille import COLUMNS, LEAST_ROWS, LETTERS, ROWS, Piece, Raster, grid, pieces, trimmed
from judge.drawing.shapes import Dot, Mark, Panel, Role, Stroke
from judge.drawing.svg import element, text, words

_MOST_TICKS = 6
_HAIR = 1e-9
_LEAST = 1e-9  # a smaller value stands here on a logarithmic axis
_HEIGHT, _TOP, _BELOW = 210, 24, 44  # pixels: of the plot, above it, and below it for the labels
_LEFT, _WIDTH = 14, 82  # percent of the chart's width
_LETTERS = 38  # of labels below the axis that a phone has room for
_CLASSES = {Role.WANTED: ("wanted", "t-wanted"), Role.GOT: ("got", "t-got")}


class Axis(NamedTuple):
    """What an axis measures; `text` writes one of its values. A linear axis counts whole things."""

    label: str
    text: Callable[[float], str] = "{:,.6g}".format
    log: bool = False


class Series(NamedTuple):
    """Dots (x, y) by x, joined by a line. At the x in `bounds` y is only a lower bound: the dot is hollow."""

    name: str
    points: tuple[Dot, ...]
    role: Role
    bounds: frozenset[float] = frozenset()


class Chart(NamedTuple):
    """At least one series with two different x; `about` says in a sentence what the chart shows."""

    title: str
    series: tuple[Series, ...]
    x: Axis
    y: Axis
    about: str = ""


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


def chart_svg(chart: Chart) -> str:
    """An SVG element as wide as its place in a page that holds `style()`."""
    across, up = _scales(chart)

    def x(value: float) -> str:
        return f"{_LEFT + _WIDTH * value:.2f}%"

    def y(value: float) -> str:
        return f"{_TOP + _HEIGHT * (1 - value):.1f}"

    bottom = _TOP + _HEIGHT
    parts = [f'<rect class="panel" width="100%" height="{bottom + _BELOW}"/>']
    for at, said in up.ticks():
        level = f'y1="{y(at)}" y2="{y(at)}"'
        parts.append(f'<line class="leader" stroke-opacity="0.4" x1="0" x2="100%" {level}/>')
        parts.append(text("8", f"{float(y(at)) - 4:.1f}", said, "halo quiet", "start"))
    marks = across.ticks()
    for at, said in marks[:: ceil(sum(len(said) + 2 for _, said in marks) / _LETTERS)]:
        parts.append(text(x(at), str(bottom + 18), said, "quiet", "middle"))
    parts.append(text("50%", str(bottom + 36), f"{chart.y.label} over {chart.x.label}", "quiet", "middle"))
    highest = max(chart.series, key=lambda series: series.points[-1][1])
    for series in chart.series:
        line, fill = _CLASSES.get(series.role, ("line", "case"))
        spots = [(x(across(a)), y(up(b))) for a, b in series.points]
        for (x1, y1), (x2, y2) in pairwise(spots):
            parts.append(f'<line class="{line}" x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}"/>')
        for (a, b), (cx, cy) in zip(series.points, spots, strict=True):
            least, kind = ("at least ", line) if a in series.bounds else ("", fill)
            told = words(f"{series.name}, {chart.x.text(a)}: {least}{chart.y.text(b)}")
            parts.append(f'<circle class="{kind}" cx="{cx}" cy="{cy}" r="4"><title>{told}</title></circle>')
        label = float(spots[-1][1]) + (-11 if series is highest else 21)
        parts.append(text(spots[-1][0], f"{label:.1f}", series.name, f"halo {fill}", "end"))
    name = words(f"{chart.title}. {chart.about}" if chart.about else chart.title)
    return element(f'aria-label="{name}" width="100%" height="{bottom + _BELOW}"', parts)


def chart_braille(chart: Chart, rows: int = ROWS, columns: int = COLUMNS) -> list[list[Piece]]:
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
    drawn = [[Piece(f"{levels.get(at, ''):>{left - 1}} "), *pieces(row)] for at, row in cells.items()]
    foot = " " * columns
    for share, said in across.ticks():
        at = min(left + round(share * (raster.wide - 1)), columns - len(said))
        if not foot[max(0, at - 1) : at + len(said)].strip():
            foot = foot[:at] + said + foot[at + len(said) :]
    letters = [LETTERS.get(series.role, series.name[:1]) for series in chart.series]
    named = zip(letters, chart.series, strict=True)
    legend = [Piece(f"{letter} {series.name}  ", series.role) for letter, series in named]
    legend.append(Piece(f"{chart.y.label} over {chart.x.label}"))
    return [trimmed(row) for row in (*drawn, [Piece(foot)], legend)]
