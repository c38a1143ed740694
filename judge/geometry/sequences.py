"""What is drawn of a case with many frames, rows or rays: the first one that the answer has wrong."""

# mypy: allow-untyped-defs, allow-incomplete-defs

from __future__ import annotations

from decimal import Decimal
from typing import Any

from judge.drawing.shapes import Role
from judge.geometry import marks
from judge.geometry.figures import circle_and_line, many_circles
from judge.geometry.frames import THRESHOLD
from judge.geometry.quadratic import TANGENT
from judge.geometry.view import Plain, Ring, View, Way, numbers, text


def first_wrong_frame(circles, O, D, h, answers=(), **_: Any) -> View | None:
    """The first wrong frame, with the thresholds as circles."""
    at = _differs(answers, len(circles))
    if at is None:
        return None
    (cx, cy, r), view = circles[at], View(about=f"frame {at} of {len(circles)}")
    view.rings.append(Ring(cx, cy, r, decides=None if at else TANGENT))
    view.name((cx, cy), "C")
    view.measure((cx, cy), [O], r)
    if at:
        view.rings += [Ring(cx, cy, r * (1 + side * h), Role.BEYOND, THRESHOLD) for side in (-1, 1)]
    view.ways.append(Way(O, D, None, None, decides=True))
    view.name(O, "O")
    _said(view, answers, at)
    return view


def first_wrong_row(cx, cy, r, A, B, answers=(), **_: Any) -> View | None:
    """The circle of the first wrong row."""
    at = _differs(answers, len(cx))
    if at is None:
        return None
    view = circle_and_line(cx[at], cy[at], r[at], A, B, names="AB")
    view.about = f"circle {at} of {len(cx)}"
    marks.common(view, answers[0][at], Role.WANTED)
    _said(view, answers, at)
    return view


def first_wrong_ray(circles, *rays, answers=(), **_: Any) -> View | None:
    """The first wrong ray or beam."""
    O, ways = rays if len(rays) == 2 else (None, rays[0])
    at = _differs(answers, len(ways))
    if at is None:
        return None
    origin, along = (O, ways[at]) if O else ways[at]
    view = many_circles(circles, origin, along)
    view.about = f"{'beam' if O else 'ray'} {at} of {len(ways)}"
    for answer, role in zip(answers, (Role.WANTED, Role.GOT), strict=True):
        if isinstance(answer, list) and at < len(answer):
            found = numbers(answer[at], 2)
            if found:
                view.name(view.ways[0].at(found[1]), f"{role.said} circle {found[0]:.6g}", role)
    return view


def _differs(answers: Any, most: int) -> int | None:
    """The index of the first element that differs; 0 where none does, None where there is none at all."""
    exact, given = answers
    if not most or not isinstance(exact, list) or not exact:
        return None
    if not isinstance(given, list):
        return 0
    for at, (one, other) in enumerate(zip(exact, given, strict=False)):
        if not _same(one, other):
            return at
    return min(len(given), len(exact) - 1) if len(given) < len(exact) else 0


def _same(one: Plain, other: Plain) -> bool:
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(_same, one, other))
    if isinstance(one, Decimal) and isinstance(other, Decimal):
        return abs(one - other) <= abs(one) * Decimal("1e-6")
    return bool(one == other)


def _said(view: View, answers: Any, at: int) -> None:
    exact, given = answers
    view.about += f": {text(exact[at])} is right"
    if isinstance(given, list) and at < len(given) and not _same(exact[at], given[at]):
        view.about += f", not {text(given[at])}"
