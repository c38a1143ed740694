"""The common points of a circle and a line in ints of any size: no tolerance, no promise."""

from math import gcd

from judge.geometry import whole
from judge.geometry.hooks import hooks
from judge.geometry.scenes import AXIS, PLAIN, either, grid, hairlines, lines, signs, tried
from judge.problem.declare import group

HOOKS = hooks("line")
INT, INT_AXIS, WIDE = {**PLAIN, "numbers": "int"}, {**AXIS, "numbers": "int"}, {**PLAIN, "numbers": "int", "size": 1000}


def solve(cx, cy, r, A, B):
    return whole.count_line(cx, cy, r, A, B)


def level(draw):
    """Upright and level lines that cut, touch and miss by 1, at 1e6 to 1e40."""
    size = draw.choice((10**6, 10**40))
    r, at, other = draw.integer(1, size // 4), draw.integer(-size, size), draw.integer(-size, size)
    (cx, cy), A, B = signs.fitted(draw, 3 * size, [(0, 0), (at, r + draw.integer(-1, 1)), (other, 0)])
    B = (B[0], A[1]) if draw.boolean() else (A[0], B[1])
    return cx, cy, r, A, B


def odd(draw):
    """k is r·|D| ± 1, a little above 2**53, where a double holds every second number."""
    m, n = draw.integer(9000, 11000), draw.integer(1, 3000)
    if gcd(m, n) != 1 or (m - n) % 2 == 0:
        draw.reject()
    way, length = (m * m - n * n, 2 * m * n), m * m + n * n
    r = draw.integer(2**53 // length + 1, 2**27 - 1)
    product = (r * length + draw.sign()) * draw.sign()
    x, y = signs.across(way, product, 0)
    start = signs.across(way, product, -((x * way[0] + y * way[1]) // length**2))
    (cx, cy), A, B = signs.fitted(draw, 2**29, [(0, 0), start, (start[0] + way[0], start[1] + way[1])])
    return cx, cy, r, A, B


def brim(draw):
    """Δ is 1, 4 or 9 at the end of the bounds, where k² and r²·|D|² have 480 and 481 digits."""
    n, times, steps = draw.integer(4 * 10**119, 5 * 10**119 - 9), draw.integer(1, 3), draw.integer(-2, 0)
    ends = [(1 + step * n, step - 2 * n) for step in (steps, steps + times)]
    (cx, cy), A, B = signs.fitted(draw, 10**120, [(0, 0), *ends])
    return cx, cy, 2 * n, A, B


def shared(p, q):
    """The greatest common divisor of two whole complex numbers, (x, y) each."""
    while q != (0, 0):
        (a, b), (c, d), square = p, q, q[0] ** 2 + q[1] ** 2
        x, y = ((2 * part + square) // (2 * square) for part in (a * c + b * d, b * c - a * d))
        p, q = q, (a - x * c + y * d, b - x * d - y * c)
    return p


def nicked(draw):
    """Δ is 1 at the end of the bounds: r² divides k² + 1, and what is left is a sum of two squares."""
    p, q = (draw.integer(5 * 10**59, 7 * 10**59) for _ in "pq")
    r = p * p + q * q
    if gcd(p, q) != 1 or r % 2 == 0:
        draw.reject()
    k = p * pow(q, -1, r) % r
    k += r * (-(k * k + 1) // r * pow(2 * k, -1, r) % r + draw.integer(0, 1) * r)
    way = shared(((k * k + 1) // r**2, 0), (k, 1))
    x, y = signs.across(way, k, 0)
    steps = -((x * way[0] + y * way[1]) // (way[0] ** 2 + way[1] ** 2)) - draw.integer(0, 1)
    start, end = (signs.across(way, k, at) for at in (steps, steps + draw.sign()))
    (cx, cy), A, B = signs.fitted(draw, 10**120, [(0, 0), start, end])
    return cx, cy, r, A, B


def multiples(draw):
    """All numbers are multiples of a power of two or of 2**61 - 1, so that Δ leaves no remainder modulo any usual number."""
    times = draw.choice((2 ** draw.integer(16, 99), 2**61 - 1))
    cx, cy, r, A, B = signs.scattered("nnrpp", 10, 100)(draw)
    return cx * times, cy * times, r * times, (A[0] * times, A[1] * times), (B[0] * times, B[1] * times)


def borders(draw):
    """A level or upright line along one border of what 16 bits hold, and a circle at the other: k² has 64 bits."""
    a, b, c, d = (draw.integer(29_500, 2**15 - 1) for _ in "abcd")
    up, flip = draw.sign(), draw.boolean()
    (cx, cy), A, B = (part[::-1] if flip else part for part in ((draw.integer(-d, d), -c * up), (-a, b * up), (d, b * up)))
    return cx, cy, draw.integer(1, d), A, B


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", signs.ints(grid("nnrpp", 3)), cases=220, skills="distance against radius"),
    group("same-point", "A equals B: there is no line.", lines("cut before =", "cut in =", "touch foot =", "miss by =", **INT), skills="degenerate line"),
    group("radius-zero", "The circle is a point: on the line, or beside it.", lines("dot ?by ?by", "dot foot ?by", "dot-miss ?by ?by", **INT), skills="r = 0"),
    group("axis", "Upright and level lines.", lines("cut ?by ?by", "touch ?by ?by", "miss ?by ?by", **INT_AXIS), skills="no slopes"),
    group("tangent", "The line touches, in every direction.", either(lines("touch before after", "touch foot by", "touch ?by ?by", **INT), lines("touch ?by ?by", **WIDE)), skills="collapse the tangent"),
    group("off-segment", "The line cuts the circle, the segment from A to B does not.", lines("cut after after", "cut before before", "cut in in", **INT), skills="a line has no ends"),
    group("scattered", "Anything anywhere within a hundred units.", signs.scattered("nnrpp", 10, 100), cases=80, skills="distance against radius"),
    group("repeated", "Neighbouring calls differ in one argument.", signs.ints(grid("nnrpp", 5)), turns=True, skills="nothing kept between calls"),
]

PRODUCTION = [  # the same, where rounding bites
    group("tangent-huge", "Touches at 1e6 to 1e119: no double holds their squares.", hairlines.hairlines(10**6, 10**12, 10**40, 10**119), cases=80, skills="integers of any size"),
    group("just-off", "The least that ints allow: r²a − k² is 1 or -1.", either(*[hairlines.least(10**3, 10**4, 10**6, 10**20, 10**50, 10**100, 10**119)] * 8, brim, tried(nicked)), cases=200, skills="exact count for integers"),
    group("hairline", "The line cuts or misses by a hair at 1e4 to 1e15: k is r·|D| ± 1, or nearer.", either(*[hairlines.hairlines(10**6, 10**9, 10**15, off=(1, -1, 2, -2))] * 12, *6 * [odd], hairlines.just_past()), cases=170, skills="exact count for integers"),
    group("hairline-huge", "The same at 1e30 to 1e100: beyond any fixed number of digits.", hairlines.hairlines(10**30, 10**60, 10**100, off=(1, -1)), cases=100, skills="integers of any size"),
    group("wide", "Anything anywhere within 1e6 to 1e120: products leave 64 bits, 128 bits, and then any float.", either(*7 * [signs.scattered("nnrpp", 10**6, 10**9, 10**12, 10**30, *[2 * 10**75] * 3, 10**100, 10**120)], multiples), cases=184, skills="integers of any size"),
    group("offset", "A small figure so far from the origin that a double cannot tell its points apart.", either(*[hairlines.hairlines(10**3, off=(0, 0, 1, -1, 200, -200), away=10**far) for far in (17, 40, 100)]), cases=80, skills="far from the origin"),
    group("slid", "A and B are close together and 1e20 to 1e60 lengths away along the line.", hairlines.hairlines(10**3, 10**6, off=(0, 1, -1), away=10**70, slid=(20, 40, 60)), skills="integers of any size"),
    group("radius-zero-huge", "The circle is a point at 1e6 and 1e40: on the line, or next to it.", hairlines.hairlines(10**6, 10**40, off=(0, 1, -1), radius=0), skills="integers of any size"),
    group("axis-huge", "Upright and level lines at 1e6 and 1e40, and far from the circle at 3e4.", either(*5 * [level], borders), cases=70, skills="integers of any size"),
    group("nearly", "The line passes the circle by 1e-13 to 0.9 of the radius, in every direction.", tried(hairlines.nearly(10**20, 10**40)), cases=160, skills="no slopes"),
]
