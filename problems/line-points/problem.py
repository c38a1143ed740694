"""The points of a circle on a line: exactly, in order of t along A + t·(B − A)."""

from functools import partial

from judge.geometry import Line, plain
from judge.geometry.hooks import hooks
from judge.geometry.pose import triple
from judge.geometry.scenes import ASKEW, AXIS, BIG, DECIMALS, FAR, HUGE, LEANS, LEVEL, NEAR, OFFSET, PLAIN, SPLIT, STEEP, TILTED, TINY, astray, brim, closed_up, distant, either, grid, leaning, lines, merged, minute, mote, past, pinpoint, ratios, slivers, telling, terse, uniform, unsigned, whole
from judge.problem.declare import group

HOOKS = hooks("points")
TOUCHES = ("touch before after", "touch foot after", "touch ?by ?near")
TELLING = plain.count, partial(plain.count, tolerance=1e-10)


def solve(cx, cy, r, A, B):
    return Line.through(cx, cy, r, A, B).points()


def any_way(draw):
    """A and B are close together, and the way from A to B has any direction: no foot is a double."""
    cx, cy, r, A, _ = lines("cut in after", "cut by after", **HUGE)(draw)
    step = r * 2.0 ** -draw.integer(30, 40)
    return cx, cy, r, A, tuple(x + step * draw.integer(-9, 9) for x in A)


def slid(cx, cy, _r, A, B, slack=0):
    """Whether two steps from A to the foot end in the centre."""
    (px, py), (dx, dy) = (A[0] - cx, A[1] - cy), (B[0] - A[0], B[1] - A[1])
    near = slack * max(abs(px), abs(py))
    for _ in range(2):
        t = -(px * dx + py * dy) / (dx * dx + dy * dy)
        px, py = px + t * dx, py + t * dy
    return max(abs(px), abs(py)) <= near


def breadth(draw):
    """A and B are a few doubles apart, where those are 1e-46 to 1e-41 apart, and C is near them."""
    unit, (i, j) = 2.0 ** -draw.integer(135, 151), draw.choice(((1, 0), (0, 1), (1, 1), (2, -1)))
    x, y = (draw.integer(2**52, 2**53 - 3) for _ in "xy")
    r, cx, cy = draw.integer(11, 48), *(draw.integer(16, 32) * draw.choice((0, 1)) for _ in "xy")
    cx, cy, r = (each * 2**48 * unit for each in (cx, cy, r))
    return cx, cy, r, (x * unit, (y + 1) * unit), ((x + i) * unit, (y + 1 + j) * unit)


def blurred(draw):
    """A touch in whole numbers that the distance by a unit vector puts off by 2e-16 of the size and more."""
    for _ in range(50):
        (p, q, c), power = triple(draw, 400), draw.integer(10, 20)
        times = 2**power // c + 1
        r, most = times * c, 2**power * 107 // 100
        ways = (times * q - most) // p + 1, (most - times * p) // q  # between them A and B are near
        if ways[0] >= ways[1]:
            continue
        a, b = draw.integer(*ways), draw.integer(*ways)
        A, B = ((k * p - times * q, k * q + times * p) for k in (a, b))
        size, d = max(r, *map(abs, A + B)), abs(p / c * A[1] - q / c * A[0])
        if a != b and abs(d - r) > 2.02e-16 * size:
            x, y = draw.sign(), draw.sign()
            return 0, 0, r, (A[0] * x, A[1] * y), (B[0] * x, B[1] * y)
    return draw.reject()


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", grid("nnrpp", 3), cases=180, skills="the small grid"),
    group("through", "Lines that cut the circle, upright and level ones too: two points, in order of t.", either(lines("cut ?by ?by", "through ?by ?by", **PLAIN), lines("cut ?by ?by", **AXIS)), skills=("foot and half-chord", "order along the line", "no slopes")),
    group("off-segment", "The points are not between A and B, or one of them is not.", lines("cut after after", "cut before before", "cut in in", "cut in after", "cut before in", **PLAIN), skills=("foot and half-chord", "a line has no ends")),
    group("touch", "The line touches: one point, once.", lines(*TOUCHES, **PLAIN), skills="collapse the tangent"),
    group("decimals", "Touches in short decimals, which == does not see.", telling(lines(*TOUCHES, "touch after foot", **DECIMALS), *TELLING), skills="collapse the tangent"),
    group("miss", "The line passes the circle: no point.", lines("miss ?by ?by", "miss foot ?by", **PLAIN), skills="no root of a negative number"),
    group("from-foot", "A is the foot of the perpendicular from C, so that f·D is 0.", lines("cut foot ?by", "through foot ?by", **PLAIN), skills="zero has no sign"),
    group("radius-zero", "The circle is a point: on the line, or beside it.", either(lines("dot ?by ?by", "dot foot ?by", "dot ?by foot", "dot-miss ?by ?by", **PLAIN), lines("dot foot ?by", "dot ?by foot", **AXIS)), skills="r = 0"),
    group("same-point", "A equals B: there is no line.", either(*2 * [lines("cut before =", "chord first =", "touch foot =", "miss by =", "dot foot =", **PLAIN)], unsigned(grid("nnrpp", 3))), cases=75, skills="degenerate line"),
    group("random", "Any numbers, small and large.", either(*3 * [uniform("nnrpp", 20, 1e4, 1e9)], terse(uniform("nnrpp", 20))), cases=80, skills="order along the line"),
]

