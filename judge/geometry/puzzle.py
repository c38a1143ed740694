"""Small figures for quiz cards: a few circles in whole numbers, and a ray or a line across them.

A reference for one circle answers for each of them; what comes first is compared exactly. Figures in which
two things happen nearly together, or a line nearly touches, are drawn anew: a person should see the answer.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from decimal import Decimal
from itertools import pairwise
from math import hypot
from typing import Any

from msgspec import Struct

from judge.drawing import Picture
from judge.exact import Surd
from judge.geometry.picture import bare
from judge.geometry.view import Ring, View, Way
from judge.problem.declare import InvalidCase
from judge.problem.topic import Chance, Puzzle
from judge.values import Real

IntPoint = tuple[int, int]
Solve = Callable[..., Any]
_UNCLEAR = object()

_LABELS = "ABCD"
_TRIES = 2_000
_APART = 0.5  # between two events along the line, and between a line and a touch
_REACH = (7, 5)  # of the centres
_FAR = 9  # of the origin
_TAGS = {"i": "in", "o": "out", "t": "touch"}
_LETTERS = {"enter": "i", "exit": "o", "touch": "t"}


class _Ring(Struct, frozen=True):
    """A circle of the figure."""

    label: str
    x: int
    y: int
    r: int

    @property
    def words(self) -> str:
        return f"circle {self.label}: centre ({self.x}, {self.y}), radius {self.r}"


class _Event(Struct, frozen=True):
    """Something that happens along the line: where, by what grows with t, and to whom."""

    at: Surd
    ring: str
    tag: str


class _Figure(Struct, frozen=True):
    rings: tuple[_Ring, ...]
    start: IntPoint
    along: IntPoint

    @property
    def clear(self) -> bool:
        """Whether the line touches each circle exactly or by no means, and the start is on none."""
        (x, y), (u, v) = self.start, self.along
        for ring in self.rings:
            gap = abs(u * (ring.y - y) - v * (ring.x - x)) / hypot(u, v) - ring.r
            touching = (u * (ring.y - y) - v * (ring.x - x)) ** 2 == ring.r**2 * (u * u + v * v)
            if not touching and abs(gap) < _APART:
                return False
            if abs(hypot(ring.x - x, ring.y - y) - ring.r) < _APART:
                return False
        return True


def puzzle(kind: str, form: str, chance: Chance, solve: Solve) -> Puzzle | None:
    """A figure for that form of cards, about cases of that kind; None where there is none."""
    make = {"ray": _ray_puzzle, "points": _line_puzzle, "line": _line_puzzle, "hits": _hits_puzzle}.get(kind)
    return make(form, chance, solve) if make else None


def _ray_puzzle(form: str, chance: Chance, solve: Solve) -> Puzzle | None:
    """Which circle a ray meets first, or all of them in their order."""
    if form not in ("first-hit", "order"):
        return None
    for _ in range(_TRIES):
        figure = _figure(chance, 4)
        found = _hits(figure, solve) if figure.clear else None
        if found is None or len(found) < (1 if form == "first-hit" else 2):
            continue
        answer = tuple(event.ring for event in found)
        words = {ring.label: "" for ring in figure.rings}
        one = form == "first-hit"
        shown = answer[:1] if one else answer
        return Puzzle(_given(figure), _picture(figure, ("O", ""), ray=True), words, shown, one, _told(found))
    return None


def _line_puzzle(form: str, chance: Chance, solve: Solve) -> Puzzle | None:
    """Where a line enters circles, leaves them, and touches them, in the order of its direction."""
    if form != "tags":
        return None
    for _ in range(_TRIES):
        figure = _figure(chance, 3)
        found = _crossings(figure, solve) if figure.clear else None
        if not found:
            continue
        (x, y), (u, v) = figure.start, figure.along
        last = f"the line from P = ({x}, {y}) through Q = ({x + u}, {y + v})"
        given = (*(ring.words for ring in figure.rings), last)
        answer = tuple(event.tag for event in found)
        why = ", ".join(f"{event.ring} {_TAGS[event.tag]}" for event in found)
        return Puzzle(given, _picture(figure, ("P", "Q"), ray=False), _TAGS, answer, why=f"{why}.")
    return None


def _hits_puzzle(form: str, chance: Chance, solve: Solve) -> Puzzle | None:
    """Where a ray enters circles, leaves them, and touches them; `solve` answers for all circles at once."""
    if form != "tags":
        return None
    for _ in range(_TRIES):
        figure = _figure(chance, 4)
        found = _every_hit(figure, solve) if figure.clear else None
        if not found or len(found) < 2:
            continue
        answer = tuple(event.tag for event in found)
        why = ", ".join(f"{event.ring} {_TAGS[event.tag]} at t = {float(event.at):.3g}" for event in found)
        picture = _picture(figure, ("O", ""), ray=True)
        return Puzzle(_given(figure), picture, _TAGS, answer, why=f"{why}.")
    return None


def _given(figure: _Figure) -> tuple[str, ...]:
    """The circles and the ray in words."""
    (x, y), (u, v) = figure.start, figure.along
    return (*(ring.words for ring in figure.rings), f"the ray from O = ({x}, {y}) along D = ({u}, {v})")


def _figure(chance: Chance, most: int) -> _Figure:
    wide, high = _REACH
    rings: list[_Ring] = []
    for label in _LABELS[: chance.integer(2, most)]:
        x, y = chance.integer(-wide, wide), chance.integer(-high, high)
        rings.append(_Ring(label, x, y, chance.integer(1, 3)))
    start = chance.integer(-_FAR, _FAR), chance.integer(-high, high)
    along = chance.integer(-3, 3), chance.integer(-3, 3)
    near = any(
        max(abs(one.x - other.x), abs(one.y - other.y)) < 2
        for place, one in enumerate(rings)
        for other in rings[:place]
    )
    return _Figure(tuple(rings), start, along) if any(along) and not near else _figure(chance, most)


def _answer(solve: Solve, *case: Any) -> Any:
    """The exact answer; _UNCLEAR where the case breaks the problem's promise."""
    try:
        return solve(*case)
    except InvalidCase:
        return _UNCLEAR


