"""Spheres in space, and the rays that meet them.

SPHERE        the topic of problems with the arguments (C, r, O, D), the points and the vector in space
SphereRay     a sphere and a ray in scaled integers: where they meet first, and the normal there

hit.py        the same
simpler.py    simpler cases like a failing one
picture.py    a failing case, seen from two sides
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from judge.problem.topic import Shown, Topic
from judge.topics.spheres.hit import SphereRay
from judge.topics.spheres.simpler import simpler, special

if TYPE_CHECKING:
    from judge.drawing import Picture

__all__ = ["SPHERE", "SphereRay"]


def _picture(shown: Shown) -> Picture | None:
    from judge.topics.spheres.picture import compose  # late: most problems are loaded to be judged, not drawn

    return compose(shown)


SPHERE = Topic(simpler=simpler, special=special, picture=_picture)
