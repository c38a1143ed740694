"""The length of the chord that a circle cuts from a line: 2√Δ/|D|."""

from functools import partial

from judge.geometry import Line, plain
from judge.geometry.hooks import hooks
from judge.geometry.scenes import ASKEW, AXIS, BIG, DECIMALS, FAR, HUGE, LEANS, NEAR, OFFSET, PLAIN, SPLIT, STEEP, TILTED, TINY, astray, closed_up, corners, either, grid, leaning, lines, minute, mote, ratios, slivers, telling, terse, uniform, unsigned, whole
from judge.problem.declare import group

HOOKS = hooks("chord")
TOUCHES = ("touch before after", "touch foot after", "touch ?by ?near")
TELLING = plain.count, partial(plain.count, tolerance=1e-10)


def solve(cx, cy, r, A, B):
    return Line.through(cx, cy, r, A, B).chord()


def slant(draw):
    """A line through the centre of a circle that is ten million times smaller than the way to it, nearly along a diagonal."""
    x, y = (draw.integer(3 * 2**27, 2**29) * draw.sign() for _ in "xy")
    scale = 2.0 ** -draw.integer(0, 20)
    return 0, 0, max(abs(x), abs(y)) * draw.integer(1001, 1100) / 10**10 * scale, (-x * scale, -y * scale), (x * scale, y * scale)


def upright(draw):
    """A touch of a line that leaves an axis by a millionth, whose A often is where it touches."""
    n, m, *ways = draw.integer(10**6, 16 * 10**6), draw.integer(1, 30), draw.choice((0, draw.integer(-30, 30))), draw.integer(-30, 30)
    p, q, scale, turn, side = 2 * n, n * n - 1, 2.0 ** -draw.integer(25, 40), draw.choice((1, -1)), draw.sign()
    A, B = (((side * (m * q + way * p)) * scale, (way * q - m * p) * scale)[::turn] for way in ways)
    return 0, 0, m * (n * n + 1) * scale, A, B


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", grid("nnrpp", 3), cases=180, skills="distance against radius"),
    group("through", "Lines that cut the circle, upright and level ones too.", either(lines("cut ?by ?by", **PLAIN), lines("cut ?by ?by", **AXIS)), skills=("the half-chord", "no slopes")),
    group("diameter", "Lines through the centre: twice the radius.", lines("through ?by ?by", "through foot ?by", "through in in", **PLAIN), skills="the half-chord"),
    group("from-foot", "A or B is the foot of the perpendicular from C.", lines("cut foot ?by", "cut ?by foot", **PLAIN), skills="the half-chord"),
    group("touch", "The line touches: a chord of length 0.", lines(*TOUCHES, **PLAIN), skills="collapse the tangent"),
    group("decimals", "Touches in short decimals, which == does not see.", telling(lines(*TOUCHES, "touch after foot", **DECIMALS), *TELLING), skills="collapse the tangent"),
    group("miss", "The line passes the circle: no chord.", lines("miss ?by ?by", "miss foot ?by", **PLAIN), skills="no root of a negative number"),
    group("off-segment", "The chord is not on AB, or AB is a part of it.", either(lines("cut after after", "cut before before", "cut in in", **PLAIN), *2 * [lines("through after after", "through before before", **BIG)]), cases=150, skills="a line has no ends"),
    group("radius-zero", "The circle is a point: on the line, or beside it.", either(lines("dot ?by ?by", "dot foot ?by", "dot ?by foot", "dot-miss ?by ?by", **PLAIN), lines("dot foot ?by", "dot ?by foot", **AXIS)), skills="r = 0"),
    group("same-point", "A equals B: there is no line.", either(*2 * [lines("cut before =", "cut in =", "touch foot =", "miss by =", "dot foot =", **PLAIN)], unsigned(grid("nnrpp", 3))), cases=75, skills="degenerate line"),
    group("random", "Any numbers, small and large.", either(*3 * [uniform("nnrpp", 20, 1e4, 1e9)], terse(uniform("nnrpp", 20))), cases=80, skills="distance against radius"),
]

PRODUCTION = [  # the same, where rounding bites
    group("turned", "A touch that squares cannot see.", lines(*TOUCHES, **BIG), skills="a tangent has a width"),
    group("full", "A touch that no formula in floats can see.", either(lines(*TOUCHES, **HUGE), lines(*TOUCHES, **SPLIT), lines("touch close after", "touch close foot", **HUGE), telling(lines("dot before after", "dot by far", "dot by far", **SPLIT), *TELLING), telling(lines("touch close foot", "touch foot close", "touch close close", size=2**50, turn="axis", shift=-22), *TELLING)), cases=150, skills="a tangent has a width"),
    group("off-centre", "Lines past the centre by 1e-8 to 1e-1 of the radius, and chords that bend by 2e-6 to 2e-4 of it.", lines("off-centre in in", "off-centre ?by ?by", "off-centre foot by", "flat in in", "flat foot by", **HUGE), cases=90, skills="the half-chord"),
    group("near", "Nearly a touch: 1e-7 of the figure away.", either(lines("touch~ before after", "touch~ foot by", **NEAR), lines("touch~ before after", "touch~ by by", "dot~ before after", "dot~ foot by", **{**NEAR, "least": 7}), slant), cases=160, skills="nearly is not touching"),
    group("tiny", "All of it tiny, down to 1e-29.", either(lines("touch before after", "touch~ before after", "cut before after", **TINY), lines("touch by ?by", "cut by ?by", **{**TINY, "turn": "axis"})), skills=("no absolute epsilon", "scale invariance")),
    group("offset", "A small figure far from the origin.", either(*3 * [lines("touch before after", "cut before after", "miss before after", "dot-miss before after", "touch~ before after", "touch~ by foot", **OFFSET)], astray()), cases=80, skills="far from the origin"),
    group("far", "A or B is up to ten million radii away.", either(lines("touch foot far", "cut foot very-far", "cut -far far", "touch~ foot far", "dot far foot", "dot foot far", "through foot farther", "through farther by", **FAR), lines("touch foot remote", "touch remote foot", **{**FAR, "size": 1 << 8, "turn": "any"})), skills="the sharp discriminant"),
    group("long", "A and B are close together, and still two points.", either(*4 * [closed_up("touch by", "cut by", "miss by", "through in")], minute, mote, closed_up("touch by", "through in", turn="axis", close=(38, 46))), cases=105, skills="degenerate line"),
    group("steep", "Directions almost along an axis.", either(lines("cut before after", "cut in in", "cut foot after", **ASKEW), lines("touch before after", "cut before after", "miss before after", **STEEP), lines("cut before after", "miss before after", "cut in in", **TILTED), *2 * [telling(upright, *TELLING)], leaning(*LEANS), *3 * [slivers("dot")], slivers("dot", "aside", "across")), cases=250, skills="no slopes"),
    group("small-parts", "A coordinate, a product or the short side of a triangle is tiny beside the others, and still counts.", either(ratios(), *2 * [ratios(short=True)]), cases=120, skills="the half-chord"),
    group("large", "Whole numbers up to 2**30, some of them touches.", either(whole("nnrpp", 30), lines(*TOUCHES, **{**BIG, "shift": 0, "numbers": "int"})), skills=("whole numbers that are large", "scale invariance")),
    group("corners", "Whole numbers at the ends of the bounds: a difference leaves 32 bits, a sum of squares 64.", either(corners("nnrpp", 30), lambda draw: (0, 0, *corners("rpp", 30)(draw))), skills="whole numbers that are large"),
    group("repeated", "Neighbouring calls differ in one argument.", grid("nnrpp", 3), turns=True, skills="nothing kept between calls"),
]
