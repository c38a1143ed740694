"""Scenes of whole numbers: what decides is 0, or as small as whole numbers allow.

    scattered("nrp", 9)                ints up to 9, in any shape
    beside_line((reach,), 0)           (A, B, P), P on the line
    beside_line((reach,), 1, -1)       (A, B, P), the cross product of B − A and P − A is 1 or -1
    right_angles((reach,), 0)          (A, B, P), P on the circle with the diameter AB
    beside_circle((reach,), 0)         (cx, cy, r, P), |P − C|² − r² is 0
    level((reach,))                    (A, B, P), the line AB is horizontal or vertical
    cuts(reach, close=False)           (cx, cy, r, A, B), r²·|D|² − k² is 0

All coordinates are ints within ±reach, which is one of several.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from math import gcd, isqrt
from typing import Any

from judge.data.draw import Draw
from judge.geometry.level import Case, Scene, maker
from judge.geometry.pose import triple

Whole = tuple[int, int]


def fitted(draw: Draw, reach: int, points: Sequence[Whole]) -> list[Whole]:
    """The points turned by a symmetry of the axes, and moved to anywhere within reach."""
    sign, other, swap = draw.sign(), draw.sign(), draw.boolean()
    turned = [(sign * x, other * y) for x, y in points]
    if swap:
        turned = [(y, x) for x, y in turned]
    moves = []
    for axis in zip(*turned, strict=True):
        least, most = -reach - min(axis), reach - max(axis)
        if least > most:
            draw.reject()
        moves.append(draw.integer(least, most))
    return [(x + moves[0], y + moves[1]) for x, y in turned]


def direction(draw: Draw, size: int) -> Whole:
    """(p, q) without a common factor, each at most `size`."""
    p, q = draw.integer(0, size), draw.integer(0, size)
    if gcd(p, q) != 1:
        draw.reject()
    return p, q


def across(way: Whole, product: int, steps: int) -> Whole:
    """The whole point with this cross product, way × point; `steps` times the way from the first one.

    By the extended Euclidean algorithm; `way` has no common factor.
    """
    p, q = way
    x, y = 0, product * p  # for |p| = 1, q = 0 and the like
    if q:
        y = product * pow(p, -1, q) % q if abs(q) > 1 else 0
        x = (p * y - product) // q
    return x + steps * p, y + steps * q


def hardly(draw: Draw, size: int) -> Whole:
    """Up to twice this size along the y axis, and two steps at most along the other one."""
    most = draw.choice((2 * size, 2 * size, 2 * size, size, size // 100))
    return draw.choice((0, 0, 1, 1, 2)) * draw.sign(), most - draw.integer(0, most // 9)


@maker
def scattered(draw: Draw, shape: str, *reaches: int) -> Case:
    """Ints within one of `reaches`, a third of them near its ends: n a number, r one from 1 on, p a point."""
    size = draw.choice(reaches)

    def number() -> int:
        far = size if draw.integer(0, 2) else min(size, 9)
        return (size - draw.integer(0, far)) * draw.sign() if far < size else draw.integer(-size, size)

    kinds: dict[str, Callable[[], Any]] = {
        "n": number,
        "r": lambda: abs(number()) or 1,
        "p": lambda: (number(), number()) if draw.integer(0, 11) else (0, 0),
    }
    return tuple(kinds[kind]() for kind in shape)


def ints(drawn: Scene) -> Scene:
    """The same draws, their whole floats as ints."""

    def whole(part: Any) -> Any:
        return tuple(map(int, part)) if isinstance(part, tuple) else int(part)

    return lambda draw: tuple(whole(part) for part in drawn(draw))


@maker
def beside_line(draw: Draw, reaches: Sequence[int], *off: int) -> Case:
    """A, B and P, where (B − A) × (P − A) is one of `off`, or twice that."""
    size = draw.choice(reaches)
    way, times = direction(draw, size), draw.choice((1, 1, 1, 2))
    P = across(way, draw.choice(off), draw.integer(-1, 1))
    points = fitted(draw, size, [(0, 0), (times * way[0], times * way[1]), P])
    return tuple(points if draw.boolean() else (points[1], points[0], points[2]))


@maker
def right_angles(draw: Draw, reaches: Sequence[int], *off: int) -> Case:
    """A, B and P, where (A − P)·(B − P) is one of `off`, or B is P."""
    size = draw.choice(reaches)
    way = direction(draw, size)
    x, y = across(way, draw.choice(off), draw.integer(-1, 1))
    A, B, P = fitted(
        draw, size, [way, (y, -x), (0, 0)]
    )  # a quarter turn makes a dot product of a cross product
    if A == B:
        draw.reject()
    return (A, B, P) if draw.boolean() else (B, A, P)


@maker
def beside_circle(draw: Draw, reaches: Sequence[int], *off: int) -> Case:
    """A circle and P with |P − C|² − r² one of 1, 0 and -1."""
    size = draw.choice(reaches)
    x, y, r = near_circle(draw, size // 2, draw.choice(off))
    (cx, cy), P = fitted(draw, size, [(0, 0), (x, y)])
    return cx, cy, r, P


def near_circle(draw: Draw, size: int, off: int) -> tuple[int, int, int]:
    """(x, y, r) with x² + y² − r² = off and r <= size, as y² − off = (r − x)(r + x)."""
    if off == 0:
        p, q, c = (1, 0, 1) if size < 5 or draw.integer(0, 3) == 0 else triple(draw, min(size, 4_418))
        k = draw.integer(1, size // c)
        return p * k, q * k, c * k
    if off == 1:  # y = 2ab ± 1
        a = draw.integer(1, max(1, isqrt(isqrt(size)) // 2))
        most = max(1, isqrt(size // a) - 1)
        b, side = draw.integer(most // 2 + 1, most), draw.sign()
        y, less, more = 2 * a * b + side, 2 * a, 2 * b * (a * b + side)
    else:
        most = max(1, isqrt(size // 2))
        y = 2 * draw.integer(most // 2 + 1, most)
        less = 5 if y % 5 in (2, 3) else 1
        more = (y * y + 1) // less
    x, r = abs(more - less) // 2, (more + less) // 2
    if not 1 <= r <= size:
        draw.reject()
    return x, y, r


@maker
def level(
    draw: Draw, reaches: Sequence[int], drawn: Callable[[Draw, int], tuple[int, int, int]] | None = None
) -> Case:
    """A and B on a horizontal or vertical line, and P anywhere; `drawn` draws where they are along it."""
    size = draw.choice(reaches)
    a, b, p = drawn(draw, size) if drawn else tuple(draw.integer(-size, size) for _ in "ABP")
    if a == b:
        draw.reject()
    y = draw.integer(-size, size)
    points = [(a, y), (b, y), (p, draw.integer(-size, size))]
    return tuple(points if draw.boolean() else [(v, u) for u, v in points])


@maker
def cuts(draw: Draw, reach: int, *, close: bool) -> Case:
    """A circle and a line in small numbers that touch, or miss touching by as little as can be."""
    if close:
        found = _narrowest(draw.choice((0, draw.integer(1, 2 * reach))), reach)
        way, product, r = found[draw.integer(0, draw.choice((0, 1, len(found) - 1)))]
    else:
        p, q, c = (1, 0, 1) if draw.integer(0, 3) == 0 else triple(draw, max(5, reach))
        r = draw.integer(1, reach)
        way, product = (p, q), c * r
    start = across(way, product * draw.sign(), draw.integer(-1, 0))
    times = draw.choice((1, -1)) if max(way) * 2 > reach else draw.choice((1, 1, -1, 2))
    end = start[0] + times * way[0], start[1] + times * way[1]
    (cx, cy), A, B = fitted(draw, reach, [(0, 0), start, end])
    return cx, cy, r, A, B


@cache
def _narrowest(dx: int, reach: int) -> list[tuple[Whole, int, int]]:
    """Directions (dx, up), cross products and radii that nearly touch, the nearest first: 3, or 20 of all."""
    if dx == 0:
        every = [each for width in range(1, 2 * reach + 1) for each in _gaps(width, reach)]
        return [near for _, near in sorted(every)[:20]]
    return [near for _, near in sorted(_gaps(dx, reach))[:3]]


def _gaps(dx: int, reach: int) -> list[tuple[float, tuple[Whole, int, int]]]:
    found = []
    for up in (up for up in range(dx + 1) if gcd(dx, up) == 1):
        square = dx * dx + up * up
        for r in range(1, reach + 1):
            root = isqrt(r * r * square)
            for k in (root, root + 1):
                if off := abs(k * k - r * r * square):
                    found.append((off / (square * r), ((dx, up), k, r)))
    return found
