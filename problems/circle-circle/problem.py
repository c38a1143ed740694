"""The common points of two circles, the one left of C1→C2 first."""

from functools import partial
from math import cos, sin, sqrt

from judge.geometry import Pair, plain
from judge.geometry.hooks import hooks
from judge.geometry.pose import triple
from judge.geometry.scenes import ASKEW, AXIS, BIG, HUGE, NEAR, OFFSET, PLAIN, SPLIT, STEEP, TINY, aside, either, grid, leant, pairs, telling, terse, uniform, whole
from judge.geometry.scenes.bands import duo
from judge.problem.declare import group

HOOKS = hooks("pair")
LOW = {**PLAIN, "move": 0, "shift": (-20, -60)}
LEVEL = {**AXIS, "move": 0, "shift": (0, -30), "numbers": "float"}
TELLING = plain.lie, partial(plain.lie, tolerance=1e-10)


def solve(cx1, cy1, r1, cx2, cy2, r2):
    return Pair(cx1, cy1, r1, cx2, cy2, r2).points()


def halved(draw):
    """The common chord passes the centre of one of the circles by 5e-5 to 3e-2 of its radius: half of it is hardly less."""
    p, q, c = triple(draw, 65)
    r = draw.integer(2**39, 2**40) * 2.0 ** -draw.integer(12, 60)
    off = r * draw.choice((draw.integer(45, 160) / 10**6, draw.integer(45, 160) / 10**6, draw.integer(9, 30) / 1000)) * draw.sign()
    d = r * draw.integer(20, 120) / 100
    one, other = (0, 0, r), (d * p / c * draw.sign(), d * q / c * draw.sign(), sqrt(d * d + r * r - 2 * off * d))
    return (*one, *other) if draw.boolean() else (*other, *one)


