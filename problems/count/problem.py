"""Line and circle: how many common points, by the exact sign of d − r."""

from functools import partial

from judge.geometry import Line, plain
from judge.geometry.hooks import hooks
from judge.geometry.scenes import ASKEW, AXIS, BIG, DECIMALS, FAR, HUGE, NEAR, OFFSET, PLAIN, SPLIT, STEEP, TILTED, TINY, astray, closed_up, corners, either, grid, lines, minute, mote, pinpoint, ratios, signs, slivers, telling, terse, tried, uniform, unsigned, whole
from judge.problem.declare import group

HOOKS = hooks("line")
TOUCHES = ("touch before after", "touch foot after", "touch ?by ?near")
TELLING = plain.count, partial(plain.count, tolerance=1e-10)
CLEAR = {**NEAR, "least": 7}


def spread(draw, far=-24):
    """A level or upright touch in numbers of 1e-30 to 1e9, of which exact products have hundreds of digits."""
    near, r, far = (draw.integer(2**52, 2**53) * 2.0**power for power in (-151, draw.choice((-56, -100, -151)), far))
    ends = [(near, r * draw.sign())]
    ends.insert(draw.integer(0, 1), (far * draw.sign(), ends[0][1]))
    return 0, 0, r, *(ends if draw.boolean() else [end[::-1] for end in ends])


def beside(cx, cy, _, A, B):
    """How far a program that goes to the foot of the perpendicular, and once more, ends beside C; along an axis."""
    (px, py), (dx, dy) = (A[0] - cx, A[1] - cy), (B[0] - A[0], B[1] - A[1])
    for _ in range(2):
        t = -(px * dx + py * dy) / (dx * dx + dy * dy)
        px, py = px + t * dx, py + t * dy
    return px + py


def upright(draw):
    """A touch where the circle is nearly highest: 3e-5 to 1e-4 of the radius beside that place."""
    n, m, side = draw.integer(20_500, 60_000), draw.integer(1 << 10, 1 << 14), draw.sign()
    p, q, scale, turn = 2 * n, n * n - 1, 2.0 ** -draw.integer(20, 60), draw.choice((1, -1))
    ways = draw.integer(-2 * m, -m // 9), draw.choice((0, draw.integer(m // 9, 2 * m)))
    A, B = ((side * (m * p - way * q) * scale, (m * q + way * p) * scale)[::turn] for way in ways[:: draw.choice((1, -1))])
    return 0, 0, m * (n * n + 1) * scale, A, B


def hair(draw):
    """A line of a few thousand beside a point, by 1e-7 to 4e-7 of that, and both a million times as far from the origin."""
    A, B, C = signs.beside_line((2**11,), 1, -1, 2, -2)(draw)
    unit = 2.0 ** -draw.integer(24, 90)
    x, y = (draw.integer(2**46, 2**52) * draw.sign() for _ in "xy")
    (cx, cy), A, B = (((x + u) * unit, (y + v) * unit) for u, v in (C, A, B))
    return cx, cy, 0, A, B


def beyond(draw):
    """C is a point on the line, far from A and B, which are beside the origin: A − C loses most of A's digits."""
    way = [draw.integer(1 << 19, 1 << 20) * draw.sign() for _ in "xy"]
    near, far, a, b = 2.0 ** -draw.integer(44, 53), *(draw.integer(1, 1 << 9) for _ in range(3))
    A, B, C = ((way[0] * times, way[1] * times) for times in (a * near, -b * near, far))
    return (*C, 0, *draw.choice(((A, B), (B, A))))


def solve(cx, cy, r, A, B):
    return Line.through(cx, cy, r, A, B).count()


def one_float(draw):
    """A level or upright line, mostly a touch, in ints but for one float: the place of C, A or B along it."""
    reach = draw.choice((99, 99, 2**20))
    cx, cy, r = draw.integer(-reach, reach), draw.integer(-reach, reach), draw.integer(1, reach)
    y = cy + (r + draw.choice((*5 * [0], draw.sign()))) * draw.sign()
    xs = [cx, draw.integer(-reach, reach), draw.integer(-reach, reach)]
    xs[draw.choice((0, 1, 1, 2, 2, 2, 2))] = draw.choice((draw.integer(-999, 999) / 10, *2 * [draw.integer(-(2**53), 2**53) / 2**46]))
    if xs[1] == xs[2]:
        draw.reject()
    turn = draw.choice((1, -1, -1))
    C, A, B = (place[::turn] for place in zip(xs, (cy, y, y), strict=True))
    return *C, r, A, B


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", grid("nnrpp", 3), cases=180, skills="distance against radius"),
    group("lines", "Lines that cut, touch and miss.", lines("cut ?by ?by", "touch ?by ?by", "miss ?by ?by", **PLAIN), skills="distance against radius"),
    group("tangent", "The line touches: one point.", lines(*TOUCHES, **PLAIN), skills="collapse the tangent"),
    group("decimals", "Touches in short decimals, which == does not see.", telling(lines(*TOUCHES, "touch after foot", **DECIMALS), *TELLING), skills="collapse the tangent"),
    group("axis-parallel", "Level and upright lines.", lines("cut ?by ?by", "touch ?by ?by", "miss ?by ?by", "dot ?by ?by", **AXIS), skills="no slopes"),
    group("off-segment", "The line crosses, the segment from A to B does not.", either(lines("cut after after", "cut before before", "cut in in", **PLAIN), *2 * [lines("through after after", "through before before", **BIG)]), cases=150, skills="a line has no ends"),
    group("from-centre", "A or B is the centre, or the foot of the perpendicular.", lines("through foot ?by", "cut foot ?by", "miss foot ?by", **PLAIN), skills="distance against radius"),
    group("radius-zero", "The circle is a point: on the line, or beside it.", lines("dot ?by ?by", "dot foot ?by", "dot-miss ?by ?by", **PLAIN), skills="r = 0"),
    group("same-point", "A equals B: there is no line.", either(*2 * [lines("cut before =", "cut in =", "touch foot =", "miss by =", "dot foot =", **PLAIN)], unsigned(grid("nnrpp", 3))), cases=75, skills="degenerate line"),
    group("random", "Any numbers, small and large.", either(*3 * [uniform("nnrpp", 20, 1e4, 1e9)], terse(uniform("nnrpp", 20))), cases=80, skills="distance against radius"),
]

