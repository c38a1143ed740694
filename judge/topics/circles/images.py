"""The mirror images of a case and of its target: seven more cases for the price of one.

The symmetries of the square about the origin change signs and swap x and y. In doubles nothing is rounded
by that, and all that a case promises is kept: lengths, the extent (which is a maximum over both axes), the
parameters along the line and so the order of the points. So an image's target is the image of the target, and
needs neither an exact answer nor a proof; the tests prove it of every group all the same.
"""

from __future__ import annotations

from collections.abc import Sequence

from judge.compare.targets import AnyTarget, PointsTarget, Target
from judge.problem import Case, Problem
from judge.problem.topic import Chance, Image
from judge.topics.circles.signature import Change, layout

# Numbered as in figure.mirrored: 1 negates x, 2 negates y, 4 then swaps them; 0 would do nothing.
SYMMETRIES = range(1, 8)
# Not -x: a zero has no sign in the data, and the image of 0.0 is 0.0.
_CHANGES: tuple[Change, ...] = (
    lambda x, y: (x, y),
    lambda x, y: (0 - x, y),
    lambda x, y: (x, 0 - y),
    lambda x, y: (0 - x, 0 - y),
    lambda x, y: (y, x),
    lambda x, y: (y, 0 - x),
    lambda x, y: (0 - y, x),
    lambda x, y: (0 - y, 0 - x),
)


def mirror_images(problem: Problem, case: Case, target: AnyTarget, chance: Chance, most: int) -> list[Image]:
    """The images of a case under `most` symmetries, as `chance` has it; those that differ from it.

    The case is of points, vectors, lengths and radii; the target is one of points, a count or a parameter.
    """
    first, step = chance.integer(0, 6), chance.integer(1, 6)
    return images_under(problem, case, target, [SYMMETRIES[(first + step * n) % 7] for n in range(most)])


def images_under(problem: Problem, case: Case, target: AnyTarget, symmetries: Sequence[int]) -> list[Image]:
    """The images of a case under these symmetries that differ from it."""
    places = layout(problem.parameters)
    images: list[Image] = []
    seen = [case]
    for symmetry in symmetries:
        image = places.mapped(case, _CHANGES[symmetry])
        if image not in seen:
            seen.append(image)
            mirrored = _target(target, symmetry) if isinstance(target, PointsTarget) else target
            images.append((image, mirrored))
    return images


def _target(target: PointsTarget, symmetry: int) -> PointsTarget:
    points = []
    for x, y in target.points:
        if symmetry & 1:
            x = _negative(x)
        if symmetry & 2:
            y = _negative(y)
        points.append((y, x) if symmetry & 4 else (x, y))
    return PointsTarget(tuple(points))


def _negative(target: Target) -> Target:
    low, high, nearest, residual, ulp = target
    return 0.0 - high, 0.0 - low, 0.0 - nearest, 0.0 - residual, ulp
