"""The mirror images of a case and of its target: seven more cases for the price of one.

The symmetries of the square about the origin change signs and swap x and y. In doubles nothing is rounded
by that, and all that a case promises is kept: lengths, the extent (which is a maximum over both axes), the
parameters along the line and so the order of the points. So an image's target is the image of the target, and
needs neither an exact answer nor a proof; the tests prove it of every group all the same.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from judge.problem import Case, Problem
from judge.problem.topic import Chance, Image
from judge.topics.circles.signature import Change, layout
from judge.values import Target
from judge.values.numbers import Bounds

# Numbered as in figure.mirrored: 1 negates x, 2 negates y, 4 then swaps them; 0 would do nothing.
SYMMETRIES = range(1, 8)
TURNS = (3, 5, 6)  # those that keep what is left on the left
# Not -x: a zero has no sign in the data, and the image of 0.0 is 0.0.
_CHANGES: tuple[Change, ...] = (
    lambda p: (p[0], p[1]),
    lambda p: (0 - p[0], p[1]),
    lambda p: (p[0], 0 - p[1]),
    lambda p: (0 - p[0], 0 - p[1]),
    lambda p: (p[1], p[0]),
    lambda p: (p[1], 0 - p[0]),
    lambda p: (0 - p[1], p[0]),
    lambda p: (0 - p[1], 0 - p[0]),
)


def mirror_images(problem: Problem, case: Case, target: Target, chance: Chance, most: int) -> list[Image]:
    """The images of a case under `most` symmetries, as `chance` has it; those that differ from it.

    The case is of points, vectors, lengths and radii; of the target they change the points in the plane.
    """
    first, step = chance.integer(0, 6), chance.integer(1, 6)
    return images_under(problem, case, target, [SYMMETRIES[(first + step * n) % 7] for n in range(most)])


def turned_images(problem: Problem, case: Case, target: Target, _chance: Chance, most: int) -> list[Image]:
    """The same for answers in which left and right are told apart: turned by quarters, never mirrored."""
    return images_under(problem, case, target, TURNS[:most])


def images_under(problem: Problem, case: Case, target: Target, symmetries: Sequence[int]) -> list[Image]:
    """The images of a case under these symmetries that differ from it."""
    places = layout(problem.parameters)
    images: list[Image] = []
    seen = [case]
    for symmetry in symmetries:
        image = places.mapped(case, _CHANGES[symmetry])
        if image not in seen:
            seen.append(image)
            images.append((image, problem.answer.pairs(target, partial(_mirrored, symmetry))))
    return images


def _mirrored(symmetry: int, point: tuple[Bounds, Bounds]) -> tuple[Bounds, Bounds]:
    x, y = point
    if symmetry & 1:
        x = _negative(x)
    if symmetry & 2:
        y = _negative(y)
    return (y, x) if symmetry & 4 else (x, y)


def _negative(bounds: Bounds) -> Bounds:
    low, high, nearest, residual, ulp = bounds
    return 0.0 - high, 0.0 - low, 0.0 - nearest, 0.0 - residual, ulp
