"""The unit normal of a circle where a ray first meets it, on the side that the ray comes from."""

from functools import partial

from judge.geometry import Line, plain
from judge.geometry.hooks import hooks
from judge.geometry.pose import triple
from judge.geometry.scenes import ASKEW, AXIS, BIG, DECIMALS, FAR, HUGE, LEANS, NEAR, OFFSET, PLAIN, SPLIT, STEEP, TILTED, TINY, abreast, aimed, astray, either, enlarged, faint, grid, leaning, past, rays, skimming, still, telling, uniform, whole, sloping, doubles
from judge.geometry.scenes.bands import ray
from judge.problem.declare import group

HOOKS = hooks("normal")
TOUCHES = ("touch before", "touch before", "touch near", "touch after")
ON_CIRCLE = ("chord first", "chord last", "chord first anyway", "touch foot")
STRETCHED = {**PLAIN, "shift": (-17, -60), "stretch": tuple(range(-39, 90, 8))}
TELLING = plain.first_hit, partial(plain.first_hit, tolerance=1e-10)
BY_POWER = partial(plain.first_hit, power=True), partial(plain.first_hit, power=True, tolerance=1e-10)
CLEAR = {**NEAR, "least": 7}


def solve(cx, cy, r, O, D):
    ray = Line.ray(cx, cy, r, O, D)
    which = ray.hit()
    return None if which is None else ray.facing(which)


def distant(draw):
    """A ray that nearly touches a circle 2e7 to 2e9 times as far from the origin as it is large, where one
    coordinate is large and the other one is small.
    """
    unit, x = 2.0 ** -draw.integer(24, 90), draw.integer(2**51, 2**53 - 2**28)
    size = draw.integer(2**22, 2**23) << draw.choice((0, 0, 0, 0, 0, 4))
    gap, way = size * draw.integer(102, 190) / 10**9 * draw.choice((1, 1, -1)), draw.sign()
    y, at = (size + gap) * draw.sign(), draw.choice((-1, -1, -1, -1, -1, 1)) * way * draw.integer(2, size)
    turn, side = draw.choice((1, 1, -1)), unit * draw.sign()
    C, O = (((x + u) * side, v * unit)[::turn] for u, v in ((0, 0.0), (at, y)))
    return *C, size * unit, O, (way * draw.integer(1, 9) * (side / unit), 0.0)[::turn]


def lengthwise(draw):
    """From one end of a circle to the other one, off an axis by 0.7e-9 to 1e-9 of the way."""
    r, turn = draw.integer(2**40, 2**41) * 2.0 ** -draw.integer(30, 60), draw.choice((1, -1))
    x, y, lean = draw.integer(-30, 30) * r / 99, r * draw.integer(85, 94) / 100 * draw.sign(), draw.integer(7, 9) * draw.sign() / 10**10
    cx, cy, far = draw.integer(-2, 2) * r, draw.integer(-2, 2) * r, draw.integer(1, 9)
    return *(cx, cy)[::turn], r, (cx + x, cy + y)[::turn], (lean * far, -far if y > 0 else far)[::turn]


def blurred(draw):
    """A touch far away in whole numbers, where the distance by a unit vector is off by 1.5e-16 of the size."""
    for _ in range(50):
        (p, q, c), times = triple(draw, 1000), draw.integer(1, 99)
        product = 1 << (times * draw.integer(100, 2000) * p * q // c).bit_length()
        k = product * draw.integer(1000, 1060) * c // (1000 * p * q) * draw.sign()
        r, O = times * c, (k * p - times * q, k * q + times * p)
        size, d = max(r, *map(abs, O)), abs(p / c * O[1] - q / c * O[0])
        if size < 9999 * r and abs(d - r) > 1.52e-16 * size:
            x, y, way = draw.sign(), draw.sign(), draw.integer(1, 9) * (-1 if k > 0 else 1)
            return 0, 0, r, (O[0] * x, O[1] * y), (way * p * x, way * q * y)
    return draw.reject()


def specks(draw):
    """A circle of 1e-30 to 2e-30, which a ray meets or nearly meets."""
    scale, r = 2.0**-109, draw.integer(650, 1290)
    x, y = (draw.choice((0, draw.integer(650, 6000) * draw.sign())) for _ in "xy")
    O = (draw.integer(650, 6000) * draw.sign(), draw.choice((0, y)))
    D = draw.choice(((draw.integer(-9, 9), draw.integer(1, 9)), *2 * [(x - O[0], y - O[1])]))
    return x * scale, y * scale, r * scale, (O[0] * scale, O[1] * scale), D


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", either(*9 * [grid("nnrpd", 3)], still(grid("nnrpd", 3))), cases=200, skills="the small grid"),
    group("outside", "From outside: where the ray enters, the normal outward.", either(rays("cut before", "through before", **PLAIN), rays("cut before", **AXIS)), skills=("the unit normal", "no slopes")),
    group("inside", "From inside: where the ray leaves, the normal inward.", rays("cut in", "cut foot", "cut in anyway", **PLAIN), skills=("the side of the ray", "origin inside")),
    group("on-circle", "The origin is on the circle, and the ray looks in or out.", rays(*ON_CIRCLE, **PLAIN), skills="origin on the circle"),
    group("touch", "The ray touches: the normal points outward.", rays(*TOUCHES, "touch foot", **PLAIN), skills="collapse the tangent"),
    group("behind", "The circle is behind the origin, or beside the ray.", rays("cut after", "touch after", "miss before", **PLAIN), skills="clamp to a ray"),
    group("no-ray", "D = (0, 0) is no ray, and with r = 0 there is no normal.", either(lambda draw: (*rays("chord first", "cut in", "miss before", **PLAIN)(draw)[:4], (0, 0.0)), rays("dot before", "dot foot", "dot-miss before", **PLAIN)), skills=("r = 0", "degenerate line")),
    group("random", "Any numbers, small and large.", uniform("nnrpd", 20, 1e4, 1e9), skills="full precision"),
]

