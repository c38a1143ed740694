"""The distance of a point from a line: |D × f| / |D| for D = B − A and f = A − P."""

from fractions import Fraction
from math import isqrt

from judge.geometry import Line
from judge.geometry.hooks import hooks
from judge.geometry.scenes import ASKEW, AXIS, BIG, OFFSET, PLAIN, STEEP, TILTED, TINY, corners, either, feet, grid, neighbours, ratios, speck, tried, uniform, whole
from judge.problem.declare import group

HOOKS = hooks("foot")
ANYWHERE = ("between", "beyond", "end")


def solve(A, B, P):
    return Line.through(*P, 0, A, B).distance()


def thin(draw):
    """P is the whole point next to a point of the line, in coordinates below 2**21."""
    (ax, ay), (dx, dy) = (tuple(draw.integer(-(2**20), 2**20) for _ in "xy") for _ in "AD")
    part = draw.integer(1, 2**20)
    shift = 2.0 ** draw.choice((0, -10))
    A, B, P = (ax, ay), (ax + dx, ay + dy), (ax + (dx * part >> 20), ay + (dy * part >> 20))
    return tuple(tuple(x * shift for x in point) for point in (A, B, P))


def askew(draw):
    """A line along an axis or hardly leaning from it, and P 4 to 9,000 billionths of its length away."""
    n, small, turn = draw.integer(1, 2**20), 2.0 ** draw.integer(-40, 9), draw.choice((1, -1))
    lean, off = (draw.integer(4, 9) * draw.sign() * 10.0 ** -draw.integer(6, 9) for _ in "ab")
    y, v = draw.choice(((0.0, off), (0.0, off), (lean, off), (lean, 0.0)))
    A, B, P = (0.0, 0.0), (n, n * y), (n * draw.integer(-16, 16) / 8, n * v)
    start = draw.choice((0.0, 0.0, float(draw.integer(-9, 9))))
    A, B, P = ((x * small, (start + y) * small)[::turn] for x, y in (A, B, P))
    return (A, B, P) if draw.boolean() else (B, A, P)


def closer(draw):
    """A and B are 1.02e-8 to 1.2e-8 of their distance from P apart, or three times that, in 53 bits."""
    ax, ay = (draw.integer(2**52, 2**53 - 2**30) for _ in "xy")
    size = isqrt(ax * ax + ay * ay) * draw.integer(102, 120) * draw.choice((1, 3, 3)) // 10**10
    dx = draw.integer(-size, size)
    dy = isqrt(size * size - dx * dx) * draw.sign()
    unit = 2.0 ** -draw.integer(23, 140)
    x, y = unit * draw.sign(), unit * draw.sign()
    return (ax * x, ay * y), ((ax + dx) * x, (ay + dy) * y), (0.0, 0.0)


def blurred(case):
    """Whether A × B, of products in doubles, puts a line beside the origin off by 1.3e-9 of the size."""
    (ax, ay), (bx, by), _ = case
    x, y, u, v = map(Fraction, (ax, ay, bx, by))
    off = abs(Fraction(ax * by - ay * bx) - (x * v - y * u)) * 10**10
    return off * off > 169 * max(x * x, y * y, u * u, v * v) * ((u - x) ** 2 + (v - y) ** 2)


def breadth(draw):
    """A and B are a few doubles apart, where those are 1e-46 to 1e-41 apart, and P is near them or not."""
    unit, (i, j) = 2.0 ** -draw.integer(135, 151), draw.choice(((1, 0), (0, 1), (1, 1), (2, -1)))
    x, y = (draw.integer(2**52, 2**53 - 3) for _ in "xy")
    A, B = (x * unit, (y + 1) * unit), ((x + i) * unit, (y + 1 + j) * unit)
    size = draw.choice((2.0**-99, 1))
    return A, B, (draw.integer(-9, 9) * size, draw.integer(-9, 9) * size)


def parts(draw):
    """A, B and P of a line and a circle."""
    x, y, _, A, B = ratios()(draw)
    return A, B, (x, y)


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", grid("ppp", 3), cases=180, skills="distance of point and line"),
    group("left-right", "P is on the left of A→B or on the right.", feet("between", "beyond", **PLAIN), skills="distance of point and line"),
    group("beyond", "The foot of the perpendicular is before A or after B: the line goes on there.", feet("beyond", **PLAIN), skills="a line has no ends"),
    group("axis", "Upright and level lines.", feet(*ANYWHERE, **AXIS), skills="no slopes"),
    group("on-line", "P is on the line.", feet("between on", "beyond on", "end on", **PLAIN), skills="distance of point and line"),
    group("same-point", "A equals B: there is no line.", feet("same", **PLAIN), skills="degenerate line"),
    group("random", "Any numbers, small and large.", uniform("ppp", 20, 1e4, 1e9), skills="scale invariance"),
]

PRODUCTION = [  # the same, where rounding bites
    group("long", "A and B are up to a million times farther apart than P is from the line, or closer together.", either(feet("between near", "beyond near", "close", **BIG), *2 * [askew]), cases=120, skills="distance of point and line"),
    group("steep", "Directions almost along an axis.", either(feet(*ANYWHERE, **ASKEW), feet(*ANYWHERE, **STEEP), feet(*ANYWHERE, **TILTED), feet("close", **{**TILTED, "move": 0})), cases=85, skills="no slopes"),
    group("small-parts", "A coordinate, a product or the short side of a triangle is tiny beside the others, and still counts.", parts, skills="distance of point and line"),
    group("thin", "P is hardly beside a line of whole numbers: doubles hold the cross product exactly, but no foot.", thin, tolerance={"ulps": 8}, skills="multiply before you divide"),
    group("offset", "A small figure far from the origin.", feet(*ANYWHERE, **OFFSET), skills="far from the origin"),
    group("close-points", "A and B are close together, and still two points.", either(*4 * [*2 * [feet("close", **{**PLAIN, "move": 0, "shift": (-30, -60)})], speck, neighbours], *3 * [tried(closer, blurred)], *2 * [breadth]), cases=132, skills="degenerate line"),
    group("tiny", "All of it tiny, down to 1e-29.", feet(*ANYWHERE, **TINY), skills="scale invariance"),
    group("large", "Whole numbers up to 2**30.", either(whole("ppp", 30), feet("between", "beyond near", **{**BIG, "shift": 0, "numbers": "int"})), skills="whole numbers that are large"),
    group("corners", "Whole numbers at the ends of the bounds: a difference leaves 32 bits, a sum of squares 64.", corners("ppp", 30), skills="whole numbers that are large"),
    group("repeated", "Neighbouring calls differ in one argument.", grid("ppp", 3), turns=True, skills="nothing kept between calls"),
]
