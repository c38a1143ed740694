"""Scenes of a circle and a line in ints of any size: Δ = r²·|D|² − k² is 0, or tiny beside its two terms.

    hairlines(10**30)                  touches: k = r·|D|, for D = (p, q) and |D| = c of a Pythagorean triple
    hairlines(10**30, off=(1, -1))     k = r·|D| ± 1
    least(10**30)                      Δ = 1 or -1
    just_past()                        Δ = -1 or -4 in 14 bits
    nearly(10**30)                     the line passes the circle by 1e-13 to 0.9 of the radius
    ends((10**30,), 1, -1)             |A − C|² − r² = ±1, and B anywhere

Each draws (cx, cy, r, A, B) with coordinates within ±size, or one of several sizes.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import gcd, isqrt

from judge.data.draw import Draw
from judge.geometry.level import Case, maker
from judge.geometry.scenes.signs import Whole, across, direction, fitted, near_circle


@maker
def hairlines(
    draw: Draw,
    *sizes: int,
    off: Sequence[int] = (0,),
    radius: int | None = None,
    away: int = 0,
    slid: Sequence[int] = (0,),
) -> Case:
    """Lines with k = r·|D| + off, either side of the centre.

    `radius` is that of all circles. The figure is moved by up to `away`, and A and B along the line by up to
    10**slid times D.
    """
    size = draw.choice(sizes)
    most = max(2, isqrt(size // 16))
    m, n = draw.integer(2, most), draw.integer(1, most)
    if m <= n or gcd(m, n) != 1 or (m - n) % 2 == 0:
        m, n = (n + 1, n) if draw.integer(0, 3) else (2, 1)
    r = draw.integer(1, max(1, size // 8)) if radius is None else radius
    product = r * (m * m + n * n) + draw.choice(off)
    return _line(draw, (m * m - n * n, 2 * m * n), product, r, max(size, away), draw.choice(slid))


@maker
def least(draw: Draw, *sizes: int) -> Case:
    """Lines with Δ = 1 or -1: k + r·√a is a power of n + √a for a = |D|² = n² + 1 (Pell's equation)."""
    size = draw.choice(sizes)
    power = draw.integer(1, 5)
    n = draw.integer(1, max(1, _root(size // 16, max(1, power - 1))))  # the line begins where r ends
    k, r = n, 1
    for _ in range(power - 1):
        k, r = k * n + r * (n * n + 1), k + r * n
    return _line(draw, (1, n) if draw.boolean() else (n, 1), k, r, size, 0)


@maker
def just_past(draw: Draw, *, either_way: bool = False) -> Case:
    """Lines with Δ = -1 or -4 in numbers of 14 bits: r²·|D|² and k² are beyond 2**53, and make one double."""
    n, times = draw.integer(6_890, 8_190), draw.integer(1, 2)
    A, B = (-1 - n, 2 * n - 1), (-1 + (times - 1) * n, 2 * n + times - 1)
    if either_way and not draw.boolean():
        A, B = B, A
    (cx, cy), A, B = fitted(draw, 2**14 - 1, [(0, 0), A, B])
    return cx, cy, 2 * n, A, B


@maker
def nearly(draw: Draw, *sizes: int) -> Case:
    """Lines of every slope that pass the circle, inside or outside, by 1e-13 to 0.9 of the radius."""
    size = draw.choice(sizes)
    way = direction(draw, max(1, size >> draw.integer(3, size.bit_length() - 1)))
    r = draw.integer(max(1, size // 32), size // 8)
    touch = isqrt(r * r * (way[0] ** 2 + way[1] ** 2))
    gap = touch * draw.integer(1, 9) // 10 ** draw.integer(1, 13)
    return _line(draw, way, touch + gap * draw.sign(), r, size, 0)


@maker
def ends(draw: Draw, sizes: Sequence[int], *off: int) -> Case:
    """Segments with an end for which |A − C|² − r² is one of `off`: 1, 0, -1. The other end is anywhere."""
    reach = draw.choice(sizes)
    x, y, r = near_circle(draw, reach // 8, draw.choice(off))
    far = draw.choice((r, 3 * r))
    end = draw.integer(-far, far), draw.integer(-far, far)
    if draw.integer(0, 3) == 0:  # across the circle, through the centre
        end = (-x, -y)
    (cx, cy), A, B = fitted(draw, reach, [(0, 0), (x, y), end])
    return (cx, cy, r, A, B) if draw.boolean() else (cx, cy, r, B, A)


def _line(draw: Draw, way: Whole, product: int, r: int, reach: int, slid: int) -> Case:
    """The line along `way` whose cross product with the centre is ±product."""
    steps = draw.integer(-(10**slid), 10**slid) if slid else draw.integer(-2, 1)
    start = across(way, product * draw.sign(), steps)
    times = draw.choice((1, 1, 2, 3))
    end = start[0] + times * way[0], start[1] + times * way[1]
    (cx, cy), A, B = fitted(draw, reach, [(0, 0), start, end])
    return (cx, cy, r, A, B) if draw.boolean() else (cx, cy, r, B, A)


def _root(number: int, power: int) -> int:
    """The whole part of a root, for a power up to 5, by bisection."""
    low, high = 0, 1 << number.bit_length() // power + 1
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if middle**power <= number else (low, middle)
    return low
