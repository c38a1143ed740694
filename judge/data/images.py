"""The mirror images of a case and of its target: seven more cases for the price of one.

The symmetries of the square about the origin change signs and swap x and y. In doubles nothing is rounded
by that, and all that a case promises is kept: lengths, the extent (which is a maximum over both axes), the
parameters along the line and so the order of the points. So an image's target is the image of the target, and
needs neither a reference nor a proof; the tests prove it of every group all the same.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from judge.problem import Case, Problem
from judge.problem.model import Point
from judge.values import Target
from judge.values.numbers import Bounds

Image = tuple[Case, Target]
Images = Callable[[Problem, Case, Target, Sequence[int]], list[Image]]

# Numbered as in transform.mirrored: 1 negates x, 2 negates y, 4 then swaps them; 0 would do nothing.
SYMMETRIES = range(1, 8)


def mirror_images(problem: Problem, case: Case, target: Target, symmetries: Sequence[int]) -> list[Image]:
    """The images of a case (cx, cy, r, point or vector, …) under these symmetries that differ from it.

    Of the target they change the points in the plane.
    """
    cx, cy, radius, *pairs = case
    images: list[Image] = []
    seen = [case]
    for symmetry in symmetries:
        image: Case = (*_mirrored((cx, cy), symmetry), radius, *[_mirrored(pair, symmetry) for pair in pairs])
        if image not in seen:
            seen.append(image)
            images.append((image, problem.answer.pairs(target, partial(_mirrored_bounds, symmetry))))
    return images


def _mirrored(point: Point, symmetry: int) -> Point:
    x, y = point
    # Not -x: a zero has no sign in the data, and the image of 0.0 is 0.0.
    if symmetry & 1:
        x = 0 - x
    if symmetry & 2:
        y = 0 - y
    return (y, x) if symmetry & 4 else (x, y)


def _mirrored_bounds(symmetry: int, point: tuple[Bounds, Bounds]) -> tuple[Bounds, Bounds]:
    x, y = point
    if symmetry & 1:
        x = _negative(x)
    if symmetry & 2:
        y = _negative(y)
    return (y, x) if symmetry & 4 else (x, y)


def _negative(target: Bounds) -> Bounds:
    low, high, nearest, residual, ulp = target
    return 0.0 - high, 0.0 - low, 0.0 - nearest, 0.0 - residual, ulp