PRODUCTION = [  # the same, where rounding bites
    group("turned", "A touch that squares cannot see.", lines(*TOUCHES, **BIG), skills="a tangent has a width"),
    group("full", "A touch that no formula in floats can see.", either(*2 * [lines(*TOUCHES, **HUGE), lines(*TOUCHES, **SPLIT), lines("touch close after", "touch close foot", **HUGE)], *4 * [blurred]), cases=72, skills="a tangent has a width"),
    group("near", "Nearly a touch: 1e-7 of the figure away.", either(lines("touch~ before after", "touch~ foot by", **NEAR), lines("touch~ before after", "touch~ by by", "dot~ before after", "dot~ foot by", **{**NEAR, "least": 7})), cases=120, skills="nearly is not touching"),
    group("dot-full", "The circle is a point, on a line that floats put beside it.", either(lines("dot before after", "dot foot after", **SPLIT), telling(lines("dot before after", "dot after by", **{**HUGE, "turn": "axis"}), slid, partial(slid, slack=1e-9))), skills="r = 0"),
    group("tiny", "All of it tiny, down to 1e-29, or around 1e-15 with all digits.", either(lines("touch before after", "touch~ before after", "cut before after", "dot-miss before after", **TINY), lines("cut before after", "cut ?by ?by", **{**HUGE, "shift": -99}), *[lines("cut before after", "cut by ?by", **{**PLAIN, "size": 9, "shift": -99})] * 2, lines("touch by ?by", "cut by ?by", "through by ?by", **{**TINY, "turn": "axis"})), cases=100, skills=("no absolute epsilon", "scale invariance")),
    group("offset", "A small figure far from the origin.", either(*3 * [lines(*TOUCHES, "cut before after", "miss before after", "dot-miss before after", "touch~ before after", "touch~ by foot", **OFFSET)], *3 * [lines("cut before after", "cut in after", "touch before foot", **LEVEL)], astray(), *2 * [distant], brim), cases=200, skills="far from the origin"),
    group("far", "A or B is up to a hundred million radii away.", either(lines("touch foot far", "cut very-far foot", "cut ?very-far by", "cut -far far", "touch remote foot", "touch -remote far", "touch~ foot far", "touch~ far foot", "dot far foot", "dot foot far", "through foot farther", "through farther by", **FAR), lines("touch remote foot", "touch remote by", **{**FAR, "size": 1 << 8, "turn": "any"}), lines("cut remote in", "cut remote by", "cut in remote", **{**FAR, "size": 1 << 8, "turn": "any"}), telling(pinpoint(), *TELLING)), cases=120, skills="the sharp discriminant"),
    group("off-centre", "Lines past the centre by 1e-8 to 1e-1 of the radius, and chords that bend by 2e-6 to 2e-4 of it.", either(*3 * [lines("off-centre ?by ?by", "off-centre in in", "off-centre in in", "flat in in", "flat foot by", **HUGE)], past), cases=100, skills="foot and half-chord"),
    group("close-points", "A and B are close together, and still two points.", either(*2 * [closed_up("touch by", "cut by", "miss by", "through in"), any_way], minute, mote, *2 * [closed_up("touch by", "through in", turn="axis", close=(38, 46))], breadth), cases=135, skills="degenerate line"),
    group("steep", "Directions almost along an axis.", either(lines("cut before after", "cut in in", "cut foot after", **ASKEW), lines("touch before after", "cut before after", "miss before after", **STEEP), lines("cut before after", "miss before after", "cut in in", **TILTED), leaning(*LEANS), merged, slivers("dot"), slivers("dot", "through", "aside", "across", "brink")), cases=205, skills="no slopes"),
    group("small-parts", "A coordinate, a product or the short side of a triangle is tiny beside the others, and still counts.", either(ratios(), *2 * [ratios(short=True)]), cases=120, skills="foot and half-chord"),
    group("large", "Whole numbers up to 2**30, some of them touches.", either(whole("nnrpp", 30), lines(*TOUCHES, **{**BIG, "shift": 0, "numbers": "int"})), skills=("whole numbers that are large", "scale invariance")),
    group("repeated", "Neighbouring calls differ in one argument.", grid("nnrpp", 3), turns=True, skills="nothing kept between calls"),
]
