"""The sphere and the ray: the exact parameter of the first common point, and the normal there."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from judge.data.draw import Draw
from judge.topics import spheres
from judge.topics.circles import Bands
from judge.topics.spheres import SPHERE, SphereRay
from judge.topics.spheres.figures import Case, Scene, placed
from judge.values import Real

__all__ = ["BUILDERS", "TOPIC", "solve"]
TOPIC = SPHERE


def along_an_axis(draw: Draw, *, octaves: Sequence[int], size: int, scales: Sequence[int]) -> Case:
    """A ray that is off an axis by 2**-octaves (bounds) of its length, from outside or from inside."""
    radius = draw.integer(size // 2, size)
    away, aside = draw.integer(-3 * radius, -2 * radius), draw.integer(-radius // 2, radius // 2)
    origin = (away if draw.integer(0, 2) else 0, aside, draw.integer(-radius // 2, radius // 2))
    low, high = octaves
    direction = (1 << high, draw.sign() << draw.integer(0, high - low), draw.integer(-1, 1))
    scene = Scene((0, 0, 0), radius, origin, direction)
    return placed(draw, scene, poses=("axis",), scale=draw.choice(scales), stretch=(-high, -high)).case


def at_foot(
    draw: Draw, *, where: Sequence[str], size: int, poses: Sequence[str], scales: Sequence[int]
) -> Case:
    """A ray that touches 1e-6 to 1e-5 of the radius from its origin, ahead of it or behind."""
    part = draw.integer(size // 2, size)
    radius, away = part * 10**10, part * draw.integer(10**4, 10**5)
    origin = (-away if draw.choice(where) == "ahead" else away, radius * draw.sign(), 0)
    scene = Scene((0, 0, 0), radius, origin, (draw.integer(1, 6) << 40, 0, 0))
    return placed(draw, scene, poses=poses, scale=draw.choice(scales)).case


BUILDERS = {**spheres.BUILDERS, "at-foot": at_foot, "along-an-axis": along_an_axis}


def solve(centre, radius, origin, direction, *, bands):
    """(t, N) or None; t counts in extents by |D|∞, N in extents by r."""
    ray, widths = SphereRay.of(centre, radius, origin, direction), Bands.of(bands)
    found = ray.first(widths)
    broken = ray.broken(widths, bands["least_radius"])
    if found is None:
        return None, broken
    t, which = found
    unit = Fraction(ray.extent, ray.r)
    normal = tuple(Real(part, unit) for part in ray.normal(which))
    return (Real(t, Fraction(ray.extent, ray.step)), normal), broken
