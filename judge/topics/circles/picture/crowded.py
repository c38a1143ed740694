"""A picture of many circles and rays: the first ray whose answer is wrong, and faintly the others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import cos, pi, sin
from typing import Any

from judge.drawing.clip import inside, polygon, polyline
from judge.drawing.frame import Frame, direction, near
from judge.drawing.lengths import round_below, short
from judge.drawing.shapes import Bar, Fact, Mark, Panel, Picture, Role, Stroke
from judge.exact import Surd
from judge.problem.topic import Shown
from judge.topics.circles.picture.marks import at_edge
from judge.values import AnyOf
from judge.values.decode import Fault, Written, number

IntCircle = tuple[int, int, int]
IntPoint = tuple[int, int]
Ray = tuple[IntPoint, IntPoint]
_Where = tuple[Fraction, Fraction]

MOST_CIRCLES = 600  # more of them are a grey field
_MOST_RAYS = 40
_NAMED = 12  # circles that have their index beside them
_MARGIN = Fraction(9, 8)
_BAR = Fraction(1, 2)
_FAR = 6.0  # panels that a ray is followed
_FARTHEST = Fraction(10**9)
_CLOSE = 1e-6  # relative difference of a t that is no other one


def crowded(shown: Shown) -> Picture | None:
    """The picture, or None where there are too many circles or the arguments are others."""
    circles, rays = _read(shown.values)
    if not circles or not rays or len(circles) > MOST_CIRCLES or len(rays) != len(shown.exact or ()):
        return None
    chosen = _chosen(shown.exact, shown.given)
    (ox, oy), (dx, dy) = rays[chosen]
    wanted = _hits(shown.exact[chosen])
    got = _given(shown.given, chosen)
    frame = _frame(circles, rays[chosen], rays if len(rays) <= _MOST_RAYS else ())
    strokes = [stroke for each in circles for stroke in _ring(frame, each)]
    for place, ray in enumerate(rays[:_MOST_RAYS]):
        strokes += _arrow(frame, ray, Role.BEYOND) if place != chosen else []
    strokes += _arrow(frame, rays[chosen], Role.LINE)
    marks = [_mark(frame, (Fraction(ox), Fraction(oy)), Role.CASE, "O")]
    if len(circles) <= _NAMED:
        centres = [(Fraction(x), Fraction(y)) for x, y, _ in circles]
        marks += [_mark(frame, centre, Role.CASE, str(at)) for at, centre in enumerate(centres)]
    for role, hits in ((Role.WANTED, wanted[:1]), (Role.GOT, [got] if got else [])):
        for index, t in hits:
            marks.append(_mark(frame, _along((ox, oy), (dx, dy), t), role, f"circle {index}"))
    bar = round_below(frame.unit * _BAR)
    panel = Panel("True scale", tuple(strokes), tuple(marks), (Bar(float(bar / frame.unit), short(bar)),))
    said = f"ray {chosen} of {len(rays)}, from ({ox}, {oy}) along ({dx}, {dy}), among {len(circles)} circles"
    first = " or ".join(f"circle {index} at t = {short(t, 6)}" for index, t in wanted) or "no circle"
    other = _words(shown.given, chosen)
    facts = (
        Fact("input", said),
        Fact("wanted", first, Role.WANTED),
        Fact("got", other, Role.GOT),
    )
    return Picture(
        shown.problem.title, shown.heading, f"Wanted {first}, got {other}; {said}.", panel, None, facts
    )


def _read(values: Mapping[str, Any]) -> tuple[list[IntCircle], list[Ray]]:
    circles, *rest = values.values()
    scene = [(x, y, r) for x, y, r in circles]
    if len(rest) == 1:
        return scene, [((o[0], o[1]), (d[0], d[1])) for o, d in rest[0]]
    origin, ways = rest
    return scene, [((origin[0], origin[1]), (dx, dy)) for dx, dy in ways]


# -- the answers -------------------------------------------------------------------------------------------


def _hits(exact: Any) -> list[tuple[int, Surd | Fraction]]:
    """The circles that are first, each with its t."""
    if exact is None:
        return []
    return [(index, t.x) for index, t in (exact.answers if isinstance(exact, AnyOf) else (exact,))]


def _given(given: Any, place: int) -> tuple[int, Fraction] | None:
    """What the submission says of that ray, where it is a circle and a t."""
    item: Any = given[place] if type(given) in (list, tuple) and len(given) > place else ()
    if type(item) not in (list, tuple) or len(item) != 2:
        return None
    index, t = map(number, item)
    if isinstance(index, Fault) or isinstance(t, Fault) or not isinstance(index, int):
        return None
    return index, t.exact() if isinstance(t, Written) else Fraction(t)


def _words(given: Any, place: int) -> str:
    if type(given) not in (list, tuple) or len(given) <= place:
        return "no answer"
    found = _given(given, place)
    if found is None:
        return "no circle" if given[place] is None else "something else"
    return f"circle {found[0]} at t = {short(found[1], 6)}"


def _chosen(exact: Sequence[Any], given: Any) -> int:
    """The first ray whose answer is another one; the first that meets a circle where none is."""
    if type(given) in (list, tuple):
        for place, each in enumerate(exact[: len(given)]):
            if not _alike(_hits(each), _given(given, place), given[place]):
                return place
    return next((place for place, each in enumerate(exact) if each is not None), 0)


def _alike(hits: Sequence[tuple[int, Surd | Fraction]], got: tuple[int, Fraction] | None, raw: Any) -> bool:
    if got is None:
        return not hits and raw is None
    return any(
        got[0] == index and abs(float(t) - float(got[1])) <= _CLOSE * max(abs(float(t)), 1e-9)
        for index, t in hits
    )


# -- the drawing -------------------------------------------------------------------------------------------


def _frame(circles: Sequence[IntCircle], ray: Ray, rays: Sequence[Ray]) -> Frame:
    """A window around all circles and origins."""
    origins = [ray[0], *(origin for origin, _ in rays)]
    xs = [value for x, _, r in circles for value in (x - r, x + r)] + [x for x, _ in origins]
    ys = [value for _, y, r in circles for value in (y - r, y + r)] + [y for _, y in origins]
    side = max(max(xs) - min(xs), max(ys) - min(ys)) or 2
    middle = Fraction(min(xs) + max(xs), 2), Fraction(min(ys) + max(ys), 2)
    return Frame(*middle, Fraction(side, 2) * _MARGIN)


def _ring(frame: Frame, circle: IntCircle) -> list[Stroke]:
    """The disc, faintly filled, and its circle."""
    (x, y), size = frame.place(*circle[:2]), near(circle[2] / frame.unit)
    steps = 60 if size > 0.1 else 20
    turns = [2 * pi * step / steps for step in range(steps)]
    dots = tuple((x + size * cos(turn), y + size * sin(turn)) for turn in turns)
    area = polygon(dots)
    fill = [Stroke(area, Role.SHAPE, filled=True)] if area else []
    return fill + [Stroke(part, Role.SHAPE) for part in polyline((*dots, dots[0]))]


def _arrow(frame: Frame, ray: Ray, role: Role) -> list[Stroke]:
    """The ray as far as it can be seen; the faint ones are short."""
    (x, y), (u, v) = frame.place(*ray[0]), direction(*ray[1])
    reach = _FAR if role is Role.LINE else 0.12
    parts = polyline(((x, y), (x + u * reach, y + v * reach)))
    return [Stroke(part, role, arrow=True) for part in parts]


def _along(origin: IntPoint, way: IntPoint, t: Surd | Fraction) -> _Where:
    """O + t·D, near enough for a drawing."""
    at = Fraction(float(max(-_FARTHEST, min(_FARTHEST, t))))
    return origin[0] + at * way[0], origin[1] + at * way[1]


def _mark(frame: Frame, at: _Where, role: Role, text: str) -> Mark:
    dot = frame.place(*at)
    if inside(dot):
        return Mark(dot, role, text)
    return at_edge(direction(at[0] - frame.x, at[1] - frame.y), role, text)
