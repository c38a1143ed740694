"""The time ratio over the attempts: where everything of the plot is.

Across in percent, so that the plot is as wide as the page; down in pixels, so that its words keep their size.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import ceil, floor, log10

from judge.kata.events import Run
from judge.problem import Verdict
from judge.report.page.parts import Dot, GridLine, Plot
from judge.report.page.record import RatioRecord, read_record
from judge.report.values import counted, times

MOST = 40  # runs: more could not be told apart on a phone
_HEIGHT = 200.0
_PHONE = 270  # pixels that the axis has there at least
_ROOM = 1.35  # above the highest and below the lowest
_STEPS = ((1.0,), (1.0, 3.0), (1.0, 2.0, 5.0))
_MOST_LEVELS = 6


def ratio_plot(name: str, runs: Sequence[Run], limit: float | None) -> Plot | None:
    """The plot of these runs, oldest first, or None where none of them was timed. `name` begins its ids."""
    # What passed on some groups only took the time of these.
    runs = [run for run in runs if run.whole or run.verdict is not Verdict.AC]
    timed = [run for run in runs if run.ratio is not None and run.ratio > 0]
    shown = timed[-MOST:]
    if not shown:
        return None
    spreads = [_spread(run) for run in shown]
    values = [1.0, *([limit] if limit else [])]
    values += [value for spread in spreads for value in (spread.low, spread.median, spread.high)]
    scale = _Scale(min(values) / _ROOM, max(values) * _ROOM)
    every = ceil(len(shown) * (8 * len(str(shown[-1].id)) + 10) / _PHONE)  # so that labels do not meet
    dots = tuple(
        Dot(
            f"{(place + 0.5) / len(shown) * 100:.2f}%",
            scale(spread.median),
            scale(spread.high),
            scale(spread.low),
            _kind(run, spread),
            str(run.id) if (len(shown) - 1 - place) % every == 0 else "",
            run.id,
        )
        for place, (run, spread) in enumerate(zip(shown, spreads, strict=True))
    )
    return Plot(
        name=name,
        height=_HEIGHT,
        dots=dots,
        links=tuple(pairwise(dots)),
        levels=tuple(GridLine(scale(value), f"{_plain(value)} ×") for value in scale.levels()),
        limit=GridLine(scale(limit), f"limit {_plain(limit)} ×") if limit else None,
        description=_words(shown, limit),
        left_out=len(timed) - len(shown),
        held=_held(shown),
    )


class _Scale:
    """A logarithmic scale, upwards."""

    def __init__(self, low: float, high: float) -> None:
        self._low, self._high = log10(low), log10(high)

    def __call__(self, value: float) -> float:
        share = (log10(value) - self._low) / (self._high - self._low)
        return round(_HEIGHT * (1 - share), 1)

    def levels(self) -> list[float]:
        """Round values within it: as many as can be labelled."""
        found: list[float] = []
        for steps in _STEPS:
            exponents = range(floor(self._low), floor(self._high) + 1)
            values = [step * 10.0**exponent for exponent in exponents for step in steps]
            finer = [value for value in values if self._low <= log10(value) <= self._high]
            if not found or len(finer) <= _MOST_LEVELS:
                found = finer
        return found


def _spread(run: Run) -> RatioRecord:
    """The run's ratio with its quartiles; where these cannot be read, the median stands for all."""
    median = run.ratio or 1.0
    kept = read_record(run).time.ratio
    if kept is None or not 0 < kept.low <= median <= kept.high:
        return RatioRecord(median, median, median, 1)
    return kept


def _kind(run: Run, spread: RatioRecord) -> str:
    if run.verdict is not Verdict.AC:
        return "tle"
    return "doubt" if spread.unreliable else "ac"


def _held(runs: Sequence[Run]) -> str:
    """Which runs were held to the reference of another language: `Runs 3, 4: no reference in Go: …`."""
    found: dict[str, list[str]] = {}
    for run in runs:
        reference = read_record(run).time.reference
        if reference is not None and reference.why:
            found.setdefault(reference.why, []).append(str(run.id))
    told = (f"{'run' if len(ids) == 1 else 'runs'} {', '.join(ids)}: {why}" for why, ids in found.items())
    return "; ".join(told)


def _words(runs: Sequence[Run], limit: float | None) -> str:
    """The plot for who does not see it."""
    ratios = [(run.ratio or 0.0, run.id) for run in runs]
    (least, fastest), (most, slowest) = min(ratios), max(ratios)
    bound = f" The limit is {_plain(limit)} times." if limit else ""
    if len(runs) == 1:
        return f"One timed run, run {fastest}, took {times(least)} times the reference's CPU time.{bound}"
    return (
        f"CPU time of {counted(len(runs), 'timed run')} as a multiple of the reference's: from "
        f"{times(ratios[0][0])} times in run {ratios[0][1]} to {times(ratios[-1][0])} times in run "
        f"{ratios[-1][1]}; least {times(least)} (run {fastest}), most {times(most)} (run {slowest}).{bound}"
    )


def _plain(value: float) -> str:
    return f"{value:,.6g}" if value < 1e6 else times(value)