def hair(draw):
    """A touch of two circles, one of them tiny. No double holds their distance, and at times none holds how far apart they are in x or y."""
    p, q, c = triple(draw, 65)
    low, high = draw.choice(((c, (2**53 - 1) // max(p, q)), (max(p, q), 2**54 // c)))
    k = draw.integer(2**53 // low + 2, high) | 1
    small, unit, turn = draw.integer(1 << 29, 9 * 10**8) | 1, 2.0 ** -draw.integer(25, 60), draw.choice((1, -1))
    ways = (p * k * draw.sign(), q * k * draw.sign())[::turn]
    starts = [draw.integer(-(2**40), 2**40) - way // 2 if max(map(abs, ways)) > 2**53 else 0 for way in ways]
    one = *(x * unit for x in starts), (c * k + small * draw.sign()) * unit
    other = *((x + way) * unit for x, way in zip(starts, ways, strict=True)), small * unit
    return (*one, *other) if draw.boolean() else (*other, *one)


def zeros(draw):
    """One centre, with a 0.0 that is −0.0 in the other circle."""
    zero, y, r, turn = draw.choice((0.0, -0.0)), draw.integer(-9, 9), draw.integer(0, 5), draw.choice((1, -1))
    return *(zero, y)[::turn], r, *(-zero, y)[::turn], draw.choice((r, draw.integer(0, 5)))


def speck(draw):
    """A circle 0.3 to 20 millionths as large as another one, which it cuts."""
    cx, cy, large = (draw.integer(2**50, 2**53) * draw.choice(signs) / 2**26 for signs in ((1, -1), (1, -1), (1,)))
    small = large * draw.choice((draw.integer(20, 200), draw.integer(3, 9))) / 1e7
    away, angle = large + small * draw.integer(-60, 60) / 100, draw.integer(0, 628)
    one, other = (cx, cy, large), (cx + away * cos(angle / 100), cy + away * sin(angle / 100), small)
    return *(one + other if draw.boolean() else other + one),


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", grid("nnrnnr", 3), cases=180, skills="the small grid"),
    group("crossing", "Two points, in every direction of C1→C2: the one on its left comes first.", either(pairs("cross", **PLAIN), pairs("cross", **AXIS)), skills=("cut two circles", "left and right of a line")),
    group("outer-touch", "They touch from outside: one point, once.", pairs("outer", **PLAIN), skills="two ways to touch"),
    group("inner-touch", "They touch, one inside the other, the first or the second: one point, once.", pairs("inner", **PLAIN), skills="two ways to touch"),
    group("apart", "They are apart: no point.", pairs("apart", **PLAIN), skills="cut two circles"),
    group("one-inside", "One is inside the other: no point.", pairs("within", "within", "ring", **PLAIN), skills="two ways to touch"),
    group("same-centre", "One centre: the same circle, or another radius.", either(*2 * [pairs("same", "ring", **PLAIN)], zeros), cases=75, skills="one centre"),
    group("dots", "A radius is 0, or both are.", pairs("dots", "dots", "dot-on", "dot-off", "dot-centre", "dot-centre", **PLAIN), cases=90, skills=("r = 0", "one centre")),
    group("random", "Any numbers, small and large.", either(*3 * [uniform("nnrnnr", 20, 1e4, 1e9)], terse(uniform("nnrnnr", 20))), cases=80, skills="full precision"),
]

PRODUCTION = [  # the same, where rounding bites
    group("turned", "Touches that squares cannot see.", pairs("outer", "inner", "dot-on", **BIG), skills="a tangent has a width"),
    group("full", "Touches that no formula in floats can see.", telling(either(pairs("outer", "inner", **HUGE), pairs("outer", "inner", **SPLIT)), *TELLING), skills="a tangent has a width"),
    group("halved", "The common chord passes the centre of a circle by 5e-5 to 3e-2 of its radius.", halved, skills="full precision"),
    group("near", "Nearly a touch: 1e-7 of the figure away.", either(pairs("outer~", "inner~", "dot-on~", **NEAR), pairs("outer~ slant", **{**NEAR, "turn": "axis"})), skills="nearly is not touching"),
    group("same-near", "One centre, and radii that are nearly the same.", pairs("same~", "same~", "same", **NEAR), skills="nearly is not touching"),
    group("small-beside-large", "Touches, exact and nearly, and one circle is 500 to ten million times larger.", either(pairs("outer~", "inner~", **{**NEAR, "uneven": 9}), pairs("inner", "outer", **{**NEAR, "uneven": 12, "move": 30}), pairs("inner", "inner", "inner", "outer", **{**NEAR, "uneven": 25, "move": 38}), *[pairs("inner", **{**PLAIN, "uneven": 24})] * 2, speck, speck, *2 * [pairs("outer", "inner", **{**HUGE, "size": 2**14, "uneven": 24})], hair, *4 * [telling(hair, *TELLING)]), cases=190, skills="nearly is not touching"),
    group("close-centres", "They touch from inside, and their centres are close together.", pairs("close", "close", "close~", **BIG), skills="a tangent has a width"),
    group("small-parts", "A part that is 1e-9 to 1e-1 of another one, and counts.", duo(22), skills="full precision"),
    group("tiny", "All of it tiny, down to 1e-29.", either(pairs("outer", "outer~", "inner", "inner~", "cross", "same~", "same", "same", **TINY), pairs("dots", "dot-off", "dot-on", "dot-centre", **TINY)), cases=80, skills=("no absolute epsilon", "scale invariance")),
    group("offset", "Small circles far from the origin.", either(pairs("outer", "inner", "inner", **OFFSET), pairs("cross", "apart", "ring", "dots", **OFFSET), pairs("outer~", "inner~", "same~", **OFFSET), aside(pairs("cross", **LOW))), cases=120, skills="far from the origin"),
    group("steep", "Centres almost beside or above one another.", either(pairs("cross", **ASKEW), *4 * [pairs("cross", "cross", "outer", **STEEP)], leant(pairs("cross", **AXIS))), cases=100, skills="no slopes"),
    group("nearly-level", "Centres beside or above one another but for 1e-20 to 1e-3 of their distance.", either(leant(pairs("cross", **LEVEL), range(3, 17)), *2 * [leant(pairs("cross", **LEVEL), range(17, 21))]), cases=60, skills="left and right of a line"),
    group("large", "Whole numbers up to 2**30, some of them touches.", either(whole("nnrnnr", 30), pairs("outer", "inner", "cross", **{**BIG, "shift": 0, "numbers": "int"})), skills=("whole numbers that are large", "scale invariance")),
    group("repeated", "Neighbouring calls differ in one argument.", grid("nnrnnr", 3), turns=True, skills="nothing kept between calls"),
]
