"""Inside, on or outside a circle: the exact sign of |P − C| − r."""

from math import frexp, sqrt

from judge.geometry import Line
from judge.geometry.hooks import hooks
from judge.geometry.scenes import AXIS, BIG, HUGE, NEAR, OFFSET, PLAIN, SPLIT, TINY, corners, either, grid, points, tried, uniform, whole, doubles
from judge.problem.declare import group

HOOKS = hooks("point")
CLEAR = {**NEAR, "least": 7}


def solve(cx, cy, r, P):
    return Line.point(cx, cy, r, P).side()


def small_circle(draw):
    """P at the corner that is opposite to a small circle's, mostly."""
    cx, cy, P = corners("nnp", 30)(draw)
    return cx, cy, draw.choice((0, draw.integer(1, 9))), P if draw.boolean() else (-cx, -cy)


def halfway(draw):
    """On a circle whose radius has a square halfway between two doubles."""
    cx, cy = (draw.integer(-(2**29), 2**29) for _ in "xy")
    r = 4 * draw.integer(47453133, 67108863) + 2
    P = (cx + r * draw.sign(), cy) if draw.boolean() else (cx, cy + r * draw.sign())
    return cx, cy, r, P


def speck(draw):
    """On a circle of 1e-26, in numbers of 53 bits: their squares have 220 digits."""
    *C, r, P = points("on", **{**HUGE, "move": 0, "shift": 0})(draw)
    small = 2.0 ** -(87 + frexp(r)[1])
    return *C, r * small, tuple(x * small for x in P)


def off_root(case):
    """Whether the root of the squares is not r."""
    cx, cy, r, P = case
    return sqrt(float(P[0] - cx) ** 2 + float(P[1] - cy) ** 2) != r


def beside(draw):
    """The circle is a point, and P is less than 1e-30 away from it: on a diagonal, an axis or anyhow."""
    i, j = draw.choice(((1, 0), (0, 1), (1, 1), (1, -1), (draw.integer(1, 9), draw.integer(-9, 9))))
    times, x, y = draw.integer(1, 30) * draw.sign(), draw.integer(1000, 1600), draw.integer(1000, 1600)
    return x * 2.0**-109, y * 2.0**-109, 0, ((x + i * times) * 2.0**-109, (y + j * times) * 2.0**-109)


def distant(draw):
    """P is nearly on a circle that is 2e7 to 2e9 times as far from the origin as it is large, in 53 bits."""
    unit, x = 2.0 ** -draw.integer(24, 90), draw.integer(2**51, 2**53 - 2**28)
    size = draw.integer(2**22, 2**23) << draw.choice((0, 0, 0, 4))
    gap = size * draw.integer(102, 190) / 10**9 * draw.choice((1, -1, 2))
    if draw.boolean():  # beside C along the large coordinate, or across it
        r, P = size + gap, (x + size * draw.sign(), 0.0)
    else:
        r, P = size, (x, (size + gap) * draw.sign())
    turn, side = draw.choice((1, 1, -1)), unit * draw.sign()
    return *(x * side, 0.0)[::turn], r * unit, (P[0] * side, P[1] * unit)[::turn]


def doubles_apart(draw):
    """The circle is a point, and P is a few doubles beside it; most figures are below 1e-22."""
    unit = 2.0 ** -draw.choice((draw.integer(24, 151), draw.integer(127, 151)))
    i, j = draw.choice(((1, 0), (1, 0), (0, 1), (1, 1), (1, -1)))
    times, (x, y) = draw.integer(1, 9), (draw.integer(2**52 + 9, 2**53 - 9) for _ in "xy")
    if draw.boolean():
        C, P = (x, 0), (x + times, 0)
    else:
        C, P = (x, y), (x + i * times, y + j * times)
    turn, side = draw.choice((1, -1)), unit * draw.sign()
    return *(each * side for each in C[::turn]), 0, tuple(each * side for each in P[::turn])


