"""Recipes of many circles and many rays in whole numbers.

Each gives a case (circles, rays). `circles` and `rays` are how many, from … to; `size` is half the side of
the square that centres and origins are drawn from, `radii` from … to. With `clear` every ray is drawn until
its answer is far from where it turns: in a big case some ray would always break the promise.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import gcd, isqrt

from judge.data.draw import Draw
from judge.problem import Case
from judge.topics.circles.cells import Cells, IntCircle, IntPoint
from judge.topics.circles.many import FASTEST
from judge.topics.circles.recipes.brushes import brushed, steep

IntRay = tuple[IntPoint, IntPoint]


def field(
    draw: Draw,
    *,
    circles: Sequence[int],
    rays: Sequence[int],
    size: int,
    radii: Sequence[int],
    aimed: bool = False,
    clear: bool = False,
) -> Case:
    """Circles anywhere, rays from anywhere; with `aimed` every other one goes towards a circle."""
    scene = [_circle(draw, size, radii) for _ in range(draw.integer(*circles))]
    cells = Cells(scene)
    found = []
    for number in range(draw.integer(*rays)):
        while True:
            origin = _point(draw, size)
            aim = draw.choice(scene) if aimed and number % 2 else None
            ray = origin, _towards(draw, origin, aim) if aim else _way(draw)
            if not clear or cells.sight(*ray).clear:
                break
        found.append(ray)
    return tuple(scene), tuple(found)


def inside(
    draw: Draw, *, circles: Sequence[int], rays: Sequence[int], size: int, radii: Sequence[int]
) -> Case:
    """Every ray starts inside a circle, and other circles lie around, inside and across it."""
    scene = [_circle(draw, size, radii) for _ in range(draw.integer(*circles))]
    found = []
    for _ in range(draw.integer(*rays)):
        x, y, r = draw.choice(scene)
        reach = max(0, 2 * r // 3 - 1)
        found.append(((x + draw.integer(-reach, reach), y + draw.integer(-reach, reach)), _way(draw)))
    return tuple(scene), tuple(found)


def ties(draw: Draw, *, rays: Sequence[int], size: int) -> Case:
    """Circles that a ray meets at once: copies, mirror images in it, one in another; touches; origins on one.

    And circles that it cuts or misses by 1, beside one so far away that this is a millionth of the extent.
    Each ray has a strip of its own, far from the others. All is along an axis, or else turned and scaled by
    a triple p² + q² = r², which keeps whole numbers and every tie.
    """
    scene: list[tuple[int, int, int, int]] = []  # x, y, r, and by how much the scaled radius differs
    found: list[IntRay] = []
    for number in range(draw.integer(*rays)):
        x, y = draw.integer(-size, size), 12 * size * number
        p, q, r = draw.choice(_TRIPLES)
        kind = draw.choice(("copies", "mirrored", "nested", "touch", "both", "on-circle", "graze"))
        side = draw.sign()
        ahead = x + size + r + draw.integer(1, size)
        scene += {
            "copies": [(ahead, y + q, r, 0)] * 2,
            "mirrored": [(ahead, y + q, r, 0), (ahead, y - q, r, 0)],
            "nested": [(ahead + p, y + q * side, r, 0), (ahead + 2 * p, y + 2 * q * side, 2 * r, 0)],
            "touch": [(ahead, y + r * side, r, 0)],
            "both": [(ahead, y + r, r, 0), (ahead + p, y - q, r, 0)],
            "on-circle": [(x + p * side, y + q * draw.sign(), r, 0)],
            "graze": [(ahead, y + side * size, size, draw.sign())],
        }[kind]
        scene.append((ahead + 3 * size + draw.integer(1, size), y, draw.integer(1, r), 0))
        found.append(((x, y), (draw.integer(1, 9), 0)))
    times = (1, 0, 1) if draw.boolean() else draw.choice(_TRIPLES)
    circles = [(*_scaled((x, y), times), r * times[2] + more) for x, y, r, more in scene]
    far = draw.integer(900_000, 1_000_000), -90 * size, 1
    circles.insert(draw.integer(0, len(circles)), far)
    if draw.boolean():
        circles.reverse()
    quarters = draw.integer(0, 3)
    turned = [
        (_turned(_scaled(origin, times), quarters), _turned(_scaled(way, times), quarters))
        for origin, way in found
    ]
    return tuple(_turned(each, quarters) for each in circles), tuple(turned)


def brushing(draw: Draw, *, rays: Sequence[int], apart: int) -> Case:
    """Rays that touch a circle within the band but not exactly; one circle far away makes the extent.

    The rays begin `apart` from each other. Behind some of the circles is another one that the ray cuts.
    """
    away = draw.integer(1_000_000, 1_040_000)
    scene = [(away * draw.sign(), draw.integer(-apart, apart), draw.integer(1, 9))]
    found = []
    for number in range(draw.integer(*rays)):
        way = steep(draw)
        x, y, r = brushed(draw, way, away)
        origin = draw.integer(-9, 9), apart * number
        scene.append((x + origin[0], y + origin[1], r))
        if draw.boolean():
            scene.append((x + origin[0] + 9 * way[0], y + origin[1] + 9 * way[1], 2 * r))
        found.append((origin, way))
    if draw.boolean():
        scene.reverse()
    return tuple(scene), tuple(found)


def leaving(draw: Draw, *, rays: Sequence[int], size: int) -> Case:
    """Rays in any direction from a place on a circle, and from its centre, there with a D of two lengths.

    Each has a strip of its own, far from the others, with another circle that it may meet later.
    """
    scene: list[IntCircle] = []
    found: list[IntRay] = []
    for number in range(draw.integer(*rays)):
        x, y = draw.integer(-size, size), 12 * size * number
        p, q, r = draw.choice(_TRIPLES)
        times = draw.integer(1, size // r)
        p, q = draw.choice(((p, q), (q, p)))
        middle = x + draw.sign() * p * times, y + draw.sign() * q * times
        scene.append((*middle, r * times))
        way = draw.integer(-99, 99), draw.integer(-99, 99)
        if way == (0, 0):
            draw.reject()
        scene.append(
            (x + 3 * _signed(way[0], size), y + 3 * _signed(way[1], size), draw.integer(size, 2 * size))
        )
        found.append(((x, y), way))
        found += [(middle, (way[0] * length, way[1] * length)) for length in (1, draw.integer(2, 9))]
    return tuple(scene), tuple(found)


def mixed(
    draw: Draw,
    *,
    circles: Sequence[int],
    rays: Sequence[int],
    size: int,
    radii: Sequence[int],
    wide: Sequence[int],
    large: Sequence[int] = (2, 6),
    clear: bool = False,
) -> Case:
    """Many small circles (`radii`) and a few large ones (`wide`), which reach over hundreds of cells."""
    scene = [_circle(draw, size, radii) for _ in range(draw.integer(*circles))]
    for _ in range(draw.integer(*large)):
        scene.insert(draw.integer(0, len(scene)), _circle(draw, 2 * size, wide))
    return _seen(draw, scene, rays, size, clear=clear)


def clustered(
    draw: Draw,
    *,
    circles: Sequence[int],
    rays: Sequence[int],
    size: int,
    spread: int,
    radii: Sequence[int],
    clusters: Sequence[int] = (3, 6),
    wide: Sequence[int] = (),
    clear: bool = False,
) -> Case:
    """Circles in a few dense clusters, wide empty room between them, and a few circles of radii `wide`."""
    middles = [_point(draw, size) for _ in range(draw.integer(*clusters))]
    scene = []
    for _ in range(draw.integer(*circles)):
        x, y = draw.choice(middles)
        dx, dy = _point(draw, spread)
        scene.append((x + dx, y + dy, draw.integer(*radii)))
    for _ in range(draw.integer(2, 4) if wide else 0):
        scene.insert(draw.integer(0, len(scene)), _circle(draw, 2 * size, wide))
    return _seen(draw, scene, rays, size, clear=clear)


def heaps(
    draw: Draw,
    *,
    circles: Sequence[int],
    rays: Sequence[int],
    size: int,
    radii: Sequence[int],
    copies: Sequence[int],
) -> Case:
    """Each circle many times over, or all about one centre, in a shuffled list: there is no parting them."""
    scene = []
    for _ in range(draw.integer(*circles)):
        x, y, r = _circle(draw, size, radii)
        rings = draw.boolean()
        scene += [(x, y, r + 2 * at if rings else r) for at in range(draw.integer(*copies))]
    for at in range(len(scene) - 1, 0, -1):
        other = draw.integer(0, at)
        scene[at], scene[other] = scene[other], scene[at]
    return _seen(draw, scene, rays, size, clear=False)


def strip(
    draw: Draw, *, circles: Sequence[int], rays: Sequence[int], size: int, wide: int, radii: Sequence[int]
) -> Case:
    """A strip, long and thin, along x or y: rays run along it, past most of the circles."""
    quarters = draw.integer(0, 3)
    scene = [
        (draw.integer(-size, size), draw.integer(-wide, wide), draw.integer(*radii))
        for _ in range(draw.integer(*circles))
    ]
    found = []
    for _ in range(draw.integer(*rays)):
        origin = draw.sign() * draw.integer(size // 2, size), draw.integer(-wide, wide)
        found.append((origin, (-_signed(origin[0], draw.integer(1, FASTEST)), 0)))
    return (
        tuple(_turned(each, quarters) for each in scene),
        tuple((_turned(origin, quarters), _turned(way, quarters)) for origin, way in found),
    )


def _signed(value: int, size: int) -> int:
    return size if value >= 0 else -size


def _seen(draw: Draw, scene: Sequence[IntCircle], rays: Sequence[int], size: int, *, clear: bool) -> Case:
    """With rays from anywhere, every second towards one of the circles."""
    cells = Cells(scene)
    found = []
    for number in range(draw.integer(*rays)):
        while True:
            origin = _point(draw, size)
            ray = origin, _towards(draw, origin, draw.choice(scene)) if number % 2 else _way(draw)
            if not clear or cells.sight(*ray).clear:
                break
        found.append(ray)
    return tuple(scene), tuple(found)


def _circle(draw: Draw, size: int, radii: Sequence[int]) -> IntCircle:
    return (*_point(draw, size), draw.integer(*radii))


def _point(draw: Draw, size: int) -> IntPoint:
    return draw.integer(-size, size), draw.integer(-size, size)


def _way(draw: Draw) -> IntPoint:
    """Any direction: of ten times its length as often as not."""
    while True:
        dx, dy = draw.integer(-99, 99), draw.integer(-99, 99)
        if dx or dy:
            return (10 * dx, 10 * dy) if draw.boolean() else (dx, dy)


def _towards(draw: Draw, origin: IntPoint, circle: IntCircle) -> IntPoint:
    """Towards a place in the disc, in steps as long as a direction may be."""
    x, y, r = circle
    reach = isqrt(r * r // 2)
    dx = x + draw.integer(-reach, reach) - origin[0]
    dy = y + draw.integer(-reach, reach) - origin[1]
    if not dx and not dy:
        return _way(draw)
    shrink = max(gcd(dx, dy), -(-max(abs(dx), abs(dy)) // FASTEST))
    way = _cut(dx, shrink), _cut(dy, shrink)
    return way if any(way) else _way(draw)


def _cut(value: int, shrink: int) -> int:
    """The quotient, towards zero."""
    return value // shrink if value > 0 else -(-value // shrink)


def _scaled(point: IntPoint, times: tuple[int, int, int]) -> IntPoint:
    """The point turned by the angle of (p, q), and r times as far from the origin."""
    (x, y), (p, q, _) = point, times
    return p * x - q * y, q * x + p * y


def _turned(parts: tuple[int, ...], quarters: int) -> tuple[int, ...]:
    """A point, a vector or a circle, turned about the origin by so many quarters."""
    x, y, *rest = parts
    for _ in range(quarters):
        x, y = -y, x
    return (x, y, *rest)


_TRIPLES = ((3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25), (4, 3, 5), (12, 5, 13))

RECIPES: Mapping[str, object] = {
    "field": field,
    "inside": inside,
    "ties": ties,
    "brushing": brushing,
    "leaving": leaving,
    "mixed": mixed,
    "clustered": clustered,
    "heaps": heaps,
    "strip": strip,
}
