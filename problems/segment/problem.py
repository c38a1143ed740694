"""The points of a closed segment that lie on a circle, in order from A to B."""

from functools import partial
from math import copysign, hypot, sqrt

from judge.geometry import Line, plain
from judge.geometry.hooks import hooks
from judge.geometry.pose import triple
from judge.geometry.scenes import ASKEW, AXIS, BIG, DECIMALS, FAR, HUGE, LEANS, LEVEL, NEAR, OFFSET, PLAIN, SPLIT, STEEP, TILTED, TINY, astray, brim, closed_up, distant, either, grid, leaning, lines, merged, minute, mote, points, ratios, slivers, telling, terse, uniform, unsigned, whole, sloping
from judge.problem.declare import group

HOOKS = hooks("segment")
TOUCHES = ("touch before after", "touch foot after", "touch ?by ?near")
BEYOND = ("touch after after", "touch before before", "touch foot by")
ENDS = ("chord first in", "chord first after", "chord before first", "chord first last", "chord last after", "chord in last")
CLEAR = {**NEAR, "least": 7}
TELLING = plain.count, partial(plain.count, tolerance=1e-10)


def solve(cx, cy, r, A, B):
    line = Line.through(cx, cy, r, A, B)
    return [line.real_point(which) for which in line.within()]


def beside(draw):
    """An end is on the circle, and the other one straight beside the centre or above it, or nearly, or is close."""
    cx, cy, r, A = ON(draw)
    far = (r or 9) * draw.choice((2, *[2.0 ** -draw.integer(10, 30)] * 2, *[draw.integer(10**6, 4 * 10**6)] * 3)) * draw.sign()
    off = (r or 9) * draw.choice((0, 0, 0, draw.sign())) / 2 ** draw.integer(10, 30)
    B = (cx + far, cy + off) if draw.boolean() else (cx + off, cy + far)
    if draw.integer(0, 2) == 0:
        B = tuple(x + (r or 9) * draw.integer(10, 60) * draw.sign() / 10**8 for x in A)
    return (cx, cy, r, B, A) if draw.integer(0, 3) else (cx, cy, r, A, B)


def circle(draw):
    """A circle of 42 bits, moved by 50."""
    return *[draw.integer(-(2**50), 2**50) / 2**40 for _ in "xy"], draw.integer(2**38, 2**42) / 2**40


def radial(draw):
    """An end is on the circle, the other one straight above it or below, by 1e-7 of the radius: the way from the foot, as a part of AB, is off by 1e-9 or more."""
    cx, cy, r, A = points("on", **{**HUGE, "size": 2**30, "shift": -40})(draw)
    first = draw.boolean()
    for _ in range(400):
        times = 1 + draw.integer(10**6, 105 * 10**4) / 10**13 * draw.sign()
        B = cx + times * (A[0] - cx), cy + times * (A[1] - cy)
        case = cx, cy, r, *((A, B) if first else (B, A))
        if along(*case, slack=1e-9) != along(*case, slack=1e-7):
            return case
    return draw.reject()


def flat(draw):
    """Both ends on the circle, a thousandth of the radius apart: from the middle between them it is 1e-7 away."""
    n, k = draw.integer(700, 2200), 2.0 ** draw.integer(-30, 4)
    cx, cy = (draw.integer(-(2**20), 2**20) * k for _ in "xy")
    s, t, turn = draw.sign(), draw.sign(), draw.choice((1, -1))
    ends = [(s * x, t * y)[::turn] for x, y in ((n * n + 1, 0), (n * n - 1, 2 * n))]
    ends = [(cx + x * k, cy + y * k) for x, y in ends]
    return cx, cy, (n * n + 1) * k, *ends[:: draw.choice((1, -1))]


def quarter(draw):
    """One end beside the centre, the other one above or below it, both on the circle."""
    cx, cy, r = circle(draw)
    ends = (cx + r * draw.sign(), cy), (cx, cy + r * draw.sign())
    return cx, cy, r, *(ends if draw.boolean() else ends[::-1])


def lined(draw):
    """An end on the circle, straight beside the centre or above it; the other one nearly in the centre, or in line and far away."""
    cx, cy, r = circle(draw)
    far = r * draw.choice((*[2.0 ** -draw.integer(21, 34)] * 3, draw.integer(10**6, 2 * 10**7))) * draw.sign()
    off = r * draw.choice((0, 0, draw.sign())) / 2 ** draw.integer(21, 34)
    turn = draw.choice((1, -1))
    ends = [(cx + x, cy + y) for x, y in ((r * draw.sign(), 0)[::turn], (far, off)[::turn])]
    return cx, cy, r, *(ends[::-1] if draw.integer(0, 3) else ends)


