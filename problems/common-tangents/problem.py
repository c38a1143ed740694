"""Where the common tangents of two circles touch the first one, the outer ones first."""

from functools import partial
from math import sqrt

from judge.geometry import Pair, plain
from judge.geometry.hooks import hooks
from judge.geometry.pose import triple
from judge.geometry.scenes import AXIS, BIG, HUGE, NEAR, OFFSET, PLAIN, SPLIT, TINY, aside, either, grid, leant, pairs, telling, terse, uniform, whole
from judge.geometry.scenes.bands import duo
from judge.problem.declare import group

HOOKS = hooks("common tangents")
LOW = {**PLAIN, "move": 0, "shift": (-20, -60)}
LEVEL = {**AXIS, "move": 0, "shift": (0, -30), "numbers": "float"}
TELLING = plain.lie, partial(plain.lie, tolerance=1e-10)


def solve(cx1, cy1, r1, cx2, cy2, r2):
    return Pair(cx1, cy1, r1, cx2, cy2, r2).tangents()


def nearest_centres(draw):
    """Circles of nearly one size that touch from inside or cross, whose centres are 1 to 1.1 thousandths of the size apart."""
    (p, q, c), k, scale = draw.choice(((1, 0, 1), triple(draw, 65))), draw.integer(2**20, 2**21), 2.0 ** -draw.integer(12, 80)
    large, touch = draw.choice((1000, draw.integer(990, 1000), draw.integer(910, 1000))) * c * k, draw.boolean()
    small = large - (c * k if touch else c * k * draw.integer(0, 95) // 100)
    if not touch and draw.boolean():  # the tangents lean by more than 1e-7, whatever the radii
        small = large * (1 - draw.integer(2, 9) / 10**10)
    x, y = (draw.integer(-(2**20), 2**20) for _ in "xy")
    place = (x + p * k * draw.sign(), y + q * k * draw.sign())
    turn, radii = draw.choice((1, -1)), [large * scale, small * scale]
    C, other = ((u * scale, v * scale)[::turn] for u, v in ((x, y), place))
    one, two = radii[:: draw.choice((1, -1))]
    return *C, one, *other, two


def apart_by_a_hair(draw):
    """A small circle is outside of a large one by little more than 1e-7 of the size: the inner tangents touch it in two places, about 1e-6 from each other."""
    size, turn, side = draw.integer(2**20, 2**24) * 2.0 ** -draw.choice((0, 20, 60)), draw.choice((1, -1)), draw.sign()
    small, gap = size * draw.integer(101, 108) / 10**5, size * draw.integer(102, 110) / 10**9
    place = side * size, size * draw.choice((0, 0, draw.integer(-9, 9) / 10))
    large = sqrt(place[0] ** 2 + place[1] ** 2) - small - gap
    one, two = (0, 0, small), (*place[::turn], large)
    return (*one, *two) if draw.integer(0, 3) else (*two, *one)


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", grid("nnrnnr", 3), cases=180, skills="the small grid"),
    group("apart", "They are apart, in every direction: four points, in their order.", either(pairs("apart", **PLAIN), pairs("apart", **PLAIN), pairs("apart", **AXIS), pairs("apart", **AXIS), leant(pairs("apart", **AXIS))), cases=75, skills=("common tangents", "left and right of a line")),
    group("outer-touch", "They touch from outside: both inner tangents are one, three points.", pairs("outer", **PLAIN), skills="two ways to touch"),
    group("crossing", "They cross: the outer tangents only.", pairs("cross", **PLAIN), skills="common tangents"),
    group("inner-touch", "They touch, one inside the other: one point, on the far side if the second is greater.", pairs("inner", **PLAIN), skills="two ways to touch"),
    group("inside", "One is inside the other: no common tangent.", pairs("within", **PLAIN), skills="common tangents"),
    group("equal", "Equal radii: the outer tangents run beside C1→C2 and meet nowhere.", pairs("equal", **PLAIN), skills="common tangents"),
    group("random", "Any numbers, small and large.", either(*3 * [uniform("nnrnnr", 20, 1e4, 1e9)], terse(uniform("nnrnnr", 20))), cases=80, skills="common tangents"),
]

PRODUCTION = [  # the same, where rounding bites
    group("turned", "Touches that squares cannot see.", pairs("outer", "inner", **BIG), skills="a tangent has a width"),
    group("full", "Touches that no formula in floats can see.", telling(either(pairs("outer", "inner", **HUGE), pairs("outer", "inner", **SPLIT)), *TELLING), skills="a tangent has a width"),
    group("near", "Nearly a touch: 1e-7 of the figure away.", either(pairs("outer~", "inner~", **NEAR), pairs("outer~ slant", **{**NEAR, "turn": "axis"}), *3 * [pairs("close~", **{**NEAR, "least": 7})], apart_by_a_hair), cases=180, skills="nearly is not touching"),
    group("alike", "Radii that differ by a thousandth to a ten billionth of themselves.", either(*[pairs("alike", **{**PLAIN, "size": size}) for size in (10**7, *2 * [2**36])]), cases=120, skills="common tangents"),
    group("close-centres", "They touch from inside, and their centres are close together.", pairs("close", "close", "close~", **BIG), skills="a tangent has a width"),
    group("small-parts", "A part that is 1e-9 to 1e-1 of another one, and counts.", duo(9, chords=False), skills="common tangents"),
    group("nearest-centres", "The distance of the centres is 1 to 1.1 thousandths of the size, as little as it may be.", nearest_centres, cases=36, skills="common tangents"),
    group("tiny", "All of it tiny, down to 1e-29.", pairs("outer", "outer~", "inner", "inner~", "cross", "apart", **TINY), skills=("no absolute epsilon", "scale invariance")),
    group("offset", "Small circles far from the origin.", either(*2 * [pairs("outer", "inner", "cross", "apart", "within", "outer~", "inner~", **OFFSET)], aside(pairs("cross", "apart", **LOW))), cases=90, skills="far from the origin"),
    group("large", "Whole numbers up to 2**30, some of them touches.", either(whole("nnrnnr", 30), pairs("outer", "inner", "cross", **{**BIG, "shift": 0, "numbers": "int"})), skills=("whole numbers that are large", "scale invariance")),
    group("nearly-level", "Centres beside or above one another but for 1e-20 to 1e-3 of their distance.", either(leant(pairs("cross", "apart", **LEVEL), range(3, 17)), *2 * [leant(pairs("cross", "apart", **LEVEL), range(17, 21))]), cases=40, skills="left and right of a line"),
    group("repeated", "Neighbouring calls differ in one argument.", grid("nnrnnr", 3), turns=True, skills="nothing kept between calls"),
]
