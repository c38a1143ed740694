"""A submission's own thresholds beside the band and the promise: where everything of the plot is.

Both scales are logarithmic: across the size of a figure, upwards the threshold as a share of that size. So
the band and the promise are level, and what follows the size is level too; a fixed number falls from left to
right.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, floor, log10

from judge.kata.history import Run
from judge.problem import Verdict
from judge.report.page.parts import GridLine, ThresholdDot, ThresholdPlot
from judge.report.page.record import read_record
from judge.report.thresholds import number, threshold_text, worth_telling
from judge.run.thresholds import Flip, Threshold

_HEIGHT = 220.0
_LOWEST, _HIGHEST = -17, -1  # decades of a share
_EVERY = 4  # decades between two lines
_MOST_COLUMNS = 5


def threshold_plot(name: str, runs: Sequence[Run]) -> ThresholdPlot | None:
    """The plot of the latest run with a threshold worth telling; None where there is none."""
    for run in reversed(runs):
        thresholds = read_record(run).thresholds
        told = worth_telling(thresholds, accepted=run.verdict is Verdict.AC)
        if told is not None:
            return _plot(name, told, run.id)
        if thresholds:
            return None  # what an older run had wrong is mended
    return None


def _plot(name: str, told: Threshold, run: int) -> ThresholdPlot:
    across = _Across([flip.size for flip in told.figures])
    return ThresholdPlot(
        name=name,
        height=_HEIGHT,
        run=run,
        dots=tuple(_dot(flip, across) for flip in told.figures),
        levels=tuple(_level(decade) for decade in range(_LOWEST + 1, _HIGHEST + 1, _EVERY)),
        columns=tuple(across.columns()),
        free=(_down(told.beyond), _down(told.within)) if told.within else None,
        size=told.size,
        text=threshold_text(told),
    )


def _level(decade: int) -> GridLine:
    return GridLine(_down(10.0**decade), number(10.0**decade))


def _down(share: float) -> float:
    """Pixels from the top."""
    decade = min(max(log10(share), _LOWEST), _HIGHEST) if share else _LOWEST
    return round(_HEIGHT * (_HIGHEST - decade) / (_HIGHEST - _LOWEST), 1)


def _dot(flip: Flip, across: _Across) -> ThresholdDot:
    """A hollow one is a bound: it turns below what can be told from rounding, or beyond what was asked."""
    open_ = not flip.low or flip.high is None
    return ThresholdDot(across(flip.size), _down((flip.gap or flip.high or 0.0) / flip.size), open_)


class _Across:
    """The horizontal scale, in percent of the width."""

    def __init__(self, sizes: Sequence[float]) -> None:
        self._low, self._high = floor(log10(min(sizes))) - 0.5, ceil(log10(max(sizes))) + 0.5

    def __call__(self, size: float) -> str:
        return f"{(log10(size) - self._low) / (self._high - self._low) * 100:.2f}%"

    def columns(self) -> list[tuple[str, str]]:
        """Some powers of ten, 1 among them where it is in sight, with their labels."""
        step = ceil((self._high - self._low) / _MOST_COLUMNS)
        decades = [each for each in range(ceil(self._low), floor(self._high) + 1) if each % step == 0]
        return [(self(10.0**decade), number(10.0**decade)) for decade in decades]
