"""Scenes for the growth of time with n: crowds that no equal parts of the plane or of all angles part.

crowded(n)    (circles, rays)
arcs(n)       (circles, O, dirs)
"""

from __future__ import annotations

from collections.abc import Callable
from math import isqrt

from judge.data.draw import Draw
from judge.geometry.boxes import Boxes, IntCircle
from judge.geometry.level import Case, maker
from judge.geometry.scenes.many import FASTEST, WIDE, Ray, any_circle, any_point, any_way, outside, scanned


def _until_clear(draw: Draw, boxes: Boxes, make: Callable[[Draw], Ray]) -> Ray:
    while True:
        ray = make(draw)
        if boxes.clear(*ray):
            return ray


@maker
def crowded(draw: Draw, n: int) -> Case:
    """n circles and n/4 rays. Most circles are in two crowds too narrow for equal parts of the plane.

    One crowd is 1/16,000 of the scene wide and 1/250 high, the other wide and low. Of equal cells, up to
    256 × 256 of them, a few have all of it; of up to 65,536 strips along x or y a few have all of one.
    """
    near = max(1, isqrt(131_072 // n))  # circles are the smaller the more there are
    places = [any_point(draw, WIDE * 3 // 4) for _ in range(2)]
    halves = [(60, 4_000), (4_000, 60)]
    scene: list[IntCircle] = [(WIDE * sx, WIDE * sy, 1) for sx in (-1, 1) for sy in (-1, 1)]
    while len(scene) < n:
        which = draw.integer(0, 7)
        if which < 6:
            (x, y), (wide, high) = places[which % 2], halves[which % 2]
            dx, dy = draw.integer(-wide, wide), draw.integer(-high, high)
            scene.append((x + dx, y + dy, draw.integer(near, 3 * near)))
        else:
            scene.append(any_circle(draw, WIDE, (100 * near, 1000 * near)))
    boxes = Boxes(scene)

    def make(draw: Draw) -> Ray:
        if draw.integer(0, 7) == 0:
            return any_point(draw, WIDE), any_way(draw)
        which = draw.integer(0, 1)
        (x, y), (wide, high) = places[which], halves[which]
        way, steps = any_way(draw), draw.integer(50, 200)
        # Across the narrow side, from outside.
        dx, dy = (way[0] or 1, way[1] // 4) if which == 0 else (way[0] // 4, way[1] or 1)
        ends = x + draw.integer(-wide, wide), y + draw.integer(-high, high)
        return (ends[0] - steps * dx, ends[1] - steps * dy), (dx, dy)

    return tuple(scene), tuple(_until_clear(draw, boxes, make) for _ in range(n // 4))


@maker
def arcs(draw: Draw, n: int) -> Case:
    """n circles and n beams. Most circles are in two narrow arcs, all of one about equally far from O.

    An arc covers 1/2,000 of all angles, 1/700 of the scene's width and height. Large circles behind it cover
    all of it: who asks every circle whose angles a beam is within asks one in 64.
    """
    near = max(1, isqrt(131_072 // n))
    across = draw.integer(-300, 300)
    away = draw.integer(800_000, 900_000)
    scene: list[IntCircle] = []
    while len(scene) < n:
        which = draw.integer(0, 7)
        if which < 6:
            x, y = away + draw.integer(0, 2_000), away * across // FASTEST + draw.integer(-1_400, 1_400)
            place = (x, y) if which % 2 else (y, x)
            scene.append((*place, draw.integer(near, 3 * near)))
        elif draw.integer(0, 7) == 0:
            x, y = WIDE + draw.integer(10_000, 40_000), WIDE * across // FASTEST + draw.integer(-9_000, 9_000)
            place = (x, y) if draw.boolean() else (y, x)
            scene.append((*place, draw.integer(60_000, x - away - 5_000)))
        else:
            circle = any_circle(draw, WIDE, (100 * near, 1000 * near))
            if outside(circle) and not (0 < circle[0] < WIDE and abs(circle[1] * 2) < circle[0]):
                scene.append(circle)
    boxes = Boxes(scene)

    def make(draw: Draw) -> Ray:
        if draw.integer(0, 7) == 0:
            return (0, 0), any_way(draw, FASTEST)
        x = draw.integer(FASTEST // 2, FASTEST)
        way = x, x * across // FASTEST + draw.integer(-1, 2)
        return (0, 0), way if draw.boolean() else way[::-1]

    ways = [_until_clear(draw, boxes, make)[1] for _ in range(n)]
    return scanned(scene, (0, 0), ways)
