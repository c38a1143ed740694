"""How a submission's CPU time grows with n beside the reference's: where everything of the plot is.

Both scales are logarithmic, so a law c·nᵉ is a straight line, and its slope is e.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import ceil, floor, log10

from judge.kata.events import Run
from judge.report.page.parts import GridLine, GrowthDot, GrowthLine, GrowthPlot
from judge.report.page.record import GrowthRecord, PointRecord, read_record
from judge.report.values import seconds

_HEIGHT = 220.0
_MOST_LEVELS = 6


def growth_plot(name: str, runs: Sequence[Run]) -> GrowthPlot | None:
    """The plot of the latest run that tells of its growth; None where none does. `name` begins its ids."""
    for run in reversed(runs):
        growth = read_record(run).time.growth
        if growth is not None and len({point.size for point in growth.points}) >= 2:
            return _plot(name, growth, run.id)
    return None


def _plot(name: str, growth: GrowthRecord, run: int) -> GrowthPlot:
    points = sorted(growth.points, key=lambda point: point.size)
    sizes = log10(points[0].size), log10(points[-1].size)
    times = [max(1e-9, value) for each in points for value in (each.cpu_seconds, each.reference_seconds)]
    low, high = log10(min(times)) - 0.4, log10(max(times)) + 0.3

    slower = points[-1].cpu_seconds > points[-1].reference_seconds

    def across(size: int) -> str:
        return f"{4 + 92 * (log10(size) - sizes[0]) / (sizes[1] - sizes[0]):.2f}%"

    def down(value: float) -> float:
        return round(_HEIGHT * (high - log10(max(1e-9, value))) / (high - low), 1)

    def line(kind: str, label: str, value: Callable[[PointRecord], float]) -> GrowthLine:
        dots = tuple(
            GrowthDot(
                across(each.size), down(value(each)), kind == "own" and not each.ended, _title(each, value)
            )
            for each in points
        )
        return GrowthLine(kind, label, dots, (kind == "own") is slower)

    return GrowthPlot(
        name=name,
        height=_HEIGHT,
        run=run,
        lines=(
            line("ref", f"reference, n^{growth.reference:.1f}", lambda each: each.reference_seconds),
            line("own", f"yours, n^{growth.exponent:.1f}", lambda each: each.cpu_seconds),
        ),
        levels=tuple(GridLine(down(10.0**decade), seconds(10.0**decade)) for decade in _decades(low, high)),
        columns=tuple((across(each.size), f"{each.size:,}") for each in points),
        text=f"it grows like n^{growth.exponent:.1f}, the reference like n^{growth.reference:.1f}; "
        f"n^{growth.slope:g} more than that is allowed",
    )


def _title(point: PointRecord, value: Callable[[PointRecord], float]) -> str:
    return f"n = {point.size:,}: {seconds(value(point))}"


def _decades(low: float, high: float) -> range:
    first, last = ceil(low), floor(high)
    return range(first, last + 1, max(1, ceil((last - first + 1) / _MOST_LEVELS)))
