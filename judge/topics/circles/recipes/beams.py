"""Recipes of many circles, one origin outside all of them, and directions sorted by angle, in whole numbers.

Each gives a case (circles, O, directions). `circles` and `beams` are how many, from … to; `size` is half the
side of the square that centres are drawn from, about O; `radii` from … to. Angles go from −π to π, as atan2
gives them. With `clear` every direction is drawn until its answer is far from where it turns.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import atan2, isqrt

from judge.data.draw import Draw
from judge.problem import Case
from judge.topics.circles.cells import Cells, IntCircle, IntPoint
from judge.topics.circles.many import FASTEST
from judge.topics.circles.recipes.brushes import brushed, steep

_ROUNDED = (21, 20, 29)  # 20/29 as a double is more than it is
_TRIPLES = ((3, 4, 5), (4, 3, 5), (5, 12, 13), (15, 8, 17), _ROUNDED, (0, 1, 1))
_CLEAR = 3  # by which O is outside every disc at least


def around(
    draw: Draw,
    *,
    circles: Sequence[int],
    beams: Sequence[int],
    size: int,
    radii: Sequence[int],
    far: int = 0,
    aimed: bool = False,
    across: bool = True,
    clear: bool = False,
) -> Case:
    """Circles on all sides of O, not `across` the direction of π perhaps; O is up to `far` from (0, 0)."""
    origin = _point(draw, far)
    scene = [_beside(draw, size, radii) for _ in range(draw.integer(*circles))]
    kept = [each for each in scene if across or not _is_across(each)]
    return _case(draw, kept, origin, draw.integer(*beams), aimed=aimed, clear=clear)


def wrapped(
    draw: Draw, *, circles: Sequence[int], beams: Sequence[int], size: int, radii: Sequence[int]
) -> Case:
    """Some circles lie across the direction of π, where the angles begin anew, beams on both its sides."""
    scene = [_beside(draw, size, radii) for _ in range(draw.integer(*circles))]
    for _ in range(draw.integer(1, 2)):
        radius = draw.integer(*radii)
        away = radius + _CLEAR + draw.integer(1, size)
        scene.insert(draw.integer(0, len(scene)), (-away, draw.integer(-radius // 2, radius // 2), radius))
    ways = [(-draw.integer(20, 40), draw.integer(-12, 12)) for _ in range(draw.integer(*beams))]
    return _sorted_case(scene, _point(draw, 3 * size), [*ways, (-1, 0), *(_way(draw, 99) for _ in range(3))])


def hidden(
    draw: Draw,
    *,
    circles: Sequence[int],
    beams: Sequence[int],
    size: int,
    radii: Sequence[int],
    crowd: Sequence[int] = (0, 0),
) -> Case:
    """A large circle far away, small ones that hide a part of it, and others behind it.

    Among them may be a `crowd`, from … to, of small ones: more of them than O is far from the nearest.
    """
    scene: list[IntCircle] = []
    for _ in range(draw.integer(1, 2)):
        x, y, r = _beside(draw, size, radii)
        way = (x, y) if x or y else (1, 0)
        large = 3 * r
        scene.append((x + 4 * large * _sign(way[0]), y + 4 * large * _sign(way[1]), large))
        scene.append((x + 9 * large * _sign(way[0]), y + 9 * large * _sign(way[1]), large))
        scene += [(x + draw.integer(-r, r), y + draw.integer(-r, r), max(2, r // 4)) for _ in range(2)]
    scene += [_beside(draw, size, radii) for _ in range(draw.integer(*circles))]
    if crowd[1] and draw.boolean():
        scene += [_beside(draw, size, (2, radii[0])) for _ in range(draw.integer(*crowd))]
    if draw.boolean():
        scene.reverse()
    return _case(draw, scene, _point(draw, size), draw.integer(*beams), aimed=True)


def touching(draw: Draw, *, beams: Sequence[int], size: int) -> Case:
    """Circles that a beam touches at a place in whole numbers, or comes nearer to or passes by about 1.

    Behind many of them is a circle that the beam cuts; some lie just behind O, where the line touches them.
    One may be so far away that 1 is little, and another so far that a beam passes it by less than 1.
    """
    scene: list[IntCircle] = []
    ways: list[IntPoint] = []
    for _ in range(draw.integer(*beams)):
        p, q, length = draw.choice(_TRIPLES)
        a, b = draw.choice([(p * draw.sign(), q * draw.sign()), (q * draw.sign(), p * draw.sign())])
        ahead, beside = draw.integer(size // 2, size), draw.integer(2, size // 4) * draw.sign()
        radius = abs(beside) * length + draw.choice([0, 0, 0, 1, -1])
        scene.append((a * ahead - b * beside, b * ahead + a * beside, radius))
        if draw.boolean():
            scene.append((3 * a * size, 3 * b * size, draw.integer(2, size)))
        if not draw.integer(0, 3):
            beside = draw.integer(1, size // 4) * draw.sign()
            scene.append((-a - b * beside, a * beside - b, abs(beside) * length))
        times = draw.integer(1, 9)
        ways.append((a * times, b * times))
    if not draw.integer(0, 2):
        circle, way = _far_graze(draw)
        scene.append(circle)
        ways.append(way)
    elif draw.boolean():
        scene.append((draw.integer(200_000, 300_000) * draw.sign(), 90 * size, 1))
    if draw.boolean():
        scene.reverse()
    return _sorted_case(scene, _point(draw, size), ways, apart=0)


def brushing(draw: Draw, *, beams: Sequence[int], size: int) -> Case:
    """Beams that touch a circle within the band but not exactly; one circle far away makes the extent.

    Behind some of the circles is another one that the beam cuts.
    """
    away = draw.integer(1_000_000, 1_040_000)
    scene: list[IntCircle] = [(away * draw.sign(), draw.integer(-size, size), draw.integer(1, 9))]
    ways: list[IntPoint] = []
    for _ in range(draw.integer(*beams)):
        way = steep(draw)
        x, y, r = brushed(draw, way, away)
        scene.append((x, y, r))
        if draw.boolean():
            scene.append((x + 9 * way[0], y + 9 * way[1], 2 * r))
        ways.append(way)
    if draw.boolean():
        scene.reverse()
    return _sorted_case(scene, _point(draw, 9), ways)


def beside(draw: Draw, *, circles: Sequence[int], beams: Sequence[int], size: int) -> Case:
    """Beside a beam a crowd of large circles, which reach nearer to O than the small one that it meets first.

    The beam cuts them as well, all of them later. Other beams go anywhere; all is turned by quarters.
    """
    r = draw.integer(size, 2 * size)
    scene: list[IntCircle] = []
    for _ in range(draw.integer(*circles)):
        across = (r - draw.integer(0, r // 50)) * draw.sign()
        scene.append((draw.integer(17 * r // 10, 18 * r // 10), across, r))
    scene.insert(
        draw.integer(0, len(scene)), (draw.integer(11 * r // 10, 12 * r // 10), 0, draw.integer(1, 3))
    )
    quarters, times = draw.integer(0, 3), draw.integer(1, FASTEST)
    ways = [(times, 0), *(_way(draw, 99) for _ in range(draw.integer(*beams)))]
    turned = [(*_quartered((x, y), quarters), radius) for x, y, radius in scene]
    return _sorted_case(turned, _point(draw, size), [_quartered(way, quarters) for way in ways])


def short(
    draw: Draw, *, circles: Sequence[int], beams: Sequence[int], size: int, radii: Sequence[int]
) -> Case:
    """Directions of -2 to 2, so that a t of 1 is next to nothing, among circles on all sides of O."""
    scene = [_beside(draw, size, radii) for _ in range(draw.integer(*circles))]
    return _sorted_case(scene, _point(draw, size), [_way(draw, 2) for _ in range(draw.integer(*beams))])


def lone(draw: Draw, *, beams: Sequence[int], size: int) -> Case:
    """One circle that a beam touches, wide beside its distance from O or level with it.

    O may be opposite of the centre, or the centre at (0, 0): neither a sum of the two is the extent, nor
    one of them alone.
    """
    level = draw.boolean()  # with O, or just above it or below
    p, q, length = _ROUNDED if level else draw.choice(_TRIPLES[:-1])
    a, b = draw.choice([(p * draw.sign(), q * draw.sign()), (q * draw.sign(), p * draw.sign())])
    if level:
        k = 2 * draw.integer(size // 40, size // 20)
        ahead, beside = draw.choice([(abs(a) * k, -b * _sign(a) * k), (abs(b) * k, a * _sign(b) * k)])
    else:
        ahead = 2 * draw.integer(1 + size // 20, size // 2)
        beside = 2 * draw.integer(size // 2, size) * draw.sign()
    x, y = a * ahead - b * beside, b * ahead + a * beside
    origin = draw.choice([(-x // 2, -y // 2), (-x // 2, -y // 2), (-x, -y), _point(draw, size)])
    times = draw.integer(1, 9)
    ways = [(a * times, b * times), *(_way(draw, 99) for _ in range(draw.integer(*beams)))]
    return _sorted_case([(x, y, abs(beside) * length)], origin, ways, apart=0)


def ring(
    draw: Draw, *, circles: int, beams: int, away: int, deep: int, radii: Sequence[int], clear: bool = True
) -> Case:
    """Circles on all sides of O and about equally far, `away` and up to `deep` more."""
    scene = []
    for _ in range(circles):
        x, y = _way(draw, away)
        length, far = isqrt(x * x + y * y), away + draw.integer(0, deep)
        scene.append((x * far // length, y * far // length, draw.integer(*radii)))
    return _case(draw, scene, (0, 0), beams, clear=clear)


def _quartered(place: IntPoint, quarters: int) -> IntPoint:
    """The place turned about (0, 0) by so many quarters."""
    x, y = place
    for _ in range(quarters):
        x, y = -y, x
    return x, y


def _far_graze(draw: Draw) -> tuple[IntCircle, IntPoint]:
    """A circle far from (0, 0), and a direction that cuts it or passes it by less than 1."""
    while True:
        a, b = _way(draw, 90)
        ahead, beside = draw.integer(5_000, 9_000), draw.integer(200, 900) * draw.sign()
        x, y = a * ahead - b * beside + draw.integer(-9, 9), b * ahead + a * beside + draw.integer(-9, 9)
        across, length = abs(a * y - b * x), a * a + b * b
        radius = isqrt(across * across // length) + draw.integer(0, 1)
        if 700_000 < max(abs(x), abs(y)) < 1_000_000:
            return (x, y, radius), (a, b)


def _case(
    draw: Draw,
    scene: Sequence[IntCircle],
    origin: IntPoint,
    beams: int,
    *,
    aimed: bool = False,
    clear: bool = False,
) -> Case:
    """With directions of all kinds; `aimed` sends every other one towards a circle."""
    outside = [each for each in scene if _is_outside(each)] or [(0, 40 + _CLEAR, 40)]
    cells = Cells(outside) if clear else None
    ways = []
    for number in range(beams):
        while True:
            aim = draw.choice(outside) if aimed and number % 2 else None
            way = _towards(draw, aim) if aim else _way(draw, FASTEST)
            if cells is None or cells.sight((0, 0), way).clear:
                break
        ways.append(way)
    return _sorted_case(outside, origin, ways)


def _sorted_case(
    scene: Sequence[IntCircle], origin: IntPoint, ways: Sequence[IntPoint], *, apart: int = _CLEAR
) -> Case:
    """The scene moved so that O is there; circles that reach to O, or nearer than `apart`, are left out."""
    ox, oy = origin
    moved = tuple((x + ox, y + oy, r) for x, y, r in scene if _is_outside((x, y, r), apart))
    return moved or ((ox, oy + 40 + _CLEAR, 40),), origin, tuple(sorted(ways, key=_angle))


def _angle(way: IntPoint) -> float:
    return atan2(way[1], way[0])


def _is_outside(circle: IntCircle, apart: int = _CLEAR) -> bool:
    """Whether (0, 0) is outside the disc, and about so far from it."""
    x, y, r = circle
    return x * x + y * y > r * r and isqrt(x * x + y * y) >= r + apart


def _is_across(circle: IntCircle) -> bool:
    """Whether the direction of π meets it."""
    x, y, r = circle
    return x < 0 and abs(y) <= r


def _beside(draw: Draw, size: int, radii: Sequence[int]) -> IntCircle:
    """A circle that does not reach to (0, 0), if its centre may be chosen so."""
    r = draw.integer(*radii)
    for _ in range(20):
        x, y = _point(draw, size)
        if _is_outside((x, y, r)):
            return x, y, r
    return draw.reject()


def _point(draw: Draw, size: int) -> IntPoint:
    return draw.integer(-size, size), draw.integer(-size, size)


def _way(draw: Draw, most: int) -> IntPoint:
    while True:
        way = _point(draw, most)
        if any(way):
            return way


def _towards(draw: Draw, circle: IntCircle) -> IntPoint:
    """From (0, 0) towards a place in the disc."""
    x, y, r = circle
    reach = isqrt(r * r // 2)
    dx, dy = x + draw.integer(-reach, reach), y + draw.integer(-reach, reach)
    shrink = -(-max(abs(dx), abs(dy)) // FASTEST) or 1
    way = _sign(dx) * (abs(dx) // shrink), _sign(dy) * (abs(dy) // shrink)
    return way if any(way) else _way(draw, 99)


def _sign(value: int) -> int:
    return (value > 0) - (value < 0)


RECIPES: Mapping[str, object] = {
    "around": around,
    "wrapped": wrapped,
    "hidden": hidden,
    "touching": touching,
    "brushing": brushing,
    "beside": beside,
    "short": short,
    "lone": lone,
    "ring": ring,
}
