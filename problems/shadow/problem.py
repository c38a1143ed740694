"""Whether a light reaches the first hit of a ray: exactly, and the promise that nothing is nearly a tie."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import isqrt
from typing import Any

from judge.data.draw import Draw
from judge.topics.circles import SHADOW, Bands, Crowd, builders, circles_ray_and_light
from judge.topics.circles.figures.figure import Figure
from judge.topics.circles.figures.posing import posed
from judge.topics.circles.recipes import lights
from judge.topics.circles.recipes.crowds import level_figure
from judge.topics.circles.shadow import Shade, shade_of


def at_the_light(draw: Draw, *, size: int, poses: Sequence[str], thin: int = 0, **pose: Any) -> Figure:
    """A tiny circle around the light, just before it or just beyond it, or a large one that begins there.

    With `thin` a large one begins so many parts of `size` before the light, or as many beyond it.
    """
    radius, at = draw.integer(size // 4, size), draw.integer(size // 4, size)
    light = at - draw.integer(0, size), draw.sign() * draw.integer(size // 2, 2 * size)
    way = light[0] - at, light[1]
    length = isqrt(way[0] ** 2 + way[1] ** 2)
    tiny = draw.integer(size // 2000, size // 1500)
    kind = draw.choice(("around", "before", "beyond", "large"))
    if thin:
        kind = draw.choice(("large", "after"))
    if kind in ("large", "after"):
        tiny = draw.integer(size // 100, size // 10)
    past = {
        "around": 0,
        "before": -tiny - tiny // 4,
        "beyond": tiny + tiny // 4,
        "large": tiny - size // (thin or 3000),
        "after": tiny + size // (thin or 3000),
    }[kind]
    wall = light[0] + way[0] * past // length, light[1] + way[1] * past // length, tiny
    circles = [(at + radius, 0, radius), wall]
    figure = level_figure(draw, circles if draw.boolean() else circles[::-1], 1, light, shuffled=False)
    return posed(draw, figure, poses=poses, **pose)


def first_close(draw: Draw, *, size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """The ray cuts or misses a circle by little more than the promise; another one stands behind."""
    height, at = draw.integer(size // 4, size), draw.integer(size // 4, size)
    gap = draw.integer(5, 9) * size // 10**7 * draw.sign()
    nearly = at, height * draw.sign(), height + gap
    radius = draw.integer(size // 8, size // 4)
    behind = at + draw.integer(height, 2 * size) + radius, draw.integer(-radius // 2, radius // 2), radius
    # It shines on the one that is nearly hit, and on the back of the other one.
    light = behind[0] + draw.integer(radius, size // 2), -draw.integer(size // 2, size)
    light = light if nearly[1] > 0 else (light[0], -light[1])
    circles = [nearly, behind]
    figure = level_figure(draw, circles if draw.boolean() else circles[::-1], 1, light, shuffled=False)
    return posed(draw, figure, poses=poses, **pose)


OWN = {"at-the-light": at_the_light, "first-close": first_close}
BUILDERS = builders(lights.RECIPES, OWN, adapter=circles_ray_and_light)
TOPIC = SHADOW
ANSWERS = {Shade.NOTHING: None, Shade.LIT: "lit"}


def solve(circles, origin, direction, light, *, bands):
    """lit or dark, None where the ray hits nothing."""
    crowd = Crowd.of(circles, origin, direction, light)
    widths = Bands.of({"snap": Fraction(0), **bands})
    shade, broken = shade_of(crowd, widths, bands["graze"], bands["least_radius"])
    return ANSWERS.get(shade, "dark"), broken
