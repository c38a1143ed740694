"""A picture from a case and its two answers."""

from __future__ import annotations

from typing import Any

from judge.drawing.lengths import short
from judge.drawing.shapes import Fact, Panel, Picture, Role
from judge.problem.topic import Shown
from judge.topics.circles.part import Part
from judge.topics.circles.picture.crowd import crowd_scene, crowd_words
from judge.topics.circles.picture.lens import gap_words, lens_panel
from judge.topics.circles.picture.scene import Scene, read_scene
from judge.topics.circles.picture.whole import whole_panel
from judge.values import Exact

LEGEND = "e: the case's own size"


def compose(part: Part, shown: Shown) -> Picture | None:
    """The picture of one case, or None where its arguments are no circle and line."""
    scene = crowd_scene(part, shown) if part.of_crowd else read_scene(part, shown)
    if scene is None:
        return None
    lens = lens_panel(scene)
    got = shown.got or "no answer"
    facts = [
        Fact("input", ", ".join(f"{name}={argument_text(value)}" for name, value in shown.values.items())),
        Fact("wanted", shown.wanted or "", Role.WANTED),
        Fact("got", got, Role.GOT),
        Fact("geometry", _said(part, scene, shown.exact) + _turned(lens)),
    ]
    said = crowd_words(scene, part, shown.exact) if part.of_crowd else gap_words(scene)
    description = f"Wanted {shown.wanted}, got {got}; {said}."
    return Picture(
        shown.problem.title, shown.heading, description, whole_panel(scene), lens, tuple(facts), LEGEND
    )


def _turned(lens: Panel | None) -> str:
    """What a person must know of a lens with two scales."""
    stretched = lens is not None and any(bar.upright for bar in lens.bars)
    return "; the lens is turned so that the line runs level, and stretched across it" if stretched else ""


def argument_text(value: Any) -> str:
    """An argument, a number of very many digits cut in the middle."""
    if isinstance(value, list | tuple):
        return f"({', '.join(argument_text(part) for part in value)})"
    text = repr(value)
    return text if len(text) <= 26 else f"{text[:12]}…{text[-6:]} ({len(text.lstrip('-'))} digits)"


def _said(part: Part, scene: Scene, exact: Exact) -> str:
    if part.of_crowd:
        e = short(scene.line.extent_length(), 3)
        return f"{crowd_words(scene, part, exact)}; nearest to a touch, {gap_words(scene)}; e = {e}"
    return _situation(scene, exact)


def _no_line(part: Part) -> str:
    if part.of_ray:
        return "D = 0: no ray"
    return "A = B: one point" if part is Part.SEGMENT else "A = B: no line"


def _situation(scene: Scene, exact: Exact) -> str:
    """The geometry in words; `e` is explained because the lens measures in it."""
    line = scene.line
    parts = [] if line.a or scene.part.of_point or scene.pair else [_no_line(scene.part)]
    parts.append(gap_words(scene))
    on = exact == 0 if scene.part is Part.POINT else scene.part is Part.TANGENTS and len(scene.wanted) == 1
    if on and line.r and scene.gap.sign():
        parts.append("which counts as on it here")
    banded = scene.part not in (Part.FOOT, Part.NORMAL) and (exact == 1 or len(scene.wanted) == 1)
    banded = banded or (scene.part.of_vectors and scene.met == 0)
    if line.a and banded and scene.gap.sign() and abs(scene.gap) <= scene.snap * line.extent:
        parts.append("which counts as tangent here")
    return f"{', '.join(parts)}; e = {short(line.extent_length(), 3)}"
