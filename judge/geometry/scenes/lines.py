"""Scenes of one circle or sphere, and a line, segment, ray or point.

    lines("touch before after", **BIG)       (cx, cy, r, A, B)
    rays("chord first~", **NEAR)             (cx, cy, r, O, D)
    points("on~", **NEAR)                    (cx, cy, r, P)
    spheres("cut before", **PLAIN)           (C, r, O, D) in space
    feet("beyond", **PLAIN), slim            (A, B, P), no circle
    leaning(1e-12, 1e-9)                     (cx, cy, r, A, B), nearly along an axis and nearly a touch
    aimed(past), faint(rays("cut in"))       (cx, cy, r, O, D)
    aimed(sloping(end="origin"))             (cx, cy, r, O, D)
    abreast, enlarged(abreast)               (cx, cy, r, O, D)

The first word is the height of the line over the circle, the others are places on it, of A and B or of O: see
judge.geometry.level. After O the word "anyway" sends the ray in any direction.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from math import copysign, frexp, hypot, isqrt, sqrt
from typing import Any

from judge.data.draw import Draw
from judge.geometry.level import (
    HEIGHT,
    PLACE,
    Case,
    Level,
    Nudge,
    Scene,
    Vocabulary,
    levelled,
    maker,
    over_circle,
    parsed,
)
from judge.geometry.pose import HUGE, Length, Point, Vector, posed, triple

_START = PLACE._replace(known=(*PLACE.known, "anyway"))
_POINT = Vocabulary.of("a place of a point", "in on out close centre far dot-on dot-out")
_FOOT = Vocabulary.of("a place of a foot", "between beyond end on near close same")


def _level_line(draw: Draw, words: Sequence[str], size: int = 30, uneven: int = 0) -> Level:
    R, (start, end), nudges = over_circle(draw, words, size, uneven=uneven)
    if start == end and "=" not in words:
        draw.reject()
    return [Point([0, 0]), Length([R]), start, end], nudges


def _level_ray(
    draw: Draw, words: Sequence[str], size: int = 30, uneven: int = 0, dimension: int = 2
) -> Level:
    R, (start,), nudges = over_circle(draw, words[:2], size, dimension, uneven)
    rest = [0] * (dimension - 2)
    if words[-1] == "anyway":
        way = [draw.integer(-9, 9) for _ in range(dimension)]
        if not any(way):
            draw.reject()
    else:
        way = [draw.integer(1, 9), 0, *rest]
    return [Point([0, 0, *rest]), Length([R]), start, Vector(way)], nudges


def _level_point(draw: Draw, words: Sequence[str], size: int = 30, uneven: int = 0) -> Level:
    """A circle, and a point on the x axis."""
    word = words[0].rstrip("~")
    R = 0 if word.startswith("dot") else draw.integer(max(2, size // 2), size) << uneven
    reach = R or size
    places: dict[str, Callable[[], int]] = {
        "in": lambda: draw.integer(1, max(1, R - 1)),
        "on": lambda: R,
        "close": lambda: R + max(1, R >> draw.integer(2, 20)),  # outside, by 2**-2 to 2**-20 of the radius
        "far": lambda: reach * draw.integer(100, 20_000),
        "out": lambda: R + draw.integer(1, 3 * reach),
        "centre": lambda: 0,
    }
    point = Point([places[{"dot-on": "centre", "dot-out": "out"}.get(word, word)](), 0])
    return [Point([0, 0]), Length([R]), point], [Nudge(point, 0)] if words[0][-1] == "~" else []


def _level_foot(draw: Draw, words: Sequence[str], size: int = 30, uneven: int = 0) -> Level:
    """A and B on the x axis, and P at a place of the line between or beyond them, and at a height."""
    length = draw.integer(1, size) << uneven
    end = 0 if "same" in words else length
    at = 0 if "end" in words else draw.integer(0, length)
    if "beyond" in words:
        at = draw.choice((-at - 1, length + at + 1))
    high = 0 if "on" in words else draw.integer(1, size) * draw.sign()
    if "near" in words:
        high, at, end = draw.sign(), at << 12, end << 12
    if "close" in words:  # A and B are close together, seen from P
        away = draw.integer(4, 40)
        high, at = high << away, at << away
    start, last = (end, 0) if draw.boolean() else (0, end)
    return [Point([at, high]), Point([start, 0]), Point([last, 0])], []


lines = levelled(_level_line, lambda C, r, A, B: (*C, r, A, B), HEIGHT, PLACE)
rays = levelled(_level_ray, lambda C, r, O, D: (*C, r, O, D), HEIGHT, _START)
spheres = levelled(partial(_level_ray, dimension=3), lambda *case: case, HEIGHT, _START)
points = levelled(_level_point, lambda C, r, P: (*C, r, P), _POINT)
feet = levelled(_level_foot, lambda P, A, B: (A, B, P), _FOOT)


def closed_up(*plans: str, **how: Any) -> Scene:
    """Lines of which A and B are close together, and exact: by 2**-1 to 2**-40 of the size and less, or by
    powers between the two of `close`.
    """
    split, size = parsed(plans, HEIGHT, PLACE), how.pop("size", 30)
    close = how.pop("close", (1, 40))

    def draw_case(draw: Draw) -> Case:
        shift = draw.integer(*close)
        R, (start,), _ = over_circle(draw, draw.choice(split), size)
        start, radius = Point([start[0] << shift, start[1] << shift]), R << shift
        end = Point([start[0] + draw.sign() * draw.integer(1, 3), start[1]])
        scaled = {**how, "shift": how.get("shift", 0) - shift}
        (cx, cy), r, A, B = posed(draw, [Point([0, 0]), Length([radius]), start, end], **scaled)
        return cx, cy, r, A, B

    return draw_case


def skimming(draw: Draw) -> Case:
    """A ray that begins on a circle and nearly touches it there, and rounding puts its origin behind: in the
    quadratic, or on the way from the foot.
    """
    framed = draw.boolean()
    for _ in range(12):
        cx, cy, r, O = _ON(draw)
        lean, turn = draw.integer(1 << 10, 1 << draw.choice((11, 11, 14))) / (1 << 21), draw.sign()
        lean *= draw.sign()
        fx, fy = O[0] - cx, O[1] - cy
        dx, dy = lean * fx - turn * fy, lean * fy + turn * fx
        length = hypot(dx, dy)
        ux, uy = dx / length, dy / length
        foot, off = -(fx * ux + fy * uy), abs(ux * fy - uy * fx)
        half = copysign(sqrt(max(0, (r - off) * (r + off))), foot)
        if framed:
            behind = half - foot > 2e-10 * abs(half)
        else:
            behind = (fx * fx + fy * fy - r * r) / -(foot + half) > 3e-10 * abs(off - r)
        if behind:
            return cx, cy, r, O, (dx, dy)
    return draw.reject()


def minute(draw: Draw) -> Case:
    """A and B are less than 1e-30 apart, in numbers of 1e-30, and one of them is in the circle."""
    A = [draw.integer(30, 60) * draw.sign() for _ in "xy"]
    B = [x + draw.integer(-9, 9) for x in A]
    low, high = sorted(isqrt(x * x + y * y) for x, y in (A, B))
    if low == high:
        draw.reject()
    r, a, b, c, d = (n * 2.0**-104 for n in (draw.integer(low + 1, high), *A, *B))
    return 0, 0, r, (a, b), (c, d)


@maker
def faint(draw: Draw, drawn: Scene) -> Case:
    """The same ray with the shortest D: 1e-30 along an axis, or one to two times that along each."""
    *rest, D = drawn(draw)
    way = [draw.integer(2**40, 2**41) / 2**40 * 1e-30 * draw.sign() for _ in D]
    if draw.boolean():
        at = draw.integer(1, len(D))
        way = [copysign(1e-30, x) if i == at else 0 for i, x in enumerate(way, 1)]
    return *rest, tuple(way)


@maker
def aimed(draw: Draw, drawn: Scene) -> Case:
    """The ray from A to B."""
    *circle, A, B = drawn(draw)
    return *circle, A, (B[0] - A[0], B[1] - A[1])


@maker
def leaning(draw: Draw, *leans: float, depth: int = 1) -> Case:
    """A line that leaves an axis by 0.7 to 1 times one of `leans` and cuts the circle by 1e-7 of its radius,
    or `depth` times that; A is nearly a radius from the middle of the chord.
    """
    r = draw.integer(2**40, 2**41) * 2.0 ** -draw.integer(30, 60)
    lean = draw.choice(leans) * draw.integer(70, 99) / 100 * draw.sign()
    x, side = r * (1 - draw.integer(102, 130) * depth / 10**9), draw.sign()
    high = r * draw.integer(850, 999) / 1000 * draw.sign()
    cx, cy, turn = draw.integer(-2, 2) * r, draw.integer(-2, 2) * r, draw.choice((1, -1))
    ends = [(side * (x + lean * y), y)[::turn] for y in (high, -high * draw.integer(30, 100) / 100)]
    A, B = ((cx + x, cy + y) for x, y in ends)
    return cx, cy, r, A, B


@maker
def slivers(draw: Draw, *kinds: str) -> Case:
    """A and B are hardly beside an axis through C, by 1e-6 to 1e-9 of how far away they are.

    Of a "dot" C is on the line, and so it is in "through"; "aside" of it the line passes as closely, "across"
    it comes from one axis to the other one, and a "brink" ends right inside A. A "slant" leaves A at an
    angle and hardly cuts.
    """
    kind, far = draw.choice(kinds), draw.integer(2**18, 2**20)
    power = draw.choice((30, 27, 27, 27) if kind == "dot" else (27, 27, 27, 20))
    hair = draw.integer(160, 255) * far * 2.0 ** -(8 + power)
    m, n, a, b = (draw.integer(1, 3) * draw.sign(), *[draw.integer(-3, 3) for _ in range(3)])
    n, level, order = draw.choice((0, n)), kind in ("dot", "through"), draw.choice((1, -1))
    ends = [(1.0 * m * far, (m if level else a) * hair), (1.0 * n * far, (n if level else b) * hair)]
    wide = 1 - draw.integer(102, 300) / 10**9 if kind == "brink" else draw.integer(1, 96) / 64
    if kind == "across":
        ends[1] = ends[1][::-1]
    elif kind == "slant":
        up, order = draw.integer(30, 64) / 64, 1
        ends = [(1.0 * m * far, m * hair * draw.choice((1.25, 1.3))), (0.0, m * far * up * draw.sign())]
        wide = up / sqrt(1 + up * up) * draw.integer(102, 115) / 100
    r = 0 if kind == "dot" else abs(a) * hair if kind == "aside" and draw.boolean() else wide * abs(m) * far
    x, y = draw.choice(((0, 0), (draw.integer(-3, 3) * far, draw.integer(-3, 3) * hair)))
    turn, scale = draw.choice((1, -1)), 2.0 ** draw.choice((7, draw.integer(-40, 7)))
    C, A, B = (((x + u) * scale, (y + v) * scale)[::turn] for u, v in ((0, 0), *ends[::order]))
    return *C, r * scale, A, B


def mote(draw: Draw) -> Case:
    """A and B are a few times 1e-30 away from one another, and C is 10 to 1e9 away."""
    A, B = ((draw.integer(-9, 9) * 2.0**-99, draw.integer(-9, 9) * 2.0**-99) for _ in "AB")
    size = 10 ** draw.integer(1, 9)
    return draw.integer(-size, size), draw.integer(-size, size), draw.integer(1, size), A, B


def past(draw: Draw) -> Case:
    """A line that passes the centre by 2.5e-9 to 7.5e-9 of the radius; A is as near the centre, or not."""
    p, q, c = triple(draw, 65)
    r = draw.integer(2**40, 2**41) * 2.0 ** -draw.integer(30, 60)
    high, turn, back = draw.integer(25, 75) / 10**10 * draw.sign(), draw.sign(), draw.choice((1, -1))
    ways = draw.choice((draw.integer(-55, 55) / 10**10, -draw.integer(1, 12) / 10)), draw.integer(11, 13) / 10
    A, B = ((r * (p * x - q * high) / c * turn, r * (q * x + p * high) / c * back) for x in ways)
    return 0, 0, r, A, B


@maker
def astray(draw: Draw, *, times: int = 1) -> Case:
    """A touch of a circle of radius 1 to 9 `times` a unit, which is ten million times the figure's size from
    the origin, or more; the foot is no double. The way from A to B passes it.
    """
    p, q, c = triple(draw, draw.choice((5, 13, 13, 65)))
    r, side, turn = draw.integer(1, 9) * times, draw.sign(), draw.choice((1, -1))
    way = r * q * pow(p, -1, c) % c + c * draw.choice((-1, 0, 0, 1))  # from the foot to A, which is whole
    steps = (abs(way) // c + draw.integer(1, 2)) * (-1 if way > 0 else 1)
    ends = [((p * at - q * r) // c, (q * at + p * r) // c) for at in (way, way + steps * c)]
    finer = draw.choice((0, 0, draw.integer(1, 20)))
    cx, cy = (draw.integer(1 << 28 + finer, (1 << 30 + finer) - 99 * c) * draw.sign() for _ in "xy")
    numbers = [[(cx + x) / (1 << finer), (cy + side * y) / (1 << finer)] for x, y in ((0, 0), *ends)]
    if not finer and draw.boolean():
        numbers = [[int(x) for x in row] for row in numbers]
    C, A, B = (tuple(row[::turn]) for row in numbers)
    return *C, r / (1 << finer) if finer else r, A, B


@maker
def unsigned(draw: Draw, drawn: Scene) -> Case:
    """The last two points are one, but where a coordinate is 0.0 it is −0.0 in the other one."""
    *rest, A, _ = drawn(draw)
    at, zero = draw.integer(0, len(A) - 1), draw.choice((0.0, -0.0))
    return *rest, *(tuple(x if i != at else each for i, x in enumerate(A)) for each in (zero, -zero))


@maker
def terse(draw: Draw, drawn: Scene) -> Case:
    """One number is another one of a single digit, as 3e-05, which is written without a point."""
    rows = [list(part) if isinstance(part, tuple) else [part] for part in drawn(draw)]
    row = draw.choice(rows)
    row[draw.integer(0, len(row) - 1)] = float(f"{draw.integer(1, 9)}e-05")
    return tuple(tuple(row) if len(row) > 1 else row[0] for row in rows)


@maker
def still(draw: Draw, drawn: Scene) -> Case:
    """The last vector is 0, and its numbers are 0, 0.0 or −0.0."""
    *rest, D = drawn(draw)
    return *rest, tuple(draw.choice((0, 0.0, -0.0, -0.0)) for _ in D)


@maker
def pinpoint(draw: Draw, *, close: bool = False) -> Case:
    """A touch of a circle that is 1e7 to 1e11 times smaller than the way to A and B, which are as far from
    it on both sides, or close together.
    """
    (p, q, c), r, scale = triple(draw, 4_418), draw.integer(1, 9), 2.0 ** -draw.integer(20, 80)
    far = draw.integer(2**36, 2**37) >> draw.integer(0, 8)
    ways = far, far + draw.integer(1, 9) if close else -far
    turn, back = scale * draw.sign(), scale * draw.sign()
    A, B = (((x * p - r * q) * turn, (x * q + r * p) * back) for x in ways)
    return 0, 0, scale * r * c, A, B


def merged(draw: Draw) -> Case:
    """A line that leaves an axis by 1.1e-9 to 1.5e-9 and cuts a circle so far from the origin that its points
    may have one coordinate in common.
    """
    cx, cy, r = draw.integer(2**29, 2**30 - 9) * draw.sign(), draw.integer(-9, 9), draw.integer(5, 9)
    x, side, turn = cx + draw.integer(-2, 2), draw.sign(), draw.choice((1, -1))
    near = x, cy - draw.integer(15, 30) * side
    far = x + 3 * draw.sign() / 2**23, cy + draw.integer(230, 280) * side
    A, B = (end[::turn] for end in ((near, far) if draw.boolean() else (far, near)))
    return *(cx, cy)[::turn], r, A, B


def speck(draw: Draw) -> Case:
    """(A, B, P): A and B are less than 1e-30 apart, on a diagonal, an axis or anyhow, and P is near them."""
    ways = (1, 0), (0, 1), (1, 1), (1, -1), (draw.integer(1, 9), draw.integer(-9, 9))
    (i, j), times = draw.choice(ways), draw.integer(1, 50) * draw.sign()
    x, y = draw.integer(1100, 1600), draw.integer(1100, 1600)
    A, B = ((u * 2.0**-109, v * 2.0**-109) for u, v in ((x, y), (x + i * times, y + j * times)))
    return A, B, (draw.integer(-9, 9) * 2.0**-99, draw.integer(-9, 9) * 2.0**-99)


def slim(draw: Draw) -> Case:
    """(A, B, P): A and B are hardly apart, or P is hardly beside one of them; the line hardly leans from an
    axis, or anyhow. Hardly is 4e-9 to 9e-5 of the size.
    """
    n = draw.integer(2**20, 2**28) * 2.0 ** draw.choice((0, 0, -20, -60))
    a, b, c = (draw.integer(4, 9) * draw.sign() * 10.0 ** -draw.choice((9, 9, 8, 7, 6, 5)) for _ in "abc")
    a, c = draw.choice((0, a, draw.integer(20, 99) / 100)), c * draw.choice((0, 1, 1))
    beside = ((a, 1), (b, c)), ((a, 1), (b, c)), ((a, 1), (c, b))
    (dx, dy), (fx, fy) = draw.choice((*beside, ((a, b), (1, c)), ((a, b), (c, 1))))
    x, y = (draw.choice((0, 0, 1, c)) for _ in "xy")
    turn, back, side = draw.choice((1, -1)), n * draw.sign(), n * draw.sign()
    points = [(x, y), (x + dx, y + dy), (x + fx, y + fy)]
    A, B, P = ((u * back + 0.0, v * side + 0.0)[::turn] for u, v in points)  # no −0.0
    return (A, B, P) if draw.boolean() else (B, A, P)


def neighbours(draw: Draw) -> Case:
    """(A, B, P): A and B are one double apart, in x, in y or in both."""
    unit, (i, j) = 2.0 ** -draw.integer(23, 140), draw.choice(((1, 0), (0, 1), (1, 1), (1, -1)))
    x, y, u, v = (draw.integer(2**52, 2**53 - 2) for _ in range(4))
    A, B = (x * unit, (y + 1) * unit), ((x + i) * unit, (y + 1 + j) * unit)
    return A, B, (u * unit * draw.sign(), v * unit * draw.sign())


@maker
def enlarged(draw: Draw, drawn: Scene) -> Case:
    """The same case as large as it may be: its largest number is 2**28 to 2**30."""
    rows = [part if isinstance(part, tuple) else (part,) for part in drawn(draw)]
    scale = 2.0 ** (29 - frexp(max([abs(x) for row in rows for x in row]))[1] + draw.integer(0, 1))
    found = [tuple(x * scale for x in row) for row in rows]
    return tuple(row if len(row) > 1 else row[0] for row in found)


@maker
def sloping(draw: Draw, *, end: str = "") -> Case:
    """A way that leaves an axis by 1e-4 to 1e-1, most by 1e-3 to 8e-3. One of its ends, "first" or "last", is
    1.05e-7 to 1e-6 of the size off the circle; of an "origin" that of the circle, and the way is a ray's. It
    is mostly outside, and mostly does not cross the circle there.
    """
    r, often = draw.integer(2**40, 2**41) * 2.0 ** -draw.integer(15, 90), (*7 * [1], -1)
    lean = draw.integer(64, 127) / 2 ** draw.choice((draw.integer(10, 19), draw.integer(14, 16), 15, 16))
    off, outside, side = draw.choice((0, draw.integer(-40, 40) / 100)), draw.choice(often), draw.sign()
    half, length = sqrt(1 - off * off), sqrt(1 + lean * lean)
    step = draw.integer(20, 400) / 100 * draw.choice(often) * outside
    gap = draw.integer(105, draw.choice((125, 125, 200, 1000))) / 10**9 * outside / half
    near = half + gap * (1 if end == "origin" else max(1, abs(half + step), abs(step)))
    cx, cy, turn, mirror = draw.integer(-2, 2) * r, draw.integer(-2, 2) * r, draw.choice((1, -1)), draw.sign()
    ends = [((way * lean + off) / length, (way - off * lean) / length) for way in (near, near + step)]
    back = (end or draw.choice(("first", "last"))) == "last"
    A, B = ((cx + r * side * x * mirror, cy + r * side * y)[::turn] for x, y in ends[:: -1 if back else 1])
    return *(cx, cy)[::turn], r, A, B


def abreast(draw: Draw) -> Case:
    """A ray from hardly beside an axis through the centre, or hardly beside the centre or the foot; what is
    between them moves the point that it meets. The radius is not small.
    """
    far = draw.integer(2**40, 2**41) * 2.0 ** -draw.integer(13, 60)
    kind, turn = draw.choice(("across", "along", "nearly", "foot", "centre", "centre")), draw.choice((1, -1))
    dx, dy = (draw.integer(1, 9) * draw.sign() for _ in "xy")
    off, beside = (far * draw.integer(35, 49) / 10**10 * draw.sign() for _ in "xy")
    x, r, nearly = far * draw.sign(), far, draw.integer(102, 150) / 10**9
    if kind == "across":  # to where the circle is level with C or near it
        r, dx = far * draw.integer(102, 150) / 100, draw.integer(-1, 1)
    elif kind == "along":
        r, dy = far * draw.integer(20, 180) / 100 + far / 300, 0
    elif kind == "nearly":  # a slanting line that cuts by 1e-7 of the size
        dx, off = -abs(dx) if x > 0 else abs(dx), off / 100
        r = abs(x * dy - off * dx) / sqrt(dx * dx + dy * dy) + far * nearly
    elif kind == "foot":
        x, dx = x * (1 - nearly), 0
    else:
        x, dx = beside, dx * draw.integer(0, 1)
    cx, cy = (draw.choice((0, 0, 1, -2)) * far for _ in "xy")
    return *(cx, cy)[::turn], r, (cx + x, cy + off)[::turn], (dx, dy)[::turn]


_ON = points("on", **{**HUGE, "size": 2**30, "shift": -40})
LEANS = 1e-12, 1e-12, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8
