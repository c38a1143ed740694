"""The points of a circle on a line: exactly, in order of t along A + t·(B − A)."""

from functools import partial

from judge.geometry import Line, plain
from judge.geometry.hooks import hooks
from judge.geometry.scenes import AXIS, BIG, DECIMALS, FAR, HUGE, NEAR, OFFSET, PLAIN, SPLIT, STEEP, TILTED, TINY, LEANS, astray, closed_up, either, grid, leaning, lines, merged, minute, mote, past, pinpoint, slivers, telling, terse, uniform, unsigned, whole
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
    group("full", "A touch that no formula in floats can see.", either(lines(*TOUCHES, **HUGE), lines(*TOUCHES, **SPLIT), lines("touch close after", "touch close foot", **HUGE)), skills="a tangent has a width"),
    group("near", "Nearly a touch: 1e-7 of the figure away.", either(lines("touch~ before after", "touch~ foot by", **NEAR), lines("touch~ before after", "touch~ by by", "dot~ before after", "dot~ foot by", **{**NEAR, "least": 7})), cases=120, skills="nearly is not touching"),
    group("dot-full", "The circle is a point, on a line that floats put beside it.", either(lines("dot before after", "dot foot after", **SPLIT), telling(lines("dot before after", "dot after by", **{**HUGE, "turn": "axis"}), slid, partial(slid, slack=1e-9))), skills="r = 0"),
    group("tiny", "All of it tiny, down to 1e-29, or around 1e-15 with all digits.", either(lines("touch before after", "touch~ before after", "cut before after", "dot-miss before after", **TINY), lines("cut before after", "cut ?by ?by", **{**HUGE, "shift": -99}), *[lines("cut before after", "cut by ?by", **{**PLAIN, "size": 9, "shift": -99})] * 2, lines("touch by ?by", "cut by ?by", "through by ?by", **{**TINY, "turn": "axis"})), cases=100, skills=("no absolute epsilon", "scale invariance")),
    group("offset", "A small figure far from the origin.", either(*3 * [lines(*TOUCHES, "cut before after", "miss before after", "dot-miss before after", "touch~ before after", "touch~ by foot", **OFFSET)], astray()), cases=80, skills="far from the origin"),
    group("far", "A or B is up to a hundred million radii away.", either(lines("touch foot far", "cut very-far foot", "cut ?very-far by", "cut -far far", "touch remote foot", "touch -remote far", "touch~ foot far", "touch~ far foot", "dot far foot", "dot foot far", "through foot farther", "through farther by", **FAR), lines("touch remote foot", "touch remote by", **{**FAR, "size": 1 << 8, "turn": "any"}), lines("cut remote in", "cut remote by", "cut in remote", **{**FAR, "size": 1 << 8, "turn": "any"}), telling(pinpoint(), *TELLING)), cases=120, skills="the sharp discriminant"),
    group("off-centre", "Lines past the centre by 1e-8 to 1e-2 of the radius.", either(*3 * [lines("off-centre ?by ?by", **HUGE)], past), cases=80, skills="foot and half-chord"),
    group("close-points", "A and B are close together, and still two points.", either(*2 * [closed_up("touch by", "cut by", "miss by", "through in"), any_way], minute, mote, *2 * [closed_up("touch by", "through in", turn="axis", close=(38, 46))]), cases=120, skills="degenerate line"),
    group("steep", "Directions almost along an axis.", either(lines("touch before after", "cut before after", "miss before after", **STEEP), lines("cut before after", "miss before after", "cut in in", **TILTED), leaning(*LEANS), merged, slivers("dot"), slivers("dot", "through", "aside", "across", "brink")), cases=180, skills="no slopes"),
    group("large", "Whole numbers up to 2**30, some of them touches.", either(whole("nnrpp", 30), lines(*TOUCHES, **{**BIG, "shift": 0, "numbers": "int"})), skills=("whole numbers that are large", "scale invariance")),
    group("repeated", "Neighbouring calls differ in one argument.", grid("nnrpp", 3), turns=True, skills="nothing kept between calls"),
]
