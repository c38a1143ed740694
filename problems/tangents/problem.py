"""Where the tangents through a point touch a circle, the point left of P→C first."""

from judge.geometry import Line
from judge.geometry.hooks import hooks
from judge.geometry.pose import triple
from judge.geometry.scenes import AXIS, BIG, FAR, HUGE, NEAR, OFFSET, PLAIN, SPLIT, STEEP, TILTED, TINY, aside, doubles, either, grid, points, terse, uniform, whole
from judge.geometry.scenes.bands import outside
from judge.problem.declare import group

HOOKS = hooks("tangents")
LOW = {**PLAIN, "move": 0, "shift": (-20, -60)}


def solve(cx, cy, r, P):
    return Line.point(cx, cy, r, P).tangents()


def half_way(draw):
    """Whole numbers, P on the circle, and r² half-way between two floats: r is odd, and r² between 2**53 and 2**54."""
    p, q, c = draw.choice(((1, 0, 1), triple(draw, 65)))
    times = draw.integer(94_906_266 // c + 1, 2**27 // c - 1) | 1
    x, y = draw.choice(((p, q), (q, p)))
    cx, cy = (draw.integer(-(2**29), 2**29) for _ in range(2))
    return cx, cy, c * times, (cx + x * times * draw.sign(), cy + y * times * draw.sign())


def leaning(draw):
    """P is almost straight beside or above C, by 1.5 to 30 parts in 1e9, and not far."""
    r, cx, cy = draw.integer(2**20, 2**21), draw.integer(-9, 9), draw.integer(-9, 9)
    far = r + draw.integer(r // 8, r // 3)
    off = far * draw.integer(15, 30) * draw.choice((1, 1, 10)) * 1e-10 * draw.sign()
    x, y = draw.choice(((far * draw.sign(), off), (off, far * draw.sign())))
    return cx, cy, r, (cx + x, cy + y)


def edge(draw):
    """One of the tangents is almost upright or level, by 1e-12 to 1e-9 of the radius."""
    r, cx, cy = draw.integer(2**20, 2**21), draw.integer(-9, 9), draw.integer(-9, 9)
    along = (r + r * 2.0 ** -draw.integer(30, 39)) * draw.sign()
    x, y = draw.choice(((along, r * draw.integer(3, 30) / 10 * draw.sign()), (r * draw.integer(3, 30) / 10 * draw.sign(), along)))
    return cx, cy, r, (cx + x, cy + y)


def farthest(draw):
    """P is 10,000 radii away along an axis, as far as it may be, and C is at the origin."""
    r, turn = draw.integer(1, 2**30 // 10**4) * 2.0 ** draw.choice((0, -20, -60)), draw.choice((1, -1))
    return 0, 0, r, (r * 10**4 * draw.sign(), draw.choice((0, draw.integer(-(10**4), 10**4))) * r)[::turn]


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", grid("nnrp", 3), cases=180, skills="the small grid"),
    group("outside", "P outside, in every direction: two points.", either(*2 * [points("out", **PLAIN)], points("out", **{**TILTED, "move": 0, "tilt": (50, 75)}), edge), cases=80, skills="tangents from a point"),
    group("order", "P straight beside, above or below the circle: the point left of P→C comes first.", points("out", **AXIS), skills="left and right of a line"),
    group("on", "P on the circle: it touches itself, once.", either(points("on", **PLAIN), points("on", **AXIS)), skills="inside, on or outside"),
    group("inside", "P inside the circle, or its centre: no tangent, and no root of a negative number.", points("in", "in", "centre", **PLAIN), skills="inside, on or outside"),
    group("radius-zero", "The circle is the point C, and that is where every line touches it.", points("dot-on", "dot-out", **PLAIN), skills="r = 0"),
    group("beside", "P almost straight beside the centre or above it.", either(*2 * [points("out", **STEEP)], leaning), cases=90, skills="no slopes"),
    group("random", "Any numbers, small and large.", either(*3 * [uniform("nnrp", 20, 1e4, 1e9)], terse(uniform("nnrp", 20))), cases=80, skills="full precision"),
]

PRODUCTION = [  # the same, where rounding bites
    group("on-turned", "On the circle, where squares are rounded.", points("on", **BIG), skills="on the circle has a width"),
    group("on-full", "On the circle, where differences are rounded, too.", either(points("on", **HUGE), points("on", **SPLIT)), skills="on the circle has a width"),
    group("near", "Nearly on the circle: 1e-7 of the figure away.", points("on~", **NEAR), skills="nearly is not on it"),
    group("close", "P outside, by a quarter to a millionth of the radius: both points are close together.", either(points("close", **BIG), points("close", **{**BIG, "turn": "axis"})), skills="full precision"),
    group("far", "P a hundred to ten thousand radii away.", either(*4 * [points("far", **FAR)], farthest), cases=75, skills="tangents from a point"),
    group("small-parts", "A part that is 1e-9 to 1e-1 of another one, and counts.", outside, skills="full precision"),
    group("tiny", "All of it tiny, down to 1e-29.", points("on", "on~", "in", "out", **TINY), skills=("no absolute epsilon", "scale invariance")),
    group("offset", "A small figure far from the origin.", either(*2 * [points("on", "in", "out", "out", "on~", **OFFSET)], aside(points("out", **LOW))), cases=90, skills="far from the origin"),
    group("odd-steps", "P on the circle far from the origin, an odd number of the last digits away: half of the way is no double.", doubles.odd_steps, cases=20, skills="far from the origin"),
    group("large", "Whole numbers up to 2**30, many of them on the circle.", either(whole("nnrp", 30), points("on", **{**BIG, "shift": 0, "numbers": "int"}), half_way), cases=80, skills=("whole numbers that are large", "scale invariance")),
    group("repeated", "Neighbouring calls differ in one argument.", grid("nnrp", 3), turns=True, skills="nothing kept between calls"),
]