def hardly_off(draw):
    """An end is hardly off the foot of the perpendicular, by 4e-9 to 1e-8 of how far the line passes the centre."""
    h, turn, scale = draw.integer(2**20, 2**21), draw.choice((1, -1)), 2.0 ** -draw.integer(-8, 60)
    ways = h * draw.integer(40, 95) / 10**10 * draw.sign(), h * draw.integer(60, 100) / 100 * draw.sign()
    side, at = draw.sign(), draw.choice((1, -1))
    return 0, 0, h * draw.integer(105, 115) / 100 * scale, *[(way * scale, h * side * scale)[::turn] for way in ways[::at]]


def inmost(draw):
    """From the circle to where nearly the centre is, by 1e-8 of the radius and less, or back."""
    cx, cy, r, A = points("on", **{**HUGE, "size": 2**26, "move": 30})(draw)
    step = r * 2.0 ** -draw.integer(32, 34)
    B = cx + draw.integer(-60, 60) * step, cy + draw.integer(-60, 60) * step
    return cx, cy, r, *((A, B) if draw.boolean() else (B, A))


def squares(cx, cy, r, A, _B):
    """Whether A is on the circle by its squares."""
    return (A[0] - cx) ** 2 + (A[1] - cy) ** 2 == r * r


def inwards(draw):
    """A line that comes to the centre of a circle of radius 0 almost along an axis."""
    cx, cy, far = circle(draw)
    x, y = (far * draw.sign(), far * draw.sign() / 2 ** draw.integer(22, 40))[:: draw.choice((1, -1))]
    return cx, cy, 0, (cx + x, cy + y), (cx, cy)


def rounded(draw):
    """A is B, on a circle on which no root of squares puts it."""
    p, q, c = triple(draw, 4_418)
    for _ in range(99):
        k = draw.integer(2**36, 2**38)
        x, y, r = (draw.sign() * p * k, q * k, c * k)
        if sqrt(float(x) ** 2 + float(y) ** 2) != r:
            cx, cy = (draw.integer(-(2**50), 2**50) for _ in "xy")
            A = (cx + x) / 2**22, (cy + y) / 2**22
            return cx / 2**22, cy / 2**22, r / 2**22, A, A
    return draw.reject()


def along(cx, cy, r, A, B, slack=0):
    """How many ends of the chord are between A and B, as ways from the foot by half of it."""
    fx, fy, dx, dy = A[0] - cx, A[1] - cy, B[0] - A[0], B[1] - A[1]
    way = hypot(dx, dy) or 1
    ux, uy, room = dx / way, dy / way, slack * way
    d, begin = abs(ux * fy - uy * fx), ux * fx + uy * fy
    half = sqrt(max(0, (r - d) * (r + d)))
    return sum(begin - room <= x <= begin + way + room for x in (-half, half))


def inside(cx, cy, r, A, B, slack=0):
    """How many roots of the quadratic are between A and B, and how many ways from the foot."""
    fx, fy, dx, dy = A[0] - cx, A[1] - cy, B[0] - A[0], B[1] - A[1]
    a, b, k = dx * dx + dy * dy or 1, fx * dx + fy * dy, dx * fy - dy * fx
    q = -(b + copysign(sqrt(max(0, r * r * a - k * k)), b))
    return sum(-slack <= t <= 1 + slack for t in (q / a, (fx * fx + fy * fy - r * r) / (q or 1))) + along(cx, cy, r, A, B, slack)


def brief(draw):
    """The shortest segments that cross: both ends are 1e-7 of the figure beside the circle, or hardly more."""
    p, q, c = triple(draw, 65)
    r = draw.integer(2**40, 2**41) * 2.0 ** -draw.integer(30, 60) * draw.sign()
    A, B = ((r * p * times / c, r * q * times / c) for times in (1 + draw.integer(1010, 1400) / 10**10 * side for side in (1, -1)))
    return 0, 0, abs(r), *((A, B) if draw.boolean() else (B, A))


def opposite(draw):
    """A and B are opposite corners of all that there is, and the circle is about the middle."""
    A = tuple(2**30 * draw.sign() for _ in "xy")
    B = tuple(-x for x in A)
    return draw.integer(-9, 9), draw.integer(-9, 9), draw.integer(2**20, 2**30), A, B