def hardly(draw):
    """P is nearly on the circle and hardly beside an axis or a diagonal through C, and that decides; or a coordinate of C or P decides that is tiny beside the other one."""
    small, long = draw.integer(25, 95) * draw.sign() / 10**8, draw.integer(103, 115) / 10**9
    kind = draw.choice(("leg", "leg", "series", "diagonal", "C", "C", "P", "P"))
    x, y = 1.0, draw.integer(1, 9) / 16 * draw.sign()
    if kind in ("leg", "series"):  # √(1 + y²) is 1 + y²/2 − y⁴/8 …
        y = draw.integer(*{"leg": (520, 1000), "series": (32_000, 45_000)}[kind]) / 10**6 * draw.sign()
    elif kind == "diagonal":
        y = (1 + small) * draw.sign()
    cx, cy = {"C": (small, 0.0), "P": (small - x, 0.0)}.get(kind, (0.0, 0.0))
    d, size = sqrt(x * x + y * y), max(abs(x), abs(y))
    without = {"leg": 1.0, "series": 1 + y * y / 2, "diagonal": size * sqrt(2)}.get(kind, sqrt((x + small * (1 if kind == "C" else -1)) ** 2 + y * y))
    r = d + max(size, d) * long * (1 if without > d else -1)
    turn, side, scale = draw.choice((1, -1)), draw.sign(), 2.0 ** draw.integer(-40, 20)
    C, P = ((u * scale * side + 0.0, v * scale)[::turn] for u, v in ((cx, cy), (cx + x, cy + y)))
    return *C, r * scale, P


def slender(draw):
    """On the circle right above the centre or beside it, but for 3e-8 to 6e-8 of the radius: what is left of r² has few digits."""
    m, turn, scale = draw.integer(2**25, 2**26), draw.choice((1, -1)), 2.0 ** -draw.integer(23, 90)
    x, y = (m * m - 1) * draw.sign(), 2 * m * draw.sign()
    C, P = draw.choice((((0, 0), (x, y)), ((-x, -y), (0, 0))))
    return *(n * scale for n in C[::turn]), (m * m + 1) * scale, tuple(n * scale for n in P[::turn])


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", grid("nnrp", 4), cases=180, skills="inside, on or outside"),
    group("inside", "Points inside, and the centre itself.", points("in", "in", "centre", **PLAIN), skills="inside, on or outside"),
    group("outside", "Points outside, near and far.", points("out", "out", "far", **PLAIN), skills="inside, on or outside"),
    group("on", "Points on the circle by Pythagoras, in small numbers.", either(points("on", **PLAIN), points("on", **AXIS)), skills="inside, on or outside"),
    group("radius-zero", "The circle is a point: P is the centre, or it is not.", points("dot-on", "dot-out", **PLAIN), skills="r = 0"),
    group("random", "Any numbers, small and large.", uniform("nnrp", 20, 1e4, 1e9), skills="inside, on or outside"),
]

PRODUCTION = [  # the same, where rounding bites
    group("on-turned", "On the circle, where squares are rounded.", either(*3 * [points("on", **BIG)], tried(points("on", **{**HUGE, "size": 2**44, "move": 52}), off_root, 200)), cases=80, skills="on the circle has a width"),
    group("on-full", "On the circle, where differences are rounded, too.", either(points("on", **HUGE), points("on", **SPLIT)), skills="on the circle has a width"),
    group("near", "Nearly on the circle: 1e-7 of the figure away.", points("on~", "on~", "dot-on~", **CLEAR), skills="nearly is not on it"),
    group("small-parts", "Nearly on the circle or on it, and what is tiny beside the rest decides: a coordinate, or the short side of a triangle.", either(*2 * [hardly], slender), cases=90, skills="nearly is not on it"),
    group("tiny", "All of it tiny, down to 1e-29.", either(*2 * [points("on", "on~", "in", "dot-on~", **TINY), speck], beside), cases=75, skills=("no absolute epsilon", "scale invariance")),
    group("offset", "A small figure far from the origin.", either(*3 * [points("on", "on", "in", "out", "dot-out", "dot-on", **OFFSET)], points("on", **{**HUGE, "size": 2**32, "move": 52})), cases=80, skills="far from the origin"),
    group("offset-near", "Small figures far from the origin, nearly on the circle.", either(*3 * [points("on~", **{**NEAR, "move": 47, "shift": -20})], distant), cases=80, skills="far from the origin"),
    group("odd-steps", "P on the circle far from the origin, an odd number of the last digits away: half of the way is no double.", doubles.odd_steps, cases=12, skills="far from the origin"),
    group("dot-split", "The circle is a point, and P is this point in its last bits.", either(*5 * [points("dot-on~", "dot-out", "dot-on", **{**NEAR, "move": "split"})], doubles_apart), cases=80, skills="no absolute epsilon"),
    group("large", "Whole numbers up to 2**30, some of them on the circle.", either(whole("nnrp", 30), points("on", **{**BIG, "shift": 0, "numbers": "int"}), halfway), skills=("whole numbers that are large", "scale invariance")),
    group("corners", "Whole numbers at the ends of the bounds: a difference leaves 32 bits, a sum of squares 64.", either(corners("nnrp", 30), small_circle), skills="whole numbers that are large"),
    group("repeated", "Neighbouring calls differ in one argument.", grid("nnrp", 4), turns=True, skills="nothing kept between calls"),
]
