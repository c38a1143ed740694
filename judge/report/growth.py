"""How CPU time grows with n, drawn: a submission's and the reference's, both scales logarithmic."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from math import log10

from judge.drawing import Picture
from judge.drawing.shapes import Dot, Fact, Mark, Panel, Role, Stroke
from judge.report.values import seconds
from judge.run.result import Growth, GrowthPoint

_LEFT, _RIGHT, _LOW, _HIGH = -0.85, 0.8, -0.8, 0.85  # of the panel, where points are
_AXIS = 0.96
_LEAST = 1e-9  # seconds


def growth_picture(growth: Growth, title: str) -> Picture | None:
    """Time against n, or None where there are no two sizes."""
    points = sorted(growth.points, key=lambda point: point.size)
    if len({point.size for point in points}) < 2:
        return None
    place = _placer(points)
    strokes = [
        Stroke(((-_AXIS, _AXIS), (-_AXIS, -_AXIS), (_AXIS, -_AXIS)), Role.BEYOND),
        *_path(Role.SHAPE, [place(each.size, each.reference_seconds) for each in points]),
        *_path(Role.LINE, [place(each.size, each.cpu_seconds) for each in points]),
    ]
    marks = [
        *(
            Mark(place(each.size, each.reference_seconds), Role.WANTED, seconds(each.reference_seconds))
            for each in points
        ),
        *(Mark(place(each.size, each.cpu_seconds), Role.GOT, _own(each)) for each in points),
    ]
    panel = Panel("Time against n, logarithmic", tuple(strokes), tuple(marks), ())
    facts = (
        Fact("n", ", ".join(f"{each.size:,}" for each in points)),
        Fact("reference", ", ".join(seconds(each.reference_seconds) for each in points), Role.WANTED),
        Fact("yours", ", ".join(map(_own, points)), Role.GOT),
        Fact("growth", f"{growth}; n^{growth.slope:g} more than that is allowed"),
    )
    keys = ("reference", "yours")
    return Picture(title, "how the time of a case grows", f"{growth}.", panel, None, facts, "", keys)


def _own(point: GrowthPoint) -> str:
    return seconds(point.cpu_seconds) if point.ended else f"stopped after {seconds(point.cpu_seconds)}"


def _placer(points: Sequence[GrowthPoint]) -> Callable[[int, float], Dot]:
    """From n and seconds to the panel."""
    times = [max(_LEAST, value) for each in points for value in (each.cpu_seconds, each.reference_seconds)]
    first, last = log10(points[0].size), log10(points[-1].size)
    low, high = log10(min(times)), log10(max(times))

    def place(size: int, value: float) -> Dot:
        x = (log10(size) - first) / (last - first)
        y = (log10(max(_LEAST, value)) - low) / (high - low) if high > low else 0.5
        return _LEFT + (_RIGHT - _LEFT) * x, _LOW + (_HIGH - _LOW) * y

    return place


def _path(role: Role, dots: Sequence[Dot]) -> list[Stroke]:
    return [Stroke(pair, role) for pair in pairwise(dots)]
