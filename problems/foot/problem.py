"""The foot of the perpendicular on a line: t = (C − A)·D / D·D and A + t·D, both rational."""

from judge.geometry import Line
from judge.geometry.hooks import hooks
from judge.geometry.scenes import ASKEW, AXIS, BIG, LEVEL, OFFSET, PLAIN, STEEP, TILTED, TINY, corners, either, feet, grid, neighbours, ratios, slim, speck, uniform, whole
from judge.problem.declare import group

HOOKS = hooks("foot")
ANYWHERE = ("between", "beyond", "end")


def solve(A, B, C):
    return Line.through(*C, 0, A, B).foot()


def remote(draw):
    """Points of a grid of 3, 2**29 to 2**30 away from the origin, in units of 1 to 2**-8."""
    unit, far = 2.0 ** -draw.integer(0, 8), [draw.integer(2**29, 2**30 - 9) * draw.sign() for _ in "xy"]
    return tuple(tuple(at + unit * draw.integer(0, 3) for at in far) for _ in "ABC")


def hair(draw):
    """A and B differ only in a coordinate near 0, by less than a double holds beside the other one."""
    a, b = (draw.integer(-9, 9) * 2.0 ** -draw.integer(60, 90) for _ in "AB")
    if a == b:
        draw.reject()
    y, C = draw.integer(1, 9) * draw.sign(), (draw.integer(-9, 9), draw.integer(-9, 9))
    return ((a, y), (b, y), C) if draw.boolean() else ((y, a), (y, b), C)


def breadth(draw):
    """A and B are a few doubles apart, where those are 1e-46 to 1e-41 apart, and C is near them or not."""
    unit, (i, j) = 2.0 ** -draw.integer(135, 151), draw.choice(((1, 0), (0, 1), (1, 1), (2, -1), (1, 3)))
    x, y = (draw.integer(2**52, 2**53 - 4) for _ in "xy")
    A, B = (x * unit, (y + 1) * unit), ((x + i) * unit, (y + 1 + j) * unit)
    size = draw.choice((2.0**-99, 1))
    return A, B, (draw.integer(-9, 9) * size, draw.integer(-9, 9) * size)


def above(draw):
    """Three points above one another, or beside: what they share is 1e6 to 1e37 times as large as what they do not."""
    x, unit, turn = draw.integer(1, 2**30) * draw.sign(), 2.0 ** -draw.integer(20, 92), draw.choice((1, -1))
    return tuple((x, draw.integer(-99, 99) * unit)[::turn] for _ in "ABC")


def halves(draw):
    """The foot is next to A, B or the middle between them, by 1.2e-9 to 9.9e-9 of their distance."""
    (dx, dy), (x, y) = ((draw.integer(-9, 9), draw.integer(-9, 9)) for _ in "DA")
    if not (dx or dy):
        draw.reject()
    t = draw.choice((0, 1, 1, 1, 2)) / 2 + draw.integer(12, 99) * draw.sign() / 10**10
    high, size = draw.choice((0, draw.integer(-4, 4) / 16)), 2.0 ** draw.choice((0, draw.integer(-60, 20)))
    points = (x, y), (x + dx, y + dy), (x + t * dx - high * dy, y + t * dy + high * dx)
    return tuple((u * size, v * size) for u, v in points)


def parts(draw):
    """A, B and C of a line and a circle."""
    x, y, _, A, B = ratios()(draw)
    return A, B, (x, y)


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", grid("ppp", 3), cases=180, skills="project onto a line"),
    group("left-right", "C is on the left of A→B or on the right.", feet("between", "beyond", **PLAIN), skills="project onto a line"),
    group("beyond", "The foot of the perpendicular is before A or after B: the line goes on there.", feet("beyond", **PLAIN), skills="a line has no ends"),
    group("axis", "Upright and level lines.", feet(*ANYWHERE, **AXIS), skills="no slopes"),
    group("on-line", "C is on the line.", feet("between on", "beyond on", "end on", **PLAIN), skills="project onto a line"),
    group("same-point", "A equals B: there is no line.", feet("same", **PLAIN), skills="degenerate line"),
    group("random", "Any numbers, small and large.", uniform("ppp", 20, 1e4, 1e9), skills="scale invariance"),
]

PRODUCTION = [  # the same, where rounding bites
    group("long", "A and B are up to a million times farther apart than C is from the line, or closer together; or the foot is next to one of them, or to the middle.", either(*4 * [feet("between near", "beyond near", "close", **BIG), *2 * [slim]], halves), cases=195, skills="project onto a line"),
    group("steep", "Directions almost along an axis.", either(feet(*ANYWHERE, **ASKEW), feet(*ANYWHERE, **STEEP), feet(*ANYWHERE, **TILTED), *[feet("close", **{**TILTED, "size": 4, "move": 0, "tilt": (26, 30)})] * 2), cases=125, skills="no slopes"),
    group("small-parts", "A coordinate, a product or the short side of a triangle is tiny beside the others, and still counts.", parts, skills="project onto a line"),
    group("remote", "Three points of a small grid, 5e8 away from the origin: the foot is no double.", remote, skills="far from the origin"),
    group("offset", "A small figure far from the origin.", either(*2 * [feet(*ANYWHERE, **OFFSET)], feet(*ANYWHERE, **LEVEL), above), cases=90, skills="far from the origin"),
    group("close-points", "A and B are close together, and still two points.", either(*3 * [*3 * [feet("close", **{**PLAIN, "move": 0, "shift": (-30, -60)})], speck, hair, neighbours], *3 * [breadth]), cases=112, skills="degenerate line"),
    group("tiny", "All of it tiny, down to 1e-29.", feet(*ANYWHERE, **TINY), skills="scale invariance"),
    group("large", "Whole numbers up to 2**30.", either(whole("ppp", 30), feet("between", "beyond near", **{**BIG, "shift": 0, "numbers": "int"})), skills="whole numbers that are large"),
    group("corners", "Whole numbers at the ends of the bounds: a difference leaves 32 bits, a sum of squares 64.", corners("ppp", 30), skills="whole numbers that are large"),
    group("repeated", "Neighbouring calls differ in one argument.", grid("ppp", 3), turns=True, skills="nothing kept between calls"),
]
