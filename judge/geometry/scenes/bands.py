"""Scenes in which a small part counts: ratios are drawn over a wide band, each power of two as often.

    ray                  (cx, cy, r, O, D), nearly along an axis, and nearly level with C, from near or far
    outside              (cx, cy, r, P), P beside the circle or far away
    duo(22)              (cx1, cy1, r1, cx2, cy2, r2), radii that are alike, or up to 1:2**22
    raised(ray)          (C, r, O, D) in space
    drifting             (P0, P1, r, Q0, Q1, s)
    driven               (P0, P1, r, A, B)

Nothing touches and no number is special, but that a coordinate of one of the points may be 0 or small.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot, sqrt

from judge.data.draw import Draw
from judge.geometry.level import Case, Scene, held, maker
from judge.geometry.pose import triple

Plane = tuple[float, ...]
# Where the square of a part of 1e-4 counts, and the fourth power of one of 1e-2, and anywhere.
_LEANS = (13, 15), (13, 15), (5, 7), (3, 30), (20, 29)


def share(draw: Draw, least: int, most: int) -> float:
    """2**-most to 2**-least."""
    return draw.integer(2**20, 2**21 - 1) / 2**20 * 2.0 ** -draw.integer(least + 1, most)


def unit(draw: Draw, *bands: tuple[int, int]) -> Plane:
    """A vector of length 1, nearly along an axis."""
    lean = share(draw, *draw.choice(bands or _LEANS)) * draw.sign()
    return (sqrt(1 - lean * lean) * draw.sign(), lean)[:: draw.choice((1, -1))]


def settled(draw: Draw, points: Sequence[Plane], size: float) -> list[Plane]:
    """The points, moved so that each coordinate of one of the first two is 0 or a small share."""
    columns = []
    for column in zip(*points, strict=True):
        at, times = draw.choice((*3 * [(0, 0)], (0, 1), (0, -1), (1, 0), (1, 1), (1, -1)))
        off = size * share(draw, *draw.choice(((6, 30), (24, 29)))) * times - column[at]
        columns.append([x + off for x in column])
    return list(zip(*columns, strict=True))


def ray(draw: Draw) -> Case:
    """A ray that meets a circle, mostly."""
    r = draw.integer(2**40, 2**41) * 2.0 ** -draw.integer(26, 60)
    O: Plane
    D: Plane
    if draw.integer(0, 2) == 0:  # along a way, at a height over it
        x, y = unit(draw)
        high = draw.choice((1 - share(draw, 1, 22), share(draw, 1, 30), share(draw, 12, 15))) * draw.sign()
        half = sqrt(1 - high * high)
        outside = 1 + share(draw, 0, 22), 1 / share(draw, 0, 14)
        at = half * draw.choice(
            (*outside, *outside, 1 - share(draw, 0, 22), share(draw, 1, 30) * draw.sign())
        )
        O = (-at * x - high * y) * r, (-at * y + high * x) * r
        D = x, y
        hit = (at - half if at > half else at + half) * r
        long = draw.choice((1, hit * (1 + share(draw, 1, 30)), hit * (1 - share(draw, 12, 30))))
        D = x * long, y * long
    else:  # from a place nearly level with C, to one that is nearly C or nearly level with it
        x, y = unit(draw)
        near = share(draw, *draw.choice(((5, 15), (0, 30))))
        far = r * draw.choice(
            (1 + share(draw, 1, 22), 1 / share(draw, 0, 14), 1 / share(draw, 9, 14), near, near)
        )
        O = far * x, far * y
        u, v = (r * draw.choice((share(draw, 0, 1), share(draw, 1, 30))) * draw.sign() for _ in "xy")
        D = u - O[0], v - O[1]
    (cx, cy), O = settled(draw, ((0.0, 0.0), O), max(r, *map(abs, O)))
    return held(draw, (cx, cy, r, O, tuple(D)))


def outside(draw: Draw) -> Case:
    """P beside a circle, just outside it, or far away."""
    r = draw.integer(2**40, 2**41) * 2.0 ** -draw.integer(26, 60)
    x, y = unit(draw)
    d = r * draw.choice((1 + share(draw, 0, 22), 1 / share(draw, 0, 13), 1 / share(draw, 0, 13)))
    (cx, cy), P = settled(draw, ((0.0, 0.0), (d * x, d * y)), d)
    return held(draw, (cx, cy, r, P))


def _touching(draw: Draw) -> Case:
    """Two circles that touch, exactly; C1 is hardly beside the origin or an axis."""
    (p, q, c), a, b = triple(draw, 65), draw.integer(2**8, 2**10), draw.integer(2**8, 2**10)
    d = a + draw.choice((b, b, -b)) or 1
    x, y = (draw.integer(2**7, 2**8) * 2.0 ** -draw.integer(10, 35) for _ in "xy")
    x, y = draw.choice(((x, y), (x, b), (b, y)))
    scale = 2.0 ** draw.choice((0, 10, -20, -40))
    p, q = p * d * draw.sign(), q * d * draw.sign()
    return tuple(n * scale for n in (x, y, a * c, x + p, y + q, b * c))


@maker
def duo(draw: Draw, most: int, *, chords: bool = True) -> Case:
    """Two circles, one of them up to 2**most times larger; some touch."""
    if draw.integer(0, 7) == 0:
        return _touching(draw)
    size = draw.integer(2**40, 2**41) * 2.0 ** -draw.integer(26, 60)
    small = draw.choice((share(draw, 0, most), 1 - share(draw, 1, 30), 1 - share(draw, 20, 29)))
    inner, outer = small * share(draw, 0, 22), small * (1 - share(draw, 0, 22))
    ways = 1 - small + inner, 1 + small - inner, 1 - small + outer, 1 + small + inner
    d = draw.choice((*ways, *4 * [share(draw, -1, 1)], 1 / share(draw, 0, 9)))
    kind = draw.integer(0, 7) if chords else 7
    if kind < 3:  # the common chord passes a centre
        d = share(draw, 0, 4)
        off = share(draw, *draw.choice(((2, 30), (18, 28)))) * draw.sign()
        small = sqrt(d * d + 1 - 2 * off * d)
    elif kind == 3:  # a speck on the other one
        small = share(draw, max(0, most - 4), most)
        d = 1 + small * draw.integer(-90, 90) / 100
    x, y = unit(draw)
    (a, b), (u, v) = settled(draw, ((0.0, 0.0), (d * x * size, d * y * size)), max(1, d) * size)
    one, other = (a, b, size), (u, v, small * size)
    return held(draw, (*one, *other) if draw.boolean() else (*other, *one))


@maker
def raised(draw: Draw, drawn: Scene) -> Case:
    """The same ray in space: it may leave its plane a little, which may be beside the centre."""
    cx, cy, r, O, D = drawn(draw)
    at, length = draw.integer(0, 2), hypot(*D)
    z, up = (draw.choice((0.0, share(draw, 12, 15), share(draw, 3, 30))) * draw.sign() for _ in "xy")
    z *= draw.choice((r, max(abs(O[0] - cx), abs(O[1] - cy))))
    C, O, D = ((*p[:at], n, *p[at:]) for p, n in (((cx, cy), 0.0), (O, z), (D, up * length)))
    return held(draw, (C, r, O, D))


def _bound(draw: Draw, start: Plane, D: Plane) -> Plane:
    """Where a motion from `start` along D ends: near there or far away, so that it is fast or slow."""
    times = draw.choice((1 + share(draw, 1, 20), 1 / share(draw, 0, 6), share(draw, 0, 3), 1))
    return tuple(x + times * d for x, d in zip(start, D, strict=True))


def drifting(draw: Draw) -> Case:
    """(P0, P1, r, Q0, Q1, s): one radius is small beside the other one, or one way."""
    cx, cy, R, O, D = ray(draw)
    length = hypot(*D)
    D = tuple(d / length * hypot(O[0] - cx, O[1] - cy) for d in D)
    P1 = _bound(draw, O, D)
    part = draw.choice((0.0, share(draw, 0, 30), share(draw, 10, 29), share(draw, 1, 10))) * R
    size = max(R, *map(abs, D)) * draw.choice((0, 1, share(draw, 10, 29), 1 / share(draw, 0, 5)))
    x, y = unit(draw)
    Q, way = (cx, cy), (x * size, y * size)
    end, P1 = (cx + way[0], cy + way[1]), (P1[0] + way[0], P1[1] + way[1])
    one, other = (O, P1, part), (Q, end, R - part)
    return held(draw, (*one, *other) if draw.boolean() else (*other, *one))


def driven(draw: Draw) -> Case:
    """(P0, P1, r, A, B): a disc comes to an end of a wall, or to its side; both lie nearly along axes."""
    A: Plane
    B: Plane
    start: Plane
    O: Plane
    D: Plane
    cx, cy, R, O, D = ray(draw)
    length, (x, y) = hypot(*D), unit(draw)
    if draw.boolean():  # to an end, and the other one is anywhere
        D = tuple(d / length * hypot(O[0] - cx, O[1] - cy) for d in D)
        far = R * draw.choice((1, share(draw, 0, 12), 1 / share(draw, 0, 10)))
        A, B = (cx, cy), (cx + x * far, cy + y * far)
    else:  # to a place of the side, which may be near an end
        far = R * draw.choice((1, 1 / share(draw, 0, 3), 1 / share(draw, 0, 10)))
        at, high = far * draw.choice((0.5, share(draw, 0, 25))), R * draw.choice((1.0, share(draw, 0, 20)))
        off = high + R * draw.choice((1, share(draw, 0, 22), 1 / share(draw, 0, 8)))
        start = (
            at
            + (off - high)
            * draw.choice((0.0, draw.integer(-300, 300) / 100, share(draw, 12, 15), share(draw, 2, 28))),
            off,
        )
        way = at - start[0], high - off
        R, flip = high, draw.sign()

        def turned(p: Plane) -> Plane:
            return cx + p[0] * x - p[1] * y * flip, cy + p[0] * y + p[1] * x * flip

        A, B, O = turned((0, 0)), turned((far, 0)), turned(start)
        D = way[0] * x - way[1] * y * flip, way[0] * y + way[1] * x * flip
    P1 = _bound(draw, O, D)
    return held(draw, (O, P1, R, *((A, B) if draw.boolean() else (B, A))))
