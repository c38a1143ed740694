"""The normal form of a line: its left unit normal, and the origin's signed distance."""

from judge.geometry import Line
from judge.geometry.hooks import hooks
from judge.geometry.scenes import ASKEW, AXIS, BIG, OFFSET, PLAIN, STEEP, TILTED, TINY, corners, either, feet, grid, neighbours, ratios, slim, speck, uniform, whole
from judge.problem.declare import group

HOOKS = hooks("normal form")


def solve(A, B):
    return Line.through(0, 0, 0, A, B).normal_form()


def ends(*plans, **pose):
    """A and B of a figure with a point beside the line; where `home` holds, one of them is the origin."""
    home, drawn = pose.pop("home", False), feet(*plans, **pose)

    def draw_case(draw):
        A, B, _ = drawn(draw)
        if not home:
            return A, B
        B = B[0] - A[0], B[1] - A[1]
        return ((0, 0), B) if draw.boolean() else (B, (0.0, 0.0))

    return draw_case


def pair(drawn):
    """A and B of three points."""
    return lambda draw: drawn(draw)[:2]


def hair(draw):
    """A and B differ only in a coordinate near 0, by less than a double holds beside the other one."""
    a, b = (draw.integer(-9, 9) * 2.0 ** -draw.integer(60, 90) for _ in "AB")
    if a == b:
        draw.reject()
    y = draw.integer(1, 9) * draw.sign()
    return ((a, y), (b, y)) if draw.boolean() else ((y, a), (y, b))


def close(draw):
    """A and B are 4e-9 to 6e-8 of their numbers apart, in any direction: a cross product of them loses the rest."""
    unit, size = 2.0 ** -draw.integer(23, 60), 2 ** draw.integer(25, 26)
    (x, y), (dx, dy) = (tuple(draw.integer(low, 2 * low - 1) * draw.sign() for _ in "xy") for low in (2**52 - size, size))
    return (x * unit, y * unit), ((x + dx) * unit, (y + dy) * unit)


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", grid("pp", 4), cases=180, skills="left and right of a line"),
    group("reversed", "Lines in every direction: from B to A the left becomes the right.", ends("between", **PLAIN), skills="left and right of a line"),
    group("axis", "Upright and level lines.", ends("between", **AXIS), skills="no slopes"),
    group("from-origin", "A or B is the origin itself.", ends("between", home=True, **PLAIN), skills="distance of point and line"),
    group("same-point", "A equals B: there is no line.", ends("same", **PLAIN), skills="degenerate line"),
    group("random", "Any numbers, small and large.", uniform("pp", 20, 1e4, 1e9), skills="scale invariance"),
]

PRODUCTION = [  # the same, where rounding bites
    group("long", "A and B are up to 1e9 times farther apart than the line is from the origin, or closer together.", either(*3 * [ends("between near", **BIG), ends("close", **{**BIG, "move": 12})], close, close, hair, pair(neighbours), *5 * [pair(slim)]), cases=150, skills="distance of point and line"),
    group("steep", "Directions almost along an axis.", either(ends("between", **ASKEW), ends("between", **STEEP), ends("between", **TILTED)), cases=85, skills="no slopes"),
    group("small-parts", "A coordinate, a product or the short side of a triangle is tiny beside the others, and still counts.", lambda draw: ratios(centred=True)(draw)[3:], skills="distance of point and line"),
    group("offset", "A small figure far from the origin.", ends("between", **OFFSET), skills="distance of point and line"),
    group("tiny", "All of it tiny, down to 1e-29, and A and B may be nearly one: a line all the same.", either(*2 * [ends("between", "close", **{**TINY, "move": 14}), ends("between", **{**TINY, "turn": "axis"})], pair(speck)), cases=75, skills=("degenerate line", "scale invariance")),
    group("large", "Whole numbers up to 2**30.", either(whole("pp", 30), ends("between near", **{**BIG, "shift": 0, "numbers": "int"})), skills="whole numbers that are large"),
    group("corners", "Whole numbers at the ends of the bounds: a difference leaves 32 bits, a sum of squares 64.", corners("pp", 30), cases=12, skills="whole numbers that are large"),
    group("repeated", "Neighbouring calls differ in one argument.", grid("pp", 4), turns=True, skills="nothing kept between calls"),
]
