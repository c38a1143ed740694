"""A picture from a problem, a case and two answers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from judge.diagnose.picture.lens import gap_words, lens_panel
from judge.diagnose.picture.scene import Figure, Scene, read_scene
from judge.diagnose.picture.shapes import Fact, Panel, Picture, Role
from judge.diagnose.picture.whole import whole_panel
from judge.diagnose.picture.words import short
from judge.problem import Problem
from judge.values import Exact as Answer


def compose(
    problem: Problem,
    values: Mapping[str, Any],
    exact: Answer,
    *,
    wanted: str | None,
    got: str | None,
    heading: str = "",
) -> Picture | None:
    """The picture of one case, or None where the problem is not about a circle and a line.

    Args:
        problem: the problem, for its parameters, its kind of answer and its bands.
        values: the arguments by parameter name.
        exact: the exact answer.
        wanted: the wanted answer as it is shown to a person.
        got: the submission's answer as it is shown, whatever it was (`given_words` of its JSON form).
        heading: which case it is.
    """
    scene = read_scene(problem, values, exact, got)
    if scene is None:
        return None
    lens = lens_panel(scene)
    facts = [
        Fact("input", ", ".join(f"{name}={_argument(value)}" for name, value in values.items())),
        Fact("wanted", wanted or "", Role.WANTED),
        Fact("got", got or "no answer", Role.GOT),
        Fact("geometry", _situation(scene, exact) + _turned(lens)),
    ]
    description = f"Wanted {wanted}, got {got or 'no answer'}; {gap_words(scene)}."
    return Picture(problem.title, heading, description, whole_panel(scene), lens, tuple(facts))


def _turned(lens: Panel | None) -> str:
    """What a person must know of a lens with two scales."""
    stretched = lens is not None and any(bar.upright for bar in lens.bars)
    return "; the lens is turned so that the line runs level, and stretched across it" if stretched else ""


def _argument(value: Any) -> str:
    if isinstance(value, list | tuple):
        return f"({', '.join(_argument(part) for part in value)})"
    text = repr(value)
    return text if len(text) <= 26 else f"{text[:12]}…{text[-6:]} ({len(text.lstrip('-'))} digits)"


_FIGURES = {Figure.LINE: "A = B: no line", Figure.SEGMENT: "A = B: one point", Figure.RAY: "D = 0: no ray"}


def _situation(scene: Scene, exact: Answer) -> str:
    """The geometry in words; `e` is explained because the lens measures in it."""
    line = scene.line
    parts = [] if line.a else [_FIGURES[scene.figure]]
    parts.append(gap_words(scene))
    banded = exact == 1 or len(scene.wanted) == 1
    if line.a and banded and scene.gap.sign() and abs(scene.gap) <= scene.snap * line.extent:
        parts.append("which counts as tangent here")
    return f"{', '.join(parts)}; e = {short(line.extent_length(), 3)}"
