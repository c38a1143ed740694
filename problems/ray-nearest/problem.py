"""The parameter of the first common point of a ray and a circle: the least t ≥ 0, exactly."""

from functools import partial

from judge.geometry import Line, plain
from judge.geometry.hooks import hooks
from judge.geometry.scenes import ASKEW, AXIS, BIG, DECIMALS, FAR, HUGE, LEANS, NEAR, OFFSET, PLAIN, SPLIT, STEEP, TILTED, TINY, abreast, aimed, astray, either, enlarged, faint, grid, leaning, rays, skimming, still, telling, uniform, whole, sloping
from judge.geometry.scenes.bands import ray
from judge.problem.declare import group

HOOKS = hooks("ray")
TOUCHES = ("touch before", "touch before", "touch near", "touch after")
ON_CIRCLE = ("chord first", "chord last", "chord first anyway", "touch foot")
STRETCHED = {**PLAIN, "shift": (-17, -60), "stretch": tuple(range(-39, 90, 8))}
TELLING = plain.first_hit, partial(plain.first_hit, tolerance=1e-10)
BY_POWER = partial(plain.first_hit, power=True), partial(plain.first_hit, power=True, tolerance=1e-10)
CLEAR = {**NEAR, "least": 7}


def solve(cx, cy, r, O, D):
    ray = Line.ray(cx, cy, r, O, D)
    which = ray.first()
    return None if which is None else ray.time(which)


def slant(draw):
    """The ray goes through the centre of a circle that is ten million times smaller than the way to it, nearly along a diagonal."""
    x, y = (draw.integer(3 * 2**27, 2**29) * draw.sign() for _ in "xy")
    scale = 2.0 ** -draw.integer(0, 20)
    return 0, 0, max(abs(x), abs(y)) * draw.integer(1001, 1100) / 10**10 * scale, (-x * scale, -y * scale), (x * scale, y * scale)


def level(draw):
    """Level or upright, and it meets or passes a tiny circle, by 2e-7 to 8e-7 of the way to it."""
    way, turn = draw.integer(2**40, 2**41) * 2.0 ** -draw.integer(11, 60), draw.choice((1, -1))
    off, gap = (way * draw.integer(20, 90) / 10**8 for _ in "12")
    O, D = (way * draw.sign(), off * draw.sign()), (draw.integer(1, 9) * draw.sign(), 0)
    return 0, 0, max(0, off + gap * draw.sign()), O[::turn], D[::turn]


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", either(*9 * [grid("nnrpd", 3)], still(grid("nnrpd", 3))), cases=222, skills="the small grid"),
    group("ahead", "The circle is ahead of the origin: the nearer of two points.", rays("cut before", "through before", **PLAIN), skills="clamp to a ray"),
    group("inside", "The origin is inside the circle: where the ray leaves.", rays("cut in", "through foot", "cut in anyway", **PLAIN), skills="origin inside"),
    group("behind", "The line meets the circle, but behind the origin.", rays("cut after", "touch after", "through after", **PLAIN), skills="clamp to a ray"),
    group("miss", "The line passes the circle.", rays("miss ?by", "miss foot", **PLAIN), skills="no root of a negative number"),
    group("from-foot", "The origin is the foot of the perpendicular from C, so that f·D is 0.", rays("cut foot", "through foot", **PLAIN), skills="zero has no sign"),
    group("tangent", "The ray touches: ahead, behind, or at its origin.", rays("touch before", "touch near", "touch after", "touch foot", **PLAIN), skills="collapse the tangent"),
    group("on-circle", "The origin is on the circle, and the ray looks in or out: t = 0.", rays(*ON_CIRCLE, **PLAIN), skills="origin on the circle"),
    group("no-ray", "D = (0, 0): there is no ray, wherever the origin is.", lambda draw: (*rays("chord first", "cut in", "cut before", "dot foot", **PLAIN)(draw)[:4], (0, 0.0)), skills="degenerate line"),
    group("radius-zero", "The circle is a point: ahead, behind, off the ray, or the origin itself.", rays("dot before", "dot after", "dot foot", "dot-miss before", **PLAIN), skills="r = 0"),
    group("axis", "Upright and level rays in every place.", rays("cut before", "cut in", "cut after", "miss before", **AXIS), skills="no slopes"),
    group("random", "Any numbers, small and large.", uniform("nnrpd", 20, 1e4, 1e9), skills="full precision"),
]

