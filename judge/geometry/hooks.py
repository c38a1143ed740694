"""The hooks of the katas: a case drawn, made simpler, dragged about, and asked about on a quiz card."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from judge.problem import Case, Problem
from judge.problem.declare import Hooks
from judge.problem.topic import Chance, Puzzle, Shown, Topic

if TYPE_CHECKING:
    from judge.drawing import Picture

# What a case shows, by the name that it has among the figures.
LINE, SEGMENT, CHORD, RAY, POINT, TANGENTS = "LINE", "SEGMENT", "CHORD", "RAY", "POINT", "TANGENTS"
NORMAL, REFLECTION, SPHERE, PAIR, COMMON = "HIT", "BOUNCE", "SPHERE", "PAIR", "COMMON"
FOOT, NORMAL_FORM, FRAMES, ROWS, MANY = "FOOT", "NORMAL", "FRAMES", "ROWS", "MANY"
HITS, SPANS, SHADOW, OUTLINE = "HITS", "SPANS", "SHADOW", "OUTLINE"
BALLS, WALL = "motion BALLS", "motion WALL"
# Of the first steps, in whole numbers.
DISTANCE, SIDE, CIRCLE, DIAMETER = "plane DISTANCE", "plane SIDE", "plane CIRCLE", "plane DIAMETER"
CROSSING, AXIS_FOOT, SEVEN = "plane CROSSING", "plane FOOT", "SEVEN"
_WIDTHS = {"snap": Fraction(1, 10**12), "clear": Fraction(1, 10**7)}  # of what the figures draw as touching


def hooks(view: str, *, promise: bool = True) -> Hooks:
    """The hooks of a kata that shows this; without a promise nothing is too close to be a case."""
    widths = _WIDTHS if promise else {}

    def topic() -> Topic:
        return _topic(view)

    def picture(shown: Shown) -> Picture | None:
        draw = topic().picture
        return draw(replace(shown, problem=replace(shown.problem, bands=widths))) if draw else None

    def simpler(problem: Problem, case: Case) -> Iterable[Case]:
        make = topic().simpler
        return make(problem, case) if make else ()

    def explore(problem: Problem, values: Mapping[str, Any] | None) -> str | None:
        page = topic().explore
        return page(replace(problem, bands=widths), values) if page else None

    def puzzle(form: str, chance: Chance, solve: Callable[..., Any]) -> Puzzle | None:
        make = topic().puzzle
        return make(form, chance, solve) if make else None

    return Hooks(picture, simpler, explore, puzzle)


def _topic(view: str) -> Topic:
    """What draws it, imported when it is wanted: most problems are judged, not drawn."""
    from judge.topics import circles

    name, _, kind = view.partition(" ")
    if name == "motion":
        from judge.topics.circles import motion

        moving: Topic = getattr(motion, kind)
        return moving
    if kind:
        return circles.plane(circles.Kind[kind])
    if name == "SEVEN":
        from judge.topics.circles import seven

        return seven.SEVEN
    if name == "FRAMES":
        from judge.topics.circles import frames

        return frames.FRAMES
    if name == "MANY":
        from judge.topics.circles import many

        return many.MANY
    if name == "ROWS":
        from judge.topics.circles import rows

        return rows.ROWS
    if name == "SPHERE":
        from judge.topics import spheres

        return spheres.SPHERE
    topic: Topic = getattr(circles, name)
    return topic