def _hits(figure: _Figure, solve: Solve) -> list[_Event] | None:
    """The first hit of each circle that the ray meets, in order; None where two are too close to tell."""
    events = []
    for ring in figure.rings:
        answer = _answer(solve, ring.x, ring.y, ring.r, figure.start, figure.along)
        if not isinstance(answer, Real | None):
            return None
        if answer is not None:
            events.append(_Event(Surd.of(answer.x), ring.label, ""))
    return _in_order(events, hypot(*figure.along))


def _crossings(figure: _Figure, solve: Solve) -> list[_Event] | None:
    """What happens on the line, in order; None where two things are too close to tell, or the answers are
    no points.
    """
    (x, y), (u, v) = figure.start, figure.along
    axis = 0 if abs(u) >= abs(v) else 1
    forward, length = (1 if (u, v)[axis] > 0 else -1), hypot(u, v) / abs((u, v)[axis])
    events = []
    for ring in figure.rings:
        answer = _answer(solve, ring.x, ring.y, ring.r, (x, y), (x + u, y + v))
        if not isinstance(answer, list):
            return None
        tags = ("t",) if len(answer) == 1 else ("i", "o")
        for point, tag in zip(answer, tags, strict=False):
            events.append(_Event(Surd.of(point[axis].x) * forward, ring.label, tag))
    return _in_order(events, length)


def _every_hit(figure: _Figure, solve: Solve) -> list[_Event] | None:
    """Every hit of the ray, in order; None where two of them are too close to tell."""
    circles = [(ring.x, ring.y, ring.r) for ring in figure.rings]
    answer = _answer(solve, circles, figure.start, figure.along)
    if answer is _UNCLEAR or any(not isinstance(hit, tuple) for hit in answer):  # a run of hits at one place
        return None
    events = [
        _Event(Surd.of(place.x), figure.rings[index].label, _LETTERS[tag]) for place, index, tag in answer
    ]
    return _in_order(events, hypot(*figure.along))


def _in_order(events: Sequence[_Event], scale: float) -> list[_Event] | None:
    """The events by place; `scale` makes a length of what they are placed by."""
    found = sorted(events, key=lambda event: event.at)
    gaps = [float(after.at) - float(before.at) for before, after in pairwise(found)]
    return found if all(gap * scale >= _APART for gap in gaps) else None


def _told(events: Sequence[_Event]) -> str:
    hits = ", ".join(f"{event.ring} at t = {float(event.at):.3g}" for event in events)
    return f"The ray meets {hits}."


# -- the picture -------------------------------------------------------------------------------------------


def _picture(figure: _Figure, names: tuple[str, str], *, ray: bool) -> Picture:
    view = View()
    for ring in figure.rings:
        x, y, r = map(Decimal, (ring.x, ring.y, ring.r))
        view.rings.append(Ring(x, y, r))
        view.name((x, y), ring.label)
    (x, y), along = map(Decimal, figure.start), (Decimal(figure.along[0]), Decimal(figure.along[1]))
    way = Way((x, y), along, 0 if ray else None, None)
    view.ways.append(way)
    for at, name in ((way.start, names[0]), (way.at(1), names[1])):
        if name:
            view.name(at, name)
    return bare(view)
