"""Scenes of many circles and many rays, or beams from one place, in whole numbers up to 2**20.

    fields(10, 9, 70, (9, 17))               (circles, rays)
    scans(10, 12, 120, (4, 50))              (circles, O, dirs)

Circles are counted by `count` or bounds of it, `reach` is half the side of the square of their centres.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2, gcd, isqrt

from judge.data.draw import Draw
from judge.geometry.boxes import IntCircle, IntPoint
from judge.geometry.level import Case, Scene, maker

FASTEST = 1000  # the largest coordinate of a direction
TRIPLES = ((3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25), (4, 3, 5), (12, 5, 13))
WIDE = 1_000_000

Bounds = tuple[int, int]
Ray = tuple[IntPoint, IntPoint]


def any_point(draw: Draw, reach: int) -> IntPoint:
    """A point up to `reach` away from (0, 0) along x and y."""
    return draw.integer(-reach, reach), draw.integer(-reach, reach)


def any_circle(draw: Draw, reach: int, radii: Bounds) -> IntCircle:
    """A circle about such a point."""
    return (*any_point(draw, reach), draw.integer(*radii))


def any_way(draw: Draw, most: int = 99) -> IntPoint:
    """Any direction; of ten times its length as often as not, where there is room for that."""
    dx, dy = any_point(draw, most)
    if not dx and not dy:
        return 1, 0
    return (10 * dx, 10 * dy) if most * 10 < FASTEST and draw.boolean() else (dx, dy)


def _towards(draw: Draw, O: IntPoint, circle: IntCircle) -> IntPoint:
    """Towards a place in the disc, in steps as long as a direction may be."""
    x, y, r = circle
    reach = isqrt(r * r // 2)
    dx, dy = x + draw.integer(-reach, reach) - O[0], y + draw.integer(-reach, reach) - O[1]
    shrink = max(gcd(dx, dy), -(-max(abs(dx), abs(dy)) // FASTEST), 1)
    way = int(dx / shrink), int(dy / shrink)
    return way if any(way) else any_way(draw)


def turned(parts: tuple[int, ...], quarters: int) -> tuple[int, ...]:
    """A point, a vector or a circle, turned about (0, 0) by so many quarters."""
    x, y, *rest = parts
    for _ in range(quarters):
        x, y = -y, x
    return (x, y, *rest)


def _scaled(point: IntPoint, times: tuple[int, int, int]) -> IntPoint:
    """The point turned by the angle of (p, q), and r times as far from (0, 0)."""
    (x, y), (p, q, _) = point, times
    return p * x - q * y, q * x + p * y


# -- rays ---------------------------------------------------------------------------------------------


def _seen(draw: Draw, circles: Sequence[IntCircle], rays: Bounds, reach: int, fastest: int = 99) -> Case:
    """With rays from anywhere, every second towards one of the circles."""
    found = []
    for number in range(draw.integer(*rays)):
        O = any_point(draw, reach)
        found.append((O, _towards(draw, O, draw.choice(circles)) if number % 2 else any_way(draw, fastest)))
    return tuple(circles), tuple(found)


@maker
def fields(
    draw: Draw,
    circles: Bounds,
    rays: Bounds,
    reach: int,
    radii: Bounds,
    large: Bounds = (0, 0),
    fastest: int = 99,
) -> Case:
    """Circles anywhere, and two to six `large` ones where that is said."""
    scene = [any_circle(draw, reach, radii) for _ in range(draw.integer(*circles))]
    for _ in range(draw.integer(2, 6) if large[1] else 0):
        scene.insert(draw.integer(0, len(scene)), any_circle(draw, 2 * reach, large))
    return _seen(draw, scene, rays, reach, fastest)


@maker
def aside(draw: Draw, scene: Scene, by: int) -> Case:
    """The scene moved along x, along y, along both or not at all, so that (0, 0) may lie beside it."""
    circles, rays = scene(draw)
    u, v = draw.choice((-by, 0, by)), draw.choice((-by, 0, by))
    moved = tuple(((x + u, y + v), way) for (x, y), way in rays)
    return tuple((x + u, y + v, r) for x, y, r in circles), moved


@maker
def inside(draw: Draw, circles: Bounds, rays: Bounds, reach: int, radii: Bounds) -> Case:
    """Each ray starts inside a circle; others lie around, inside and across it."""
    scene = [any_circle(draw, reach, radii) for _ in range(draw.integer(*circles))]
    found = []
    for _ in range(draw.integer(*rays)):
        x, y, r = draw.choice(scene)
        dx, dy = any_point(draw, max(0, 2 * r // 3 - 1))
        found.append(((x + dx, y + dy), any_way(draw)))
    return tuple(scene), tuple(found)


@maker
def clusters(draw: Draw, circles: Bounds, rays: Bounds, reach: int, radii: Bounds, large: Bounds) -> Case:
    """A few dense clusters, 3 % of the scene wide, empty room between them, and a few large circles."""
    middles = [any_point(draw, reach) for _ in range(draw.integer(3, 6))]
    scene = []
    for _ in range(draw.integer(*circles)):
        (x, y), (dx, dy) = draw.choice(middles), any_point(draw, reach * 3 // 100)
        scene.append((x + dx, y + dy, draw.integer(*radii)))
    for _ in range(draw.integer(2, 4)):
        scene.insert(draw.integer(0, len(scene)), any_circle(draw, 2 * reach, large))
    return _seen(draw, scene, rays, reach)


@maker
def heaps(draw: Draw, circles: Bounds, rays: Bounds, reach: int, radii: Bounds, copies: Bounds) -> Case:
    """Each circle many times over, or as rings about one centre, in a shuffled list."""
    scene = []
    for _ in range(draw.integer(*circles)):
        x, y, r = any_circle(draw, reach, radii)
        rings = draw.boolean()
        scene += [(x, y, r + 2 * at if rings else r) for at in range(draw.integer(*copies))]
    for at in range(len(scene) - 1, 0, -1):
        other = draw.integer(0, at)
        scene[at], scene[other] = scene[other], scene[at]
    return _seen(draw, scene, rays, reach)


@maker
def strips(draw: Draw, circles: Bounds, rays: Bounds, reach: int, wide: int, radii: Bounds) -> Case:
    """A strip, long and thin, along x or y; rays run along it."""
    quarters = draw.integer(0, 3)
    scene = [
        (draw.integer(-reach, reach), draw.integer(-wide, wide), draw.integer(*radii))
        for _ in range(draw.integer(*circles))
    ]
    found = []
    for _ in range(draw.integer(*rays)):
        side = draw.sign()
        O = side * draw.integer(reach // 2, reach), draw.integer(-wide, wide)
        found.append((turned(O, quarters), turned((-side * draw.integer(1, FASTEST), 0), quarters)))
    return tuple(turned(each, quarters) for each in scene), tuple(found)


@maker
def ties(draw: Draw, rays: Bounds, reach: int) -> Case:
    """Circles that a ray meets at once, touches, and origins on one; others are off by 1, a ten-millionth.

    Each ray has a strip of its own, far from the others. All is turned and scaled by a triple, which keeps
    whole numbers and every tie; a circle far away makes the size.
    """
    scene: list[tuple[int, int, int, int]] = []  # x, y, r, and by how much the scaled radius differs
    found: list[Ray] = []
    for number in range(draw.integer(*rays)):
        x, y = draw.integer(-reach, reach), 12 * reach * number
        p, q, r = draw.choice(TRIPLES)
        kind = draw.choice(("copies", "mirrored", "nested", "touch", "both", "on-circle", "just-off"))
        side, ahead = draw.sign(), x + reach + r + draw.integer(1, reach)
        scene += {
            "copies": [(ahead, y + q, r, 0)] * 2,
            "mirrored": [(ahead, y + q, r, 0), (ahead, y - q, r, 0)],
            "nested": [(ahead + p, y + q * side, r, 0), (ahead + 2 * p, y + 2 * q * side, 2 * r, 0)],
            "touch": [(ahead, y + r * side, r, 0)],
            "both": [(ahead, y + r, r, 0), (ahead + p, y - q, r, 0)],
            "on-circle": [(x + p * side, y + q * draw.sign(), r, 0)],
            "just-off": [(ahead, y + side * reach, reach, draw.sign())],
        }[kind]
        scene.append((ahead + 3 * reach + draw.integer(1, reach), y, draw.integer(1, r), 0))
        found.append(((x, y), (draw.integer(1, 9), 0)))
    times = (1, 0, 1) if draw.boolean() else draw.choice(TRIPLES)
    circles = [(*_scaled((x, y), times), r * times[2] + more) for x, y, r, more in scene]
    circles.insert(draw.integer(0, len(circles)), (draw.integer(900_000, WIDE), -90 * reach, 1))
    quarters = draw.integer(0, 3)
    return tuple(turned(each, quarters) for each in circles), tuple(
        (turned(_scaled(O, times), quarters), turned(_scaled(way, times), quarters)) for O, way in found
    )


@maker
def leaving(draw: Draw, rays: Bounds, reach: int) -> Case:
    """Rays in any direction from a place on a circle, and from its centre, there with a D of two lengths."""
    scene: list[IntCircle] = []
    found: list[Ray] = []
    for number in range(draw.integer(*rays)):
        x, y = draw.integer(-reach, reach), 12 * reach * number
        p, q, r = draw.choice(TRIPLES)
        times = draw.integer(1, reach // r)
        middle = x + draw.sign() * p * times, y + draw.sign() * q * times
        (dx, dy), far = any_way(draw), draw.integer(reach, 2 * reach)
        scene += [(*middle, r * times), (x + 3 * reach * (dx > 0 or -1), y + 3 * reach * (dy > 0 or -1), far)]
        dx, dy = (dx // 10, dy // 10) if max(abs(dx), abs(dy)) > 99 else (dx, dy)
        found += [((x, y), (dx, dy)), (middle, (dx, dy)), (middle, (9 * dx, 9 * dy))]
    return tuple(scene), tuple(found)


# -- beams --------------------------------------------------------------------------------------------


def outside(circle: IntCircle, apart: int = 3) -> bool:
    """Whether (0, 0) is outside the disc, and about so far from it."""
    x, y, r = circle
    return x * x + y * y > r * r and isqrt(x * x + y * y) >= r + apart


def scanned(scene: Sequence[IntCircle], O: IntPoint, ways: Sequence[IntPoint], apart: int = 3) -> Case:
    """The scene moved so that O is there, without circles that reach nearly to it; the beams sorted."""
    moved = tuple((x + O[0], y + O[1], r) for x, y, r in scene if outside((x, y, r), apart))
    ways = sorted(ways, key=lambda way: atan2(way[1], way[0]))
    return moved or ((O[0], O[1] + 43, 40),), O, tuple(ways)


@maker
def scans(
    draw: Draw,
    circles: Bounds,
    beams: Bounds,
    reach: int,
    radii: Bounds,
    *,
    fastest: int = 99,
    across: bool = True,
    hidden: bool = False,
) -> Case:
    """Circles on all sides of O; not `across` the direction of π, or with some that are `hidden` in part."""
    scene = [any_circle(draw, reach, radii) for _ in range(draw.integer(*circles))]
    if hidden:
        x, y, r = any_circle(draw, reach, radii)
        right, up = (1 if x > 0 else -1), (1 if y > 0 else -1)
        scene += [(x + 12 * r * right * far, y + 12 * r * up * far, 3 * r) for far in (1, 2)]
        scene += [(x + draw.integer(-r, r), y + draw.integer(-r, r), max(2, r // 4)) for _ in range(2)]
        scene += [any_circle(draw, reach, (2, radii[0])) for _ in range(draw.integer(0, 90))]
        scene += [(x, y, max(1, r // 2)) for x, y, r in scene[: draw.integer(0, 3)]]  # about one centre
    kept = [each for each in scene if across or each[0] >= 0 or abs(each[1]) > each[2]]
    ways = [
        _towards(draw, (0, 0), draw.choice(kept)) if kept and number % 2 else any_way(draw, fastest)
        for number in range(draw.integer(*beams))
    ]
    return scanned(kept, any_point(draw, 3 * reach), ways)


@maker
def wraps(draw: Draw, circles: Bounds, beams: Bounds, reach: int, radii: Bounds) -> Case:
    """Circles across the direction of π, where the angles begin anew, and beams on both sides of it."""
    scene = [any_circle(draw, reach, radii) for _ in range(draw.integer(*circles))]
    for _ in range(draw.integer(1, 2)):
        r = draw.integer(*radii)
        scene.append((-r - 3 - draw.integer(1, reach), draw.integer(-r // 2, r // 2), r))
    ways = [(-draw.integer(20, 40), draw.integer(-12, 12)) for _ in range(draw.integer(*beams))]
    return scanned(scene, any_point(draw, 3 * reach), [*ways, (-1, 0), *(any_way(draw) for _ in range(3))])


@maker
def touches(draw: Draw, beams: Bounds, reach: int) -> Case:
    """Circles that a beam touches, comes nearer to or passes by 1; behind many of them one that it cuts."""
    scene: list[IntCircle] = []
    ways: list[IntPoint] = []
    for _ in range(draw.integer(*beams)):
        p, q, length = draw.choice(TRIPLES)
        a, b = draw.choice([(p * draw.sign(), q * draw.sign()), (q * draw.sign(), p * draw.sign())])
        ahead, beside = draw.integer(2, reach), draw.integer(2, reach // 4) * draw.sign()
        r = abs(beside) * length + draw.choice([0, 0, 0, 1, -1])
        scene.append((a * ahead - b * beside, b * ahead + a * beside, r))
        if draw.boolean():
            scene.append((3 * a * reach, 3 * b * reach, draw.integer(2, reach)))
        times = draw.integer(1, 9)
        ways.append((a * times, b * times))
    if draw.boolean():
        scene.append((draw.integer(900_000, WIDE) * draw.sign(), 90 * reach, 1))
    x, y = any_point(draw, reach)
    u, v, _ = scene[-1]  # which may come to lie on an axis
    away = -90 * reach
    O = draw.choice(((x, y), (0, 0), (away, 0), (0, away), (-u, -v), (-u, y), (x, -v)))
    return scanned(scene, O, ways, apart=0)


@maker
def besides(draw: Draw, circles: Bounds, beams: Bounds, reach: int) -> Case:
    """Beside a beam large circles, which reach nearer to O than the small one that it meets first."""
    r, quarters = draw.integer(reach, 2 * reach), draw.integer(0, 3)
    scene = [
        (draw.integer(17 * r // 10, 18 * r // 10), (r - draw.integer(0, r // 50)) * draw.sign(), r)
        for _ in range(draw.integer(*circles))
    ]
    small = draw.integer(11 * r // 10, 12 * r // 10), 0, draw.integer(1, 3)
    scene.insert(draw.integer(0, len(scene)), small)
    ways = [(draw.integer(1, FASTEST), 0), *(any_way(draw) for _ in range(draw.integer(*beams)))]
    return scanned(
        [turned(each, quarters) for each in scene],  # type: ignore[misc]  # circles
        any_point(draw, reach),
        [turned(way, quarters) for way in ways],  # type: ignore[misc]  # directions
    )
