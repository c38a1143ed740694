"""Many circles as three columns of doubles, and one line: how many points each has in common with it.

ROWS               the topic of problems with the arguments (cx, cy, r, A, B), the first three of them arrays
counts(…)          the exact counts, and what is broken
"""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot
from typing import TYPE_CHECKING, Any

from judge.problem.topic import Shown, Topic
from judge.topics.circles.bands import Bands
from judge.topics.circles.line import CircleLine

if TYPE_CHECKING:
    from judge.drawing import Picture

Point = tuple[float, float]

_CLEAR = 4e-7  # of a circle's extent: far beyond the promise's band and what doubles lose, which is 1e-14
_MOST_DRAWN = 60


def counts(
    cx: Sequence[float], cy: Sequence[float], r: Sequence[float], start: Point, end: Point, bands: Bands
) -> tuple[list[int], str | None]:
    """0, 1 or 2 for each circle by its own extent, and why the first that breaks the promise does.

    Doubles decide what is far from a touch, integers the others. A and B must differ.
    """
    (ax, ay), (bx, by) = start, end
    dx, dy = bx - ax, by - ay
    length = hypot(dx, dy)
    found, broken = [], None
    for place, (x, y, radius) in enumerate(zip(cx, cy, r, strict=True)):
        fx, fy = ax - x, ay - y
        gap = abs(dx * fy - dy * fx) / length - radius
        extent = max(radius, abs(fx), abs(fy), abs(bx - x), abs(by - y))
        if gap > _CLEAR * extent:
            found.append(0)
        elif -gap > _CLEAR * extent:
            found.append(2)
        else:
            line = CircleLine.through(x, y, radius, start, end)
            found.append(bands.count(line) or 0)
            if broken is None and (why := bands.broken_count(line)):
                broken = f"circle {place}: {why}"
    return found, broken


def _picture(shown: Shown) -> Picture | None:
    """The first circle that is counted wrongly, as a case of its own."""
    from judge.topics.circles import LINE

    cx, cy, r, start, end = shown.values.values()
    if LINE.picture is None or not cx or len(cx) > _MOST_DRAWN or not shown.exact:
        return None
    place = _chosen(shown.exact, shown.given)
    values = {"cx": cx[place], "cy": cy[place], "r": r[place], "A": start, "B": end}
    exact = shown.exact[place]
    answer: Any = shown.given
    given = answer[place] if _is_list(answer, len(shown.exact)) else None
    got = shown.got if given is None else str(given)
    heading = f"{shown.heading}, circle {place}" if shown.heading else f"circle {place}"
    return LINE.picture(
        Shown(shown.problem, values, exact, str(exact), got, given, heading),
    )


def _chosen(exact: Sequence[int], given: Any) -> int:
    if not _is_list(given, len(exact)):
        return 0
    return next(
        (place for place, (one, other) in enumerate(zip(exact, given, strict=True)) if one != other), 0
    )


def _is_list(given: Any, size: int) -> bool:
    return type(given) in (list, tuple) and len(given) == size


ROWS = Topic(picture=_picture)