PRODUCTION = [  # the same, where rounding bites
    group("decimals", "Touches in short decimals, which == does not see.", telling(rays(*TOUCHES, "touch foot", **DECIMALS), *TELLING), skills="collapse the tangent"),
    group("turned", "A touch that squares cannot see.", rays(*TOUCHES, **BIG), skills="a tangent has a width"),
    group("full", "A touch that no formula in floats can see.", either(rays(*TOUCHES, "touch nearer", "touch nearer", **HUGE), rays(*TOUCHES, **SPLIT)), skills="a tangent has a width"),
    group("off-centre", "Rays past the centre by 1e-8 to 1e-1 of the radius, and chords that bend by 2e-6 to 2e-4 of it.", rays("off-centre before", "off-centre in", "flat before", "flat in", **HUGE), cases=100, skills="full precision"),
    group("near", "Nearly a touch: 1e-7 of the figure away.", rays("touch~ before", "touch~ before", "touch~ foot", **CLEAR), skills="nearly is not touching"),
    group("on-full", "The origin is on the circle, and rounding puts it beside.", either(telling(rays(*ON_CIRCLE, **HUGE), *TELLING), telling(rays(*ON_CIRCLE, **BIG), *BY_POWER), telling(rays("through first", "through last", "through first anyway", **HUGE), *BY_POWER), *[telling(rays("touch foot", **HUGE), *TELLING)] * 3, rays("through first anyway", "through last anyway", **{**HUGE, "turn": "axis"}), skimming), cases=190, skills="origin on the circle"),
    group("on-near", "The origin is just off the circle, inside or outside.", rays("chord first~", "chord last~", "chord last~ anyway", "through first~", "through first~", "through last~", "through last~", **CLEAR), cases=100, skills="origin on the circle"),
    group("direction-length", "Directions up to 1e39 times shorter than the figure, or 1e24 times longer.", either(*2 * [rays("cut before", "cut in", "cut after", "miss before", "dot-miss before", "touch before", "chord last", "chord last anyway", "chord first~", "chord last~", "touch~ before", **STRETCHED), rays("chord first~", "chord last~", "touch~ before", "touch~ after", **{**NEAR, "shift": 0, "stretch": (20, 40)}), rays("miss before", "cut after", "cut in", "touch after", **{**PLAIN, "shift": -60, "stretch": (60, 75, 90)})], faint(rays("cut in", **{**PLAIN, "shift": -70})), faint(rays("cut in", "cut before", **{**PLAIN, "shift": (18, 18, 0)})), enlarged(aimed(leaning(*LEANS, 1e-7, 1e-6))), enlarged(abreast)), cases=180, skills=("t is not a distance", "scale invariance")),
    group("small-parts", "A part that is 1e-9 to 1e-1 of another one, and counts.", ray, skills="full precision"),
    group("tiny", "All of it tiny, down to 1e-29.", either(rays("touch before", "touch~ before", "chord first~", "cut before", "touch after", "cut after", **TINY), rays("touch before", "cut before", **{**TINY, "turn": "axis"})), skills=("no absolute epsilon", "scale invariance")),
    group("offset", "A small figure far from the plane's origin.", either(*3 * [rays("cut before", "cut in", "miss before", "dot-miss before", "chord last", "chord first~", "chord last~", **OFFSET)], aimed(astray())), cases=80, skills="far from the origin"),
    group("offset-touch", "A small figure far from the plane's origin, and a touch.", rays("touch before", "touch before", "touch before", "touch near", "touch near", "touch~ before", **OFFSET), cases=120, skills="far from the origin"),
    group("far", "The circle is up to a hundred million times smaller than its distance.", either(rays("touch far", "cut very-far", "through farther", "touch remote", "touch~ far", **FAR), rays("touch far", "touch far", **{**FAR, "size": 1 << 20, "turn": "any"}), slant, slant, level, *2 * [rays("touch remote", **{**FAR, "size": 1 << 10, "turn": "any"})]), cases=200, skills="the sharp discriminant"),
    group("dot-full", "The circle is a point, on a ray that floats put beside it.", rays("dot before", "dot foot", "dot after", **SPLIT), skills="r = 0"),
    group("steep", "Directions almost along an axis.", either(*2 * [rays("cut before", "cut in", "cut foot", **ASKEW)], *3 * [rays(*TOUCHES, "cut before", "miss before", **STEEP), rays("cut before", "cut in", "miss before", "chord last", **{**TILTED, "tilt": (20, 75)})], aimed(leaning(*LEANS)), aimed(leaning(3e-8, depth=10**6)), *2 * [abreast]), cases=245, skills="no slopes"),
    group("sloping", "Rays off an axis by 1e-4 to 1e-1, whose origin is just off the circle: 1e-7 to 1e-6 of the figure.", aimed(sloping(end="origin")), cases=40, skills="no slopes"),
    group("large", "Whole numbers up to 2**30, some of them touches.", either(whole("nnrpd", 30), rays(*TOUCHES, **{**BIG, "shift": 0, "numbers": "int"})), skills=("whole numbers that are large", "scale invariance")),
    group("repeated", "Neighbouring calls differ in one argument.", grid("nnrpd", 4), turns=True, skills="nothing kept between calls"),
]
