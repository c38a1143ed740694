"""Problems with the arguments (circles, rays) or (circles, O, directions), all of them whole numbers.

MANY                                         their topic
unsound_circle, unsound_ray, unsound_beams   what of the statement's own bounds these break
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from judge.problem.topic import Shown, Topic
from judge.topics.circles.cells import IntCircle, IntPoint

if TYPE_CHECKING:
    from judge.drawing import Picture

FASTEST = 1000  # the largest coordinate of a direction


def unsound_circle(circles: Sequence[IntCircle]) -> str | None:
    """Which of them has no radius, for a person."""
    return next((f"circle {at} has r = 0" for at, each in enumerate(circles) if each[2] < 1), None)


def unsound_ray(ray: tuple[IntPoint, IntPoint]) -> str | None:
    """What is wrong with a ray's direction."""
    _, (dx, dy) = ray
    if not dx and not dy:
        return "a ray has the direction (0, 0)"
    if max(abs(dx), abs(dy)) > FASTEST:
        return f"a ray has the direction ({dx}, {dy}), beyond {FASTEST}"
    return None


def unsound_beams(circles: Sequence[IntCircle], origin: IntPoint, ways: Sequence[IntPoint]) -> str | None:
    """What of a scan breaks the statement's bounds: O in a disc, a direction that is none or out of order."""
    ox, oy = origin
    for at, (x, y, r) in enumerate(circles):
        if (x - ox) ** 2 + (y - oy) ** 2 <= r * r:
            return f"O is in circle {at}, or on it"
    for way in ways:
        if broken := unsound_ray((origin, way)):
            return broken
    for at, (one, other) in enumerate(pairwise(ways)):
        if _before(other, one):
            return f"direction {at + 1} comes after a greater angle"
    return None


def _before(one: IntPoint, other: IntPoint) -> bool:
    """Whether the angle of `one`, above −π and up to π, is less than that of `other`."""
    first, second = _half(one), _half(other)
    if first != second:
        return first < second
    return one[0] * other[1] - one[1] * other[0] > 0


def _half(way: IntPoint) -> int:
    """0 for angles below 0, 1 for those from 0 up to π, 2 for π itself."""
    x, y = way
    if y < 0:
        return 0
    return 2 if y == 0 and x < 0 else 1


def _picture(shown: Shown) -> Picture | None:
    from judge.topics.circles.picture.crowded import crowded  # late: most problems are judged, not drawn

    return crowded(shown)


MANY = Topic(picture=_picture)
