"""Many circles as three columns of doubles, and one line: how many points each has in common with it.

ROWS               the topic of problems with the arguments (cx, cy, r, A, B), the first three of them arrays
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from judge.problem.topic import Shown, Topic

if TYPE_CHECKING:
    from judge.drawing import Picture

_MOST_DRAWN = 60


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
