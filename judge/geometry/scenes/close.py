"""Scenes of rays and beams in whole numbers that nearly touch: by 1 to 8 times 1e-7 of a size that a circle
far away makes. Directions are irrational, for there whole numbers come nearer than by 1.

    nearly((3, 6), 4_000)          (circles, rays)
    narrow((2, 4), 4_000)          (circles, O, dirs)
"""

from __future__ import annotations

from math import gcd, isqrt

from judge.data.draw import Draw
from judge.geometry.boxes import IntCircle, IntPoint
from judge.geometry.level import Case, maker, near_gap
from judge.geometry.scenes.many import (
    FASTEST,
    TRIPLES,
    WIDE,
    Bounds,
    Ray,
    any_point,
    any_way,
    scanned,
    turned,
)
from judge.geometry.scenes.signs import across

_FINE = 1 << 20  # parts of a unit in which a near miss is drawn
_TRIES = 60


@maker
def nearly(draw: Draw, rays: Bounds, reach: int) -> Case:
    """Rays from anywhere that nearly touch a circle, nearly begin on one, or meet two at nearly one place."""
    far = draw.integer(900_000, WIDE) * draw.sign()
    scene: list[IntCircle] = [(far, 0, 1)]
    found: list[Ray] = []
    for _ in range(draw.integer(*rays)):
        O = any_point(draw, WIDE // 20)
        way, rows = draw.choice((_just_off, _just_off, _just_beside, _just_beside, _just_behind))(
            draw, reach, abs(far - O[0])
        )
        scene += [(O[0] + x, O[1] + y, r) for x, y, r in rows]
        found.append((O, way))
    return tuple(scene), tuple(found)


def _just_off(draw: Draw, reach: int, size: int) -> tuple[IntPoint, list[IntCircle]]:
    """A way from (0, 0), and a circle that it nearly touches; it makes the size itself where that is less."""
    p, q = draw.integer(200, FASTEST), draw.integer(200, FASTEST)
    way = p // gcd(p, q), q // gcd(p, q)
    square = way[0] ** 2 + way[1] ** 2
    r, steps = draw.integer(reach // 4, reach), draw.integer(1, 2 + 2 * reach // sum(way))
    size = max(size, r, *map(abs, across(way, isqrt(r * r * square), steps)))
    gap = near_gap(draw, size * _FINE) * draw.sign()
    product = isqrt((r * _FINE + gap) ** 2 * square) // _FINE + (gap > 0)
    return _anyhow(draw, way, [(*across(way, product, steps), r)])


def _just_beside(draw: Draw, reach: int, size: int) -> tuple[IntPoint, list[IntCircle]]:
    """Any way from (0, 0), and a circle that is nearly there."""
    for _ in range(_TRIES):
        r, gap = draw.integer(reach // 4, reach), near_gap(draw, size * _FINE) * draw.sign()
        x = draw.integer(r // 2, r - 1)
        y = isqrt((r + (gap > 0)) ** 2 - x * x) + draw.integer(0, 1)
        off = abs(isqrt((x * x + y * y) * _FINE * _FINE) - r * _FINE) - 1
        if abs(gap) // 2 < off < abs(gap) and off * 10**7 > size * _FINE:
            return _anyhow(draw, any_way(draw), [(x, y, r)])
    return draw.reject()


def _just_behind(draw: Draw, reach: int, size: int) -> tuple[IntPoint, list[IntCircle]]:
    """A level way from (0, 0), and two circles that it enters at nearly one place."""
    at = reach + draw.integer(1, reach)  # where the first one is entered
    for _ in range(_TRIES):
        (p, q, c), k = draw.choice(TRIPLES), draw.integer(1, reach // 25)
        r = draw.integer(reach // 4, reach)
        y = draw.integer(r // 4, r // 2) * draw.sign()
        gap = near_gap(draw, max(size, at + r, at + k * p) * _FINE)
        half = isqrt((r * r - y * y) * _FINE * _FINE)
        part, most = half % _FINE, gap + gap // 4
        if gap <= part <= most or gap <= _FINE - part <= most:
            return _anyhow(
                draw, (draw.integer(1, 99), 0), [(at + k * p, k * q, k * c), (at + round(half / _FINE), y, r)]
            )
    return draw.reject()


def _anyhow(draw: Draw, way: IntPoint, rows: list[IntCircle]) -> tuple[IntPoint, list[IntCircle]]:
    """The same, turned by quarters and mirrored, in any order."""
    quarters, side = draw.integer(0, 3), draw.sign()
    rows = [turned((x, side * y, r), quarters) for x, y, r in rows]  # type: ignore[misc]  # circles
    return turned((way[0], side * way[1]), quarters), rows[:: draw.sign()]  # type: ignore[return-value]


@maker
def narrow(draw: Draw, beams: Bounds, reach: int) -> Case:
    """Beams that nearly touch a circle, or meet two at nearly one place; often one far off makes the size."""
    far = draw.choice((0, 0, 0, draw.integer(900_000, WIDE) * draw.sign()))
    scene: list[IntCircle] = [(far, draw.integer(9, 99) * 4_000, 1)] if far else []
    ways: list[IntPoint] = []
    for _ in range(draw.integer(*beams)):
        (p, q), rows = draw.choice((_just_off, _just_off, _just_behind))(draw, reach, abs(far))
        scene += rows
        ways.append((p, q) if p * rows[0][0] + q * rows[0][1] > 0 else (-p, -q))
    return scanned(scene, any_point(draw, reach), ways)