def always(*_case):
    """What a tolerance says of a point that is on it."""
    return True


ON = either(*[points("on", "on", "on", "dot-on", **{**HUGE, "size": 2**30, "turn": turn, "shift": -40}) for turn in ("any", "axis")])
FOOT = ("chord foot last", "chord first foot", "through foot last", "through first foot")
BESIDE = either(lines("chord foot last", **HUGE), lines(*FOOT, "through close last", **HUGE), lines(*FOOT, "chord in last", "chord first in", "chord first after", "through close last", **{**HUGE, "turn": "axis"}), *[lines("through farther last", "through farther first", **{**HUGE, "size": 2**14, "turn": "axis"})] * 2, *[lines("chord first after", "chord first in", **TILTED)] * 2, beside, beside, quarter)
POINT = either(lines("chord first =", "chord last =", **HUGE), lines("chord first =", "chord last =", **SPLIT))

INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", grid("nnrpp", 3), cases=180, skills="the small grid"),
    group("through", "Both ends outside, the circle between them: two points.", lines("cut before after", "through before after", **PLAIN), skills="order along the segment"),
    group("one-end-inside", "The segment enters the circle or leaves it: one point.", lines("cut before in", "cut in after", **PLAIN), skills="clamp to a segment"),
    group("both-ends-inside", "All of the segment is inside: no point.", lines("cut in in", **PLAIN), skills="clamp to a segment"),
    group("beyond", "The line cuts the circle before the segment starts, or after it ends.", lines("cut before before", "cut after after", **PLAIN), skills="clamp to a segment"),
    group("from-foot", "A is the foot of the perpendicular from C, so that f·D is 0.", lines("cut foot ?by", "through foot ?by", **PLAIN), skills="zero has no sign"),
    group("miss", "The line passes the circle: no point.", lines("miss ?by ?by", "miss foot ?by", **PLAIN), skills="no root of a negative number"),
    group("tangent", "The segment touches: one point, once.", lines(*TOUCHES, **PLAIN), skills="collapse the tangent"),
    group("tangent-beyond", "The line touches beyond the segment, or at one end.", lines(*BEYOND, **PLAIN), skills="clamp to a segment"),
    group("end-on-circle", "An end is on the circle, or both are.", either(lines(*ENDS, **PLAIN), lines("chord foot last", **PLAIN)), skills="closed ends"),
    group("one-point", "A equals B: on the circle, inside or outside.", lines("chord first =", "touch foot =", "cut in =", "miss by =", "dot foot =", **PLAIN), skills="degenerate segment"),
    group("radius-zero", "The circle is a point: on the segment, on its line only, or beside it.", lines("dot before after", "dot foot after", "dot after after", "dot-miss before after", **PLAIN), skills="r = 0"),
    group("axis", "Upright and level segments in every place.", lines("cut before after", "cut before in", "cut in after", "cut after after", "miss before after", **AXIS), skills="no slopes"),
    group("random", "Any numbers, small and large.", either(*3 * [uniform("nnrpp", 20, 1e4, 1e9)], terse(uniform("nnrpp", 20))), cases=80, skills="full precision"),
]

