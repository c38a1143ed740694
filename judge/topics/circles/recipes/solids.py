"""Programs of set operations on the discs of a scene: what of a ray is inside the solid.

A builder draws a scene by a recipe of crowds.py, and then a program of one of these `forms` for its discs:

    union, intersection   all discs, in any order
    difference            the first disc less all others; swapped, the last one less the union of the rest
    either                what is in one of the first two discs and not in both, and in any of the others
    mixed                 any operations, in any order and nesting; a disc may be there twice
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from inspect import Parameter, Signature, signature
from typing import Any

from judge.data.draw import Draw, require
from judge.problem import Case
from judge.topics.circles.figures.figure import Recipe
from judge.topics.circles.signature import circles_and_ray
from judge.topics.circles.solids import DIFFERENCE, INTERSECTION, UNION

_MOST = 63  # steps of a program


def solid_builders(recipes: Mapping[str, Recipe]) -> dict[str, Callable[..., Case]]:
    """A problem's BUILDERS: each recipe's scene with a program for its discs, as (circles, O, D, program)."""
    return {name: _programmed(recipe) for name, recipe in recipes.items()}


def _programmed(recipe: Recipe) -> Callable[..., Case]:
    def builder(draw: Draw, *, forms: Sequence[str], **parameters: Any) -> Case:
        circles, origin, direction = circles_and_ray(recipe(draw, **parameters))
        return circles, origin, direction, draw_program(draw, len(circles), draw.choice(forms))

    drawn, *others = signature(recipe).parameters.values()
    named = [drawn, Parameter("forms", Parameter.KEYWORD_ONLY), *others]
    builder.__signature__ = Signature(named)  # type: ignore[attr-defined]  # what problem.toml is held against
    return builder


def draw_program(draw: Draw, discs: int, form: str) -> tuple[int, ...]:
    """A program of that form for so many discs."""
    numbers = list(range(discs))
    if form == "mixed":
        program = _mixed(draw, numbers)
    elif form == "either" and discs > 1:
        program = [0, 1, UNION, 0, 1, INTERSECTION, DIFFERENCE]
        program += [step for each in numbers[2:] for step in (each, UNION)]
    elif form == "swapped" and discs > 1:
        program = [discs - 1, *_folded(numbers[:-1], UNION), DIFFERENCE]
    else:
        operations = {"union": UNION, "intersection": INTERSECTION, "difference": DIFFERENCE}
        require(form in operations or form in ("either", "swapped"), f"{form!r} is a form of programs")
        program = _folded(numbers, operations.get(form, UNION))
    if len(program) > _MOST:
        draw.reject()
    return tuple(program)


def _folded(numbers: Sequence[int], operation: int) -> list[int]:
    first, *rest = numbers
    return [first, *(step for each in rest for step in (each, operation))]


def _mixed(draw: Draw, numbers: list[int]) -> list[int]:
    """Any nesting: discs are pushed as long as there are any, and taken together by chance."""
    waiting = [*numbers, *(each for each in numbers if draw.integer(0, 4) == 0)]
    program: list[int] = []
    depth = 0
    while waiting:
        program.append(waiting.pop(draw.integer(0, len(waiting) - 1)))
        depth += 1
        while depth > 1 and (not waiting or draw.boolean()):
            program.append(draw.choice((UNION, INTERSECTION, DIFFERENCE, DIFFERENCE)))
            depth -= 1
    return program
