"""Putting points into a panel, or at its edge where they lie outside; points that meet share a label."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction
from math import hypot

from judge.diagnose.picture.clip import inside
from judge.diagnose.picture.frame import Frame, length
from judge.diagnose.picture.scene import Figure, Scene, Spot
from judge.diagnose.picture.shapes import Dot, Mark, Role, Stroke
from judge.diagnose.picture.words import short

_TOGETHER = 0.035  # marks closer than this share a label
_EDGE = 0.97


def marks_in(frame: Frame, scene: Scene, *, beyond: bool) -> tuple[Mark, ...]:
    """Every point of the scene in the panel; those outside at its edge where `beyond` asks for them."""
    found: list[Mark] = []
    line = frame.straight(scene)
    for spot, role in every_spot(scene):
        at = frame.place(spot.x, spot.y)
        if inside(at):
            found.append(Mark(at, role, spot.text))
        elif role is Role.GOT or (beyond and role is Role.CASE):
            away = length(spot.x - frame.x, spot.y - frame.y)
            text = f"{spot.text}, {distance(scene, away, in_extents=not beyond)}"
            found.append(at_edge(at, role, text, line if role is Role.CASE else ()))
    return merged(found)


def distance(scene: Scene, away: Fraction, *, in_extents: bool) -> str:
    """`3e-5 e away`, or in the caller's units `1e9 away`."""
    if in_extents:
        return f"{short(away / extent(scene))} e away"
    return f"{short(away / (1 << scene.line.shift))} away"


def at_edge(at: Dot, role: Role, text: str, line: tuple[Stroke, ...] = ()) -> Mark:
    """A mark at the panel's edge for a point outside it: where `line`, if it is on one, leaves the panel."""
    size = hypot(*at)
    ends = [dot for stroke in line for dot in (stroke.dots[0], stroke.dots[-1])]
    exits = [(x, y) for x, y in ends if max(abs(x), abs(y)) > 1 - 1e-6 and x * at[0] + y * at[1] > 0]
    x, y = max(exits, key=lambda dot: dot[0] * at[0] + dot[1] * at[1], default=at)
    most = max(abs(x), abs(y))
    edge = (x / most * _EDGE, y / most * _EDGE)
    return Mark(edge, role, text, (at[0] / size, at[1] / size))


def extent(scene: Scene) -> Fraction:
    """The case's own size e; 1 where it has none, so that one can divide by it."""
    return Fraction(scene.line.extent or 1)


def every_spot(scene: Scene) -> Iterable[tuple[Spot, Role]]:
    """The points of the case, the wanted ones and the given ones."""
    line = scene.line
    yield Spot(Fraction(line.cx), Fraction(line.cy), "C" if line.r else "C (r = 0)"), Role.CASE
    for at, name in zip((scene.start, scene.end), _names(scene), strict=True):
        if name:
            yield Spot(Fraction(at[0]), Fraction(at[1]), name), Role.CASE
    yield from ((spot, Role.WANTED) for spot in scene.wanted)
    yield from ((spot, Role.GOT) for spot in scene.given)


def _names(scene: Scene) -> tuple[str, str]:
    if scene.figure is Figure.RAY:
        return ("O", "O + D (t = 1)") if scene.line.a else ("O (D = 0)", "")
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
