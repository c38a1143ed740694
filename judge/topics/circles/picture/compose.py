"""A picture from a case and its two answers."""

from __future__ import annotations

from typing import Any

from judge.drawing.lengths import short
from judge.drawing.shapes import Fact, Panel, Picture, Role
from judge.problem.topic import Shown
from judge.topics.circles.part import Part
from judge.topics.circles.picture.lens import gap_words, lens_panel
from judge.topics.circles.picture.scene import Scene, read_scene
from judge.topics.circles.picture.whole import whole_panel
from judge.values import Exact

_LEGEND = "e: the case's own size"


def compose(part: Part, shown: Shown) -> Picture | None:
    """The picture of one case, or None where its arguments are no circle and line."""
    scene = read_scene(part, shown)
    if scene is None:
        return None
    lens = lens_panel(scene)
    got = shown.got or "no answer"
    facts = [
        Fact("input", ", ".join(f"{name}={_argument(value)}" for name, value in shown.values.items())),
        Fact("wanted", shown.wanted or "", Role.WANTED),
        Fact("got", got, Role.GOT),
        Fact("geometry", _situation(scene, shown.exact) + _turned(lens)),
    ]
    description = f"Wanted {shown.wanted}, got {got}; {gap_words(scene)}."
    return Picture(
        shown.problem.title, shown.heading, description, whole_panel(scene), lens, tuple(facts), _LEGEND
    )


def _turned(lens: Panel | None) -> str:
    """What a person must know of a lens with two scales."""
    stretched = lens is not None and any(bar.upright for bar in lens.bars)
    return "; the lens is turned so that the line runs level, and stretched across it" if stretched else ""


def _argument(value: Any) -> str:
    if isinstance(value, list | tuple):
        return f"({', '.join(_argument(part) for part in value)})"
    text = repr(value)
    return text if len(text) <= 26 else f"{text[:12]}…{text[-6:]} ({len(text.lstrip('-'))} digits)"


_NO_LINE = {Part.SEGMENT: "A = B: one point", Part.RAY: "D = 0: no ray"}


def _situation(scene: Scene, exact: Exact) -> str:
    """The geometry in words; `e` is explained because the lens measures in it."""
    line = scene.line
    parts = (
        [] if line.a or scene.part.of_point or scene.pair else [_NO_LINE.get(scene.part, "A = B: no line")]
    )
    parts.append(gap_words(scene))
    on = exact == 0 if scene.part is Part.POINT else scene.part is Part.TANGENTS and len(scene.wanted) == 1
    if on and line.r and scene.gap.sign():
        parts.append("which counts as on it here")
    banded = scene.part not in (Part.FOOT, Part.NORMAL) and (exact == 1 or len(scene.wanted) == 1)
    if line.a and banded and scene.gap.sign() and abs(scene.gap) <= scene.snap * line.extent:
        parts.append("which counts as tangent here")
    return f"{', '.join(parts)}; e = {short(line.extent_length(), 3)}"
