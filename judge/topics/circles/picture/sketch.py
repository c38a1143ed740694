"""A picture of first steps: one panel at true scale, and the numbers that decide."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from math import cos, pi, sin
from typing import Any

from judge.drawing.clip import polygon, polyline
from judge.drawing.frame import Frame, direction, near, root
from judge.drawing.lengths import round_below, short
from judge.drawing.shapes import Bar, Fact, Panel, Picture, Role, Stroke
from judge.exact import Surd
from judge.problem.topic import Shown
from judge.topics.circles.picture.given import read_given
from judge.topics.circles.picture.marks import points_in
from judge.topics.circles.plane import Kind, cross_product, scalar_product

Point = tuple[Fraction, Fraction]
IntPoint = tuple[int, int]

_MARGIN = Fraction(5, 4)
_BAR = Fraction(1, 2)
_REACH = 4.0  # how far a line is followed, in panels


def sketch(kind: Kind, shown: Shown) -> Picture:
    """The picture of one case."""
    points: dict[str, IntPoint] = {
        name: (value[0], value[1]) for name, value in shown.values.items() if isinstance(value, list | tuple)
    }
    values: dict[str, Any] = {**shown.values, **points}
    pair = list(points.values())[:2]
    circle = _circle(kind, values, pair)
    spots = [(_fractions(at), Role.CASE, name) for name, at in points.items()]
    if "cx" in values:
        spots.append(((Fraction(values["cx"]), Fraction(values["cy"])), Role.CASE, "C"))
    if isinstance(shown.exact, tuple):
        spots.append((_fractions(shown.exact), Role.WANTED, "wanted"))
        spots += [(at, Role.GOT, "got") for at in read_given(shown.given).points[:1]]
    frame = _frame([at for at, role, _ in spots if role is not Role.GOT], circle)
    strokes = (*_ring(frame, circle), *_straight(frame, kind, pair))
    bar = round_below(frame.unit * _BAR)
    panel = Panel("True scale", strokes, points_in(frame, spots), (Bar(float(bar / frame.unit), short(bar)),))
    said = _WORDS[kind](values)
    facts = (
        Fact("input", ", ".join(f"{name}={value}" for name, value in values.items())),
        Fact("wanted", shown.wanted or "", Role.WANTED),
        Fact("got", shown.got or "no answer", Role.GOT),
        Fact("geometry", said),
    )
    description = f"Wanted {shown.wanted}, got {shown.got or 'no answer'}; {said}."
    return Picture(shown.problem.title, shown.heading, description, panel, None, facts)


def _fractions(point: Sequence[int]) -> Point:
    return Fraction(point[0]), Fraction(point[1])


def _circle(kind: Kind, values: Mapping[str, Any], pair: Sequence[IntPoint]) -> tuple[Point, Fraction] | None:
    """The centre and the radius, the latter to three digits where it is a root."""
    if kind in (Kind.CIRCLE, Kind.CROSSING):
        return (Fraction(values["cx"]), Fraction(values["cy"])), Fraction(values["r"])
    if kind is not Kind.DIAMETER:
        return None
    (ax, ay), (bx, by) = pair
    return (Fraction(ax + bx, 2), Fraction(ay + by, 2)), root(Fraction(_square(*pair), 4))


def _square(p: IntPoint, q: IntPoint) -> int:
    return (q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2


def _frame(points: Sequence[Point], circle: tuple[Point, Fraction] | None) -> Frame:
    """A window around all of it."""
    xs, ys = ([point[axis] for point in points] for axis in (0, 1))
    if circle is not None:
        (x, y), radius = circle
        xs += [x - radius, x + radius]
        ys += [y - radius, y + radius]
    side = max(max(xs) - min(xs), max(ys) - min(ys)) or Fraction(2)
    return Frame((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2, side / 2 * _MARGIN)


def _ring(frame: Frame, circle: tuple[Point, Fraction] | None) -> tuple[Stroke, ...]:
    """The disc, faintly filled, and its circle."""
    if circle is None:
        return ()
    (x, y), size = frame.place(*circle[0]), near(circle[1] / frame.unit)
    turns = [2 * pi * step / 120 for step in range(120)]
    dots = tuple((x + size * cos(turn), y + size * sin(turn)) for turn in turns)
    area = polygon(dots)
    fill = (Stroke(area, Role.SHAPE, filled=True),) if area else ()
    return (*fill, *(Stroke(part, Role.SHAPE) for part in polyline((*dots, dots[0]))))


def _straight(frame: Frame, kind: Kind, pair: Sequence[IntPoint]) -> tuple[Stroke, ...]:
    """What joins the first two points: the line with its direction, or no more than the way between them."""
    if kind is Kind.CIRCLE or pair[0] == pair[1]:
        return ()
    start, end = (frame.place(*point) for point in pair)
    between = tuple(Stroke(part, Role.LINE, arrow=kind is Kind.SIDE) for part in polyline((start, end)))
    if kind in (Kind.DISTANCE, Kind.DIAMETER):
        return between
    u, v = direction(pair[1][0] - pair[0][0], pair[1][1] - pair[0][1])
    far = [(end[0] + u * _REACH, end[1] + v * _REACH), (start[0] - u * _REACH, start[1] - v * _REACH)]
    whole = Role.BEYOND if kind is Kind.SIDE else Role.LINE
    beyond = [part for at, to in zip((end, start), far, strict=True) for part in polyline((at, to))]
    return (*(Stroke(part, whole) for part in beyond), *between)


# -- the geometry in words ---------------------------------------------------------------------------------


def _distance(values: Mapping[str, Any]) -> str:
    p, q = values["P"], values["Q"]
    return f"from P to Q it is {q[0] - p[0]} along x and {q[1] - p[1]} along y"


def _side(values: Mapping[str, Any]) -> str:
    cross = cross_product(values["A"], values["B"], values["P"])
    where = "to the left of A→B" if cross > 0 else "to the right of A→B" if cross < 0 else "on the line"
    return f"P is {where}"


def _place(gap: int) -> str:
    return "outside the circle" if gap > 0 else "inside the circle" if gap < 0 else "on the circle"


def _on_circle(values: Mapping[str, Any]) -> str:
    square, radius = _square((values["cx"], values["cy"]), values["P"]), values["r"]
    return f"P is {_place(square - radius * radius)}: |P − C|² = {square}, r² = {radius * radius}"


def _on_diameter(values: Mapping[str, Any]) -> str:
    a, b, p = values["A"], values["B"], values["P"]
    twice = _square((a[0] + b[0], a[1] + b[1]), (2 * p[0], 2 * p[1]))
    return f"P is {_place(scalar_product(a, b, p))}: |2P − A − B|² = {twice}, |B − A|² = {_square(a, b)}"


def _foot(values: Mapping[str, Any]) -> str:
    a, b = values["A"], values["B"]
    return f"the line is level, y = {a[1]}" if a[1] == b[1] else f"the line is upright, x = {a[0]}"


def _crossing(values: Mapping[str, Any]) -> str:
    centre, a, b = (values["cx"], values["cy"]), values["A"], values["B"]
    distance = Surd(0, abs(cross_product(a, b, centre)), _square(a, b), _square(a, b))
    return f"the line passes C at a distance of {short(distance, 6)}, and r = {values['r']}"


_WORDS: Mapping[Kind, Callable[[Mapping[str, Any]], str]] = {
    Kind.DISTANCE: _distance,
    Kind.SIDE: _side,
    Kind.CIRCLE: _on_circle,
    Kind.DIAMETER: _on_diameter,
    Kind.FOOT: _foot,
    Kind.CROSSING: _crossing,
}
