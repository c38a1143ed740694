"""Putting points into a panel, or at its edge where they lie outside; points that meet share a label."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from math import hypot

from judge.drawing.clip import inside
from judge.drawing.frame import Frame, direction, length, rounded
from judge.drawing.lengths import short
from judge.drawing.shapes import Dot, Mark, Role, Stroke
from judge.topics.circles.part import Part
from judge.topics.circles.picture.scene import Scene
from judge.topics.circles.picture.spots import Spot
from judge.topics.circles.picture.strokes import straight

_TOGETHER = 0.035  # marks closer than this share a label
_EDGE = 0.97


def marks_in(frame: Frame, scene: Scene, *, beyond: bool) -> tuple[Mark, ...]:
    """Every point of the scene in the panel; those outside at its edge where `beyond` asks for them."""
    found: list[Mark] = []
    line = straight(frame, scene)
    for spot, role in every_spot(scene):
        at = frame.place(spot.x, spot.y)
        if inside(at):
            found.append(Mark(at, role, spot.text))
        elif (role is Role.GOT and (beyond or not scene.crowded)) or (beyond and role is Role.CASE):
            away = length(spot.x - frame.x, spot.y - frame.y)
            way = direction(rounded(spot.x - frame.x), rounded(spot.y - frame.y))
            text = f"{spot.text}, {distance(scene, away, in_extents=not beyond)}"
            found.append(at_edge(way, role, text, line if role is Role.CASE else ()))
    return merged(found)


def distance(scene: Scene, away: Fraction, *, in_extents: bool) -> str:
    """`3e-5 e away`, or in the caller's units `1e9 away`."""
    if in_extents:
        return f"{short(away / extent(scene))} e away"
    return f"{short(away / (1 << scene.line.shift))} away"


def at_edge(way: Dot, role: Role, text: str, line: tuple[Stroke, ...] = ()) -> Mark:
    """A mark at the panel's edge for a point outside it, which lies in the direction `way`.

    A point of `line` is marked where that leaves the panel.
    """
    for stroke in line:
        (x1, y1), (x2, y2) = stroke.dots[0], stroke.dots[-1]
        size = hypot(x2 - x1, y2 - y1)
        for x, y, u, v in ((x2, y2, x2 - x1, y2 - y1), (x1, y1, x1 - x2, y1 - y2)):
            if max(abs(x), abs(y)) > 1 - 1e-6 and u * way[0] + v * way[1] > 0:
                back = min(1 - _EDGE, size) / size
                return Mark((x - u * back, y - v * back), role, text, (u / size, v / size))
    most = max(abs(way[0]), abs(way[1]))
    return Mark((way[0] / most * _EDGE, way[1] / most * _EDGE), role, text, way)


def extent(scene: Scene) -> Fraction:
    """The case's own size e; 1 where it has none, so that one can divide by it."""
    return Fraction(scene.line.extent or 1)


def every_spot(scene: Scene) -> Iterable[tuple[Spot, Role]]:
    """The points of the case, the wanted ones and the given ones."""
    line = scene.line
    is_circle = scene.part not in (Part.FOOT, Part.NORMAL)
    centre = "C (r = 0)" if is_circle and not line.r else scene.centre
    for place in scene.names or (Spot(Fraction(line.cx), Fraction(line.cy), centre),):
        yield place, Role.CASE
    for at, name in zip((scene.start, scene.end), _names(scene), strict=True):
        if name:
            yield Spot(Fraction(at[0]), Fraction(at[1]), name), Role.CASE
    yield from ((spot, Role.WANTED) for spot in scene.wanted)
    yield from ((spot, Role.GOT) for spot in scene.given)


def _names(scene: Scene) -> tuple[str, str]:
    if scene.part.of_ray:
        return ("O", "O + D (t = 1)") if scene.line.a else ("O (D = 0)", "")
    if scene.part.of_point or scene.pair:
        return "C2" if scene.pair else "P", ""
    return ("A", "B") if scene.line.a else ("A = B", "")


def merged(marks: list[Mark]) -> tuple[Mark, ...]:
    """The same marks; of those in one place the first has the words of all."""
    kept: list[Mark] = []
    for mark in marks:
        close = next((i for i, other in enumerate(kept) if other.text and _together(mark, other)), None)
        if close is None:
            kept.append(mark)
            continue
        first = kept[close]
        shared = first.shared or first.role is not mark.role
        kept[close] = replace(first, text=_joined(first.text, mark.text), shared=shared)
        kept.append(replace(mark, text=""))
    return tuple(kept)


def _together(one: Mark, other: Mark) -> bool:
    if (one.towards is None) != (other.towards is None):
        return False
    return hypot(one.at[0] - other.at[0], one.at[1] - other.at[1]) < _TOGETHER


def _joined(first: str, second: str) -> str:
    if second == "common point" and first.endswith("common point"):
        return first.removesuffix("common point") + "2 common points"
    return f"{first}, {second}"


def points_in(
    frame: Frame, spots: Sequence[tuple[tuple[Fraction, Fraction], Role, str]], *, beyond: bool = True
) -> tuple[Mark, ...]:
    """Every such point in the panel, and with `beyond` those outside at its edge; of those in one place the
    first has the words of all.
    """
    found: list[Mark] = []
    for (x, y), role, text in spots:
        at = frame.place(x, y)
        if inside(at):
            found.append(Mark(at, role, text))
        elif beyond:
            found.append(at_edge(direction(x - frame.x, y - frame.y), role, text))
    return merged(found)