PRODUCTION = [  # the same, where rounding bites
    group("decimals", "Touches in short decimals, which == does not see.", telling(rays(*TOUCHES, "touch foot", **DECIMALS), *TELLING), skills="collapse the tangent"),
    group("turned", "A touch that squares cannot see.", rays(*TOUCHES, **BIG), skills="a tangent has a width"),
    group("full", "A touch that no formula in floats can see.", either(rays(*TOUCHES, "touch foot", "touch nearer", "touch nearer", **HUGE), rays(*TOUCHES, **SPLIT)), skills="a tangent has a width"),
    group("near", "Nearly a touch: 1e-7 of the figure away.", rays("touch~ before", "touch~ before", "touch~ foot", **CLEAR), skills="nearly is not touching"),
    group("on-full", "The origin is on the circle, and rounding puts it beside.", either(telling(rays(*ON_CIRCLE, **HUGE), *TELLING), telling(rays(*ON_CIRCLE, **BIG), *BY_POWER), rays("through first anyway", "through last anyway", **{**HUGE, "turn": "axis"}), *2 * [skimming]), cases=90, skills="origin on the circle"),
    group("on-near", "The origin is just off the circle, inside or outside.", rays("chord first~", "chord last~", "chord last~ anyway", "through first~", "through first~", "through last~", "through last~", **CLEAR), cases=100, skills="the side of the ray"),
    group("far", "The circle is up to 10,000 times smaller than its distance.", either(*2 * [rays("touch far", "cut far", "touch~ far", **{**FAR, "size": 1 << 20})], *3 * [blurred]), cases=76, skills="the unit normal"),
    group("direction-length", "Directions up to 1e39 times shorter than the figure, or 1e24 times longer.", either(*2 * [rays("cut before", "cut in", "miss before", "touch before", "chord last", "chord last anyway", "chord first~", "chord last~", "touch~ before", **STRETCHED), rays("cut before", "cut in", "touch before", **{**HUGE, "move": 0, "shift": -60, "stretch": (-39, -20, 40, 80)}), rays("chord first~", "chord last~", "touch~ before", "touch~ after", **{**NEAR, "shift": 0, "stretch": (20, 40)}), rays("miss before", "cut after", "cut in", "touch after", **{**PLAIN, "shift": -60, "stretch": (60, 75, 90)})], faint(rays("cut in", **{**PLAIN, "shift": -70})), faint(rays("cut in", "cut before", **{**PLAIN, "shift": (18, 18, 0)})), enlarged(aimed(leaning(*LEANS, 1e-7, 1e-6))), enlarged(abreast)), cases=220, skills="t is not a distance"),
    group("off-centre", "Rays past the centre by 1e-8 to 1e-1 of the radius, and chords that bend by 2e-6 to 2e-4 of it.", either(*4 * [rays("off-centre before", "off-centre in", "flat before", "flat in", **HUGE)], aimed(past)), cases=110, skills="the unit normal"),
    group("small-parts", "A part that is 1e-9 to 1e-1 of another one, and counts.", ray, skills="full precision"),
    group("tiny", "All of it tiny, down to 1e-30.", either(*2 * [rays("touch before", "touch~ before", "chord first~", "cut before", "touch after", "cut after", **TINY), rays("touch before", "cut before", **{**TINY, "turn": "axis"})], specks), cases=75, skills=("no absolute epsilon", "scale invariance")),
    group("offset", "A small figure far from the plane's origin.", either(*3 * [rays("cut before", "cut in", "miss before", "cut after", "chord last", "chord first~", "chord last~", **OFFSET)], aimed(astray())), cases=80, skills="far from the origin"),
    group("offset-touch", "A small figure far from the plane's origin, and a touch, or nearly one.", either(*5 * [rays("touch before", "touch before", "touch before", "touch near", "touch near", "touch~ before", **OFFSET)], distant), cases=144, skills="far from the origin"),
    group("odd-steps", "The origin is on the circle far from the origin, an odd number of the last digits away: half of the way is no double.", lambda draw: (*doubles.odd_steps(draw), (draw.integer(-9, 9), draw.integer(1, 9) * draw.sign())), cases=12, skills="far from the origin"),
    group("steep", "Directions almost along an axis.", either(*2 * [rays("cut before", "cut in", "cut foot", **ASKEW)], *3 * [rays(*TOUCHES, "cut before", "miss before", **STEEP), rays("cut before", "cut in", "miss before", "chord last", **{**TILTED, "tilt": (20, 75)})], aimed(leaning(*LEANS)), *2 * [abreast], lengthwise), cases=245, skills="no slopes"),
    group("sloping", "Rays off an axis by 1e-4 to 1e-1, whose origin is just off the circle: 1e-7 to 1e-6 of the figure.", aimed(sloping(end="origin")), cases=40, skills="no slopes"),
    group("large", "Whole numbers up to 2**30, some of them touches.", either(whole("nnrpd", 30), rays(*TOUCHES, "miss before", "cut before", **{**BIG, "shift": 0, "stretch": (0, 20), "numbers": "int"})), skills=("whole numbers that are large", "scale invariance")),
    group("repeated", "Neighbouring calls differ in one argument.", grid("nnrpd", 3), turns=True, skills="nothing kept between calls"),
]