PRODUCTION = [  # the same, where rounding bites
    group("decimals", "Touches in short decimals, which == does not see.", telling(lines(*TOUCHES, "touch foot after", "touch after foot", **DECIMALS), *TELLING), cases=60, skills="collapse the tangent"),
    group("turned", "A touch that squares cannot see.", lines(*TOUCHES, *BEYOND, **BIG), skills="a tangent has a width"),
    group("full", "A touch that no formula in floats can see.", either(lines(*TOUCHES, **HUGE), lines(*TOUCHES, **SPLIT)), skills="a tangent has a width"),
    group("off-centre", "Segments past the centre by 1e-8 to 1e-1 of the radius, and chords that bend by 2e-6 to 2e-4 of it.", lines("off-centre before after", "off-centre before in", "off-centre in after", "flat before after", "flat before in", "flat in after", **HUGE), cases=120, skills="order along the segment"),
    group("near", "Nearly a touch: 1e-7 of the figure away.", lines("touch~ before after", "touch~ before after", "touch~ foot by", **CLEAR), skills="nearly is not touching"),
    group("end-full", "An end is on the circle, and rounding puts it beside.", either(lines(*ENDS, **HUGE), lines(*ENDS, **SPLIT), *[telling(BESIDE, inside, partial(inside, slack=1e-9))] * 3, radial, flat, inmost, *[telling(lined, each, partial(each, slack=1e-9)) for each in (inside, along, along)] * 2), cases=255, skills="closed ends"),
    group("end-near", "An end stops just before the circle, or goes on just past it.", either(*6 * [lines("chord first~ in", "chord first~ after", "chord before first~", "chord last~ after", "chord in last~", "through first~ in", "through in last~", "through before first~", "through last~ after", **CLEAR)], brief), cases=115, skills="ends no wider than rounding"),
    group("point", "A equals B: on the circle, or 1e-7 of the figure beside it.", either(telling(POINT, squares, always), rounded, lines("chord first =", "chord last =", **BIG), lines("chord first~ =", "chord last~ =", **CLEAR), unsigned(grid("nnrpp", 3))), cases=100, skills="degenerate segment"),
    group("dot-full", "The circle is a point, on a line that floats put beside it.", either(lines("dot before after", "dot foot after", **SPLIT), telling(inwards, along, partial(along, slack=1e-9))), cases=70, skills="r = 0"),
    group("dot-near", "The circle is a point, and the segment passes it by 1e-7 of the figure.", lines("dot~ before after", **CLEAR), cases=12, skills="r = 0"),
    group("tiny", "All of it tiny, down to 1e-29.", either(lines("touch before after", "touch~ before after", "chord first~ in", "chord in last~", "chord first~ =", "chord first~ =", "chord first =", "chord first =", **TINY), lines("touch before after", "cut before in", "cut before after", **{**TINY, "turn": "axis"})), cases=90, skills=("no absolute epsilon", "scale invariance")),
    group("offset", "A small figure far from the origin.", either(*4 * [lines(*TOUCHES, "cut before in", "cut in after", "dot-miss before after", "touch~ before after", "chord first~ in", "chord in last~", "chord last~ after", "chord before first~", "chord first~ =", **OFFSET)], astray(), lines("cut before after", "cut in after", **LEVEL), distant, brim), cases=160, skills="far from the origin"),
    group("far", "A or B is up to a hundred million radii away.", either(lines("touch foot far", "cut very-far foot", "cut -far far", "touch foot remote", "touch remote by", "touch -remote far", "touch~ far foot", **FAR), lines("touch far by", "touch -far far", **{**FAR, "size": 1 << 20, "turn": "any"}), lines("touch close far", "touch far close", **FAR), *[lines("touch remote foot", **{**FAR, "size": 1 << 8, "turn": "any"})] * 2), cases=90, skills="the sharp discriminant"),
    group("far-end", "One end is on the circle or just off it, the other is far away.", either(lines("chord first far", "chord far last", "chord first far", "chord far last", "chord last~ far", "chord far first~", **FAR), lines("chord first -very-far", "chord very-far last", **{**FAR, "size": 1 << 12, "turn": "any"})), cases=100, skills="ends no wider than rounding"),
    group("close-points", "A and B are close together, and still two points.", either(*4 * [closed_up("touch foot", "touch by", "cut by", "chord first", "through in")], minute, mote, closed_up("touch by", "through in", turn="axis", close=(38, 46))), cases=105, skills="degenerate segment"),
    group("steep", "Directions almost along an axis.", either(*2 * [lines("cut before after", "cut before in", "cut in after", **ASKEW)], lines(*TOUCHES, "cut before in", "miss before after", **STEEP), lines("cut before after", "cut before in", "cut in after", "miss before after", **TILTED), leaning(*LEANS), merged, *3 * [slivers("through", "aside", "across", "brink", "brink", "through")], hardly_off), cases=285, skills="no slopes"),
    group("small-parts", "A coordinate, a product or the short side of a triangle is tiny beside the others, and still counts.", either(ratios(), *2 * [ratios(short=True)]), cases=120, skills="order along the segment"),
    group("sloping", "Segments off an axis by 1e-4 to 1e-1, with an end just off the circle: 1e-7 to 1e-6 of the figure.", sloping(), cases=48, skills="no slopes"),
    group("large", "Whole numbers up to 2**30, some of them touches.", either(*2 * [whole("nnrpp", 30), lines(*TOUCHES, **{**BIG, "shift": 0, "numbers": "int"})], opposite), cases=75, skills=("whole numbers that are large", "scale invariance")),
    group("repeated", "Neighbouring calls differ in one argument.", grid("nnrpp", 4), cases=75, turns=True, skills="nothing kept between calls"),
]