PRODUCTION = [  # the same, where rounding bites
    group("turned", "A touch that squares cannot see.", lines(*TOUCHES, **BIG), skills="a tangent has a width"),
    group("full", "A touch that no formula in floats can see.", either(lines(*TOUCHES, **HUGE), lines(*TOUCHES, **SPLIT), lines("touch close after", "touch close foot", **HUGE)), skills="a tangent has a width"),
    group("near", "Nearly a touch: 1e-7 of the figure away.", lines("touch~ before after", "touch~ foot by", **CLEAR), skills="nearly is not touching"),
    group("near-dot", "The line passes the point by 1e-7 of the figure.", lines("dot~ before after", "dot~ foot by", **CLEAR), skills="nearly is not touching"),
    group("dot-full", "The circle is a point, on a line that floats put beside it.", either(lines("dot before after", "dot far by", "dot far foot", **SPLIT), tried(lines("dot before after", "dot far by", **{**HUGE, "turn": "axis"}), lambda case: beside(*case) < 0), beyond), cases=100, skills="r = 0"),
    group("tiny", "All of it tiny, down to 1e-29.", either(lines("touch before after", "touch~ before after", **TINY), lines("touch by ?by", "cut by ?by", **{**TINY, "turn": "axis"})), skills="no absolute epsilon"),
    group("offset", "A small figure far from the origin.", either(*3 * [lines(*TOUCHES, "touch before after", "cut before after", "miss before after", "dot-miss before after", "touch~ before after", "touch~ by foot", **OFFSET)], tried(hair), astray()), cases=100, skills="far from the origin"),
    group("far", "A or B is up to a hundred million radii away.", either(*2 * [lines("touch foot far", "touch foot very-far", "touch -far far", "touch~ foot far", **FAR), lines("through foot farther", "through farther by", **FAR), *2 * [lines("touch remote foot", "touch foot remote", "touch foot remote", **{**FAR, "size": 1 << 8, "turn": "any"})]], *[telling(pinpoint(close=close), *TELLING) for close in (True, False)]), cases=150, skills="the sharp discriminant"),
    group("steep", "Directions almost along an axis.", either(lines("cut before after", "miss before after", **ASKEW), *2 * [lines("touch before after", "cut before after", "miss before after", **STEEP), lines("cut before after", "miss before after", "cut in in", **TILTED)], *2 * [slivers("dot")], slivers("dot", "aside"), upright), cases=130, skills="no slopes"),
    group("small-parts", "A coordinate, a product or the short side of a triangle is tiny beside the others, and decides.", ratios(near=True), skills="nearly is not touching"),
    group("close-points", "A and B are close together, and still two points.", either(*4 * [closed_up("touch by", "cut by", "miss by", "through in")], *2 * [closed_up("touch by", "through in", turn="axis", close=(38, 46))], minute), cases=105, skills="degenerate line"),
    group("spread", "Tiny numbers beside large ones: fixed digits hold no more than some of them.", either(spread, mote, telling(partial(spread, far=-140), *TELLING)), cases=90, skills="degenerate line"),
    group("large", "Whole numbers up to 2**30, some of them touches.", either(whole("nnrpp", 30), lines(*TOUCHES, **{**BIG, "shift": 0, "numbers": "int"})), skills="whole numbers that are large"),
    group("one-float", "Level and upright lines in ints but for one float.", one_float, cases=55, skills="whole numbers that are large"),
    group("corners", "Whole numbers at the ends of the bounds: a difference leaves 32 bits, a sum of squares 64.", either(corners("nnrpp", 30), lambda draw: (0, 0, *corners("rpp", 30)(draw))), skills="whole numbers that are large"),
    group("repeated", "Neighbouring calls differ in one argument.", grid("nnrpp", 3), turns=True, skills="nothing kept between calls"),
]
