"""The point where a ray first meets a circle, and the direction D − 2(D·N)N in which it is reflected there."""

from functools import partial

from judge.geometry import Line, plain
from judge.geometry.hooks import hooks
from judge.geometry.pose import triple
from judge.geometry.scenes import ASKEW, AXIS, BIG, DECIMALS, FAR, HUGE, LEANS, LEVEL, NEAR, OFFSET, PLAIN, SPLIT, STEEP, TILTED, TINY, abreast, aimed, astray, brim, distant, either, enlarged, faint, grid, leaning, rays, skimming, still, telling, uniform, whole, sloping
from judge.geometry.scenes.bands import ray
from judge.problem.declare import group

HOOKS = hooks("reflection")
TOUCHES = ("touch before", "touch before", "touch near", "touch after")
ON_CIRCLE = ("chord first", "chord last", "chord first anyway", "touch foot")
STRETCHED = {**PLAIN, "shift": (-17, -60), "stretch": tuple(range(-39, 90, 8))}
TELLING = plain.first_hit, partial(plain.first_hit, tolerance=1e-10)
BY_POWER = partial(plain.first_hit, power=True), partial(plain.first_hit, power=True, tolerance=1e-10)
CLEAR = {**NEAR, "least": 7}


def solve(cx, cy, r, O, D):
    ray = Line.ray(cx, cy, r, O, D)
    which = ray.hit()
    return None if which is None else (ray.real_point(which), ray.reflected(which))


def grazed(draw):
    """A circle of 1 to 1.7 ten-thousandths of the size, which a ray cuts or misses by 1.01e-7 to 1e-6 of the size."""
    p, q, c = draw.choice(((1, 0, 1), (0, 1, 1), triple(draw, 65)))
    scale, side, back = draw.integer(2**40, 2**41) * 2.0 ** -draw.integer(15, 90), draw.sign(), draw.sign()
    far = scale * c / max(p, q)
    r = scale * draw.integer(1001, draw.choice((1020, 1700))) / 10**7
    off = r + scale * draw.integer(101, draw.choice((130, 150, 1000))) / 10**9 * draw.sign()
    O = back * (q * off - p * far) / c, side * (-p * off - q * far) / c
    cx, cy = (scale * draw.choice((0, 0, 1, -2)) for _ in "xy")
    times = draw.integer(1, 9)
    return cx, cy, r, (cx + O[0], cy + O[1]), (back * p * times, side * q * times)


def head_on(draw):
    """A ray nearly along an axis, through the centre but for 1e-10 to 1e-4 of the radius, seldom more than 1e-9."""
    lean, high = (draw.choice((0, 0.0, 1e-9, 1e-9, 10.0 ** -draw.integer(4, 10))) * draw.integer(57, 99) / 100 * draw.sign() for _ in "xy")
    scale, side, back = draw.integer(2**20, 2**21) * 2.0 ** -draw.integer(0, 60), draw.sign(), draw.choice((-0.5, 1.25, 1.5, 3.0))
    turn, times = draw.choice((1, -1)), draw.integer(1, 9)
    O, D = (-back * side, high - back * lean), (side, lean)
    return 0, 0, scale, tuple(x * scale for x in O[::turn]), tuple(x * scale * times for x in D[::turn])


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", either(*9 * [grid("nnrpd", 3)], still(grid("nnrpd", 3))), cases=200, skills="the small grid"),
    group("outside", "From outside: where the ray enters, and is thrown back.", either(rays("cut before", "through before", **PLAIN), rays("cut before", **AXIS)), skills=("reflect a vector", "no slopes")),
    group("inside", "From inside: the ray is thrown back into the circle.", rays("cut in", "cut foot", "cut in anyway", **PLAIN), skills="origin inside"),
    group("head-on", "Rays through the centre are thrown back the way they came.", rays("through before", "through foot", "through in", **PLAIN), skills="reflect a vector"),
    group("on-circle", "The origin is on the circle, and the ray looks in or out.", rays(*ON_CIRCLE, **PLAIN), skills="origin on the circle"),
    group("touch", "The ray touches, and goes on as it came.", rays(*TOUCHES, "touch foot", **PLAIN), skills="collapse the tangent"),
    group("behind", "The circle is behind the origin, or beside the ray.", rays("cut after", "touch after", "miss before", **PLAIN), skills="clamp to a ray"),
    group("no-ray", "D = (0, 0) is no ray, and with r = 0 there is no mirror.", either(lambda draw: (*rays("chord first", "cut in", "miss before", **PLAIN)(draw)[:4], (0, 0.0)), rays("dot before", "dot foot", "dot-miss before", **PLAIN)), skills=("r = 0", "degenerate line")),
    group("random", "Any numbers, small and large.", uniform("nnrpd", 20, 1e4, 1e9), skills="full precision"),
]

PRODUCTION = [  # the same, where rounding bites
    group("decimals", "Touches in short decimals, which == does not see.", telling(rays(*TOUCHES, "touch foot", **DECIMALS), *TELLING), skills="collapse the tangent"),
    group("turned", "A touch that squares cannot see.", rays(*TOUCHES, **BIG), skills="a tangent has a width"),
    group("full", "A touch that no formula in floats can see.", either(rays(*TOUCHES, "touch foot", "touch nearer", "touch nearer", **HUGE), rays(*TOUCHES, **SPLIT)), skills="a tangent has a width"),
    group("near", "Nearly a touch: 1e-7 of the figure away.", rays("touch~ before", "touch~ before", "touch~ foot", **CLEAR), skills="nearly is not touching"),
    group("on-full", "The origin is on the circle, and rounding puts it beside.", either(telling(rays(*ON_CIRCLE, **HUGE), *TELLING), telling(rays(*ON_CIRCLE, **BIG), *BY_POWER), rays("through first anyway", "through last anyway", **{**HUGE, "turn": "axis"}), *2 * [skimming]), cases=90, skills="origin on the circle"),
    group("on-near", "The origin is just off the circle, inside or outside.", rays("chord first~", "chord last~", "chord last~ anyway", "through first~", "through first~", "through last~", "through last~", **CLEAR), cases=100, skills="origin on the circle"),
    group("far", "The circle is up to 10,000 times smaller than its distance.", rays("touch far", "cut far", "touch~ far", **{**FAR, "size": 1 << 20}), skills="reflect a vector"),
    group("far-near", "The circle is 10,000 times smaller than its distance or nearly so, and the ray hardly meets or hardly misses it.", grazed, cases=20, skills="nearly is not touching"),
    group("direction-length", "Directions up to 1e39 times shorter than the figure, or 1e24 times longer.", either(*2 * [rays("cut before", "cut in", "miss before", "touch before", "chord last", "chord last anyway", "chord first~", "chord last~", "touch~ before", **STRETCHED), rays("cut before", "cut in", "touch before", **{**HUGE, "move": 0, "shift": -60, "stretch": (-39, -20, 40, 80)}), rays("chord first~", "chord last~", "touch~ before", "touch~ after", **{**NEAR, "shift": 0, "stretch": (20, 40)}), rays("miss before", "cut after", "cut in", "touch after", **{**PLAIN, "shift": -60, "stretch": (60, 75, 90)})], faint(rays("cut in", **{**PLAIN, "shift": -70})), faint(rays("cut in", "cut before", **{**PLAIN, "shift": (18, 18, 0)})), enlarged(aimed(leaning(*LEANS, 1e-7, 1e-6))), enlarged(abreast)), cases=230, skills=("t is not a distance", "as long as it was")),
    group("off-centre", "Rays past the centre by 1e-8 to 1e-1 of the radius, and chords that bend by 2e-6 to 2e-4 of it.", rays("off-centre before", "off-centre in", "flat before", "flat in", **HUGE), cases=100, skills="reflect a vector"),
    group("small-parts", "A part that is 1e-9 to 1e-1 of another one, and counts.", either(*2 * [ray], head_on), cases=90, skills="full precision"),
    group("tiny", "All of it tiny, down to 1e-29.", either(rays("touch before", "touch~ before", "chord first~", "cut before", "touch after", "cut after", **TINY), rays("touch before", "cut before", **{**TINY, "turn": "axis"})), skills=("no absolute epsilon", "scale invariance")),
    group("offset", "A small figure far from the plane's origin.", either(*3 * [rays("cut before", "cut in", "miss before", "cut after", "chord last", "chord first~", "chord last~", **OFFSET)], *2 * [rays("cut before", "cut in", "chord last", **LEVEL)], aimed(astray()), *2 * [aimed(distant)], aimed(brim)), cases=180, skills="far from the origin"),
    group("offset-touch", "A small figure far from the plane's origin, and a touch.", rays("touch before", "touch before", "touch before", "touch near", "touch near", "touch~ before", **OFFSET), cases=120, skills="far from the origin"),
    group("steep", "Directions almost along an axis.", either(*2 * [rays("cut before", "cut in", "cut foot", **ASKEW)], *3 * [rays(*TOUCHES, "cut before", "miss before", **STEEP), rays("cut before", "cut in", "miss before", "chord last", **{**TILTED, "tilt": (20, 75)})], aimed(leaning(*LEANS)), *2 * [abreast]), cases=220, skills="no slopes"),
    group("sloping", "Rays off an axis by 1e-4 to 1e-1, whose origin is just off the circle: 1e-7 to 1e-6 of the figure.", aimed(sloping(end="origin")), cases=40, skills="no slopes"),
    group("large", "Whole numbers up to 2**30, some of them touches.", either(whole("nnrpd", 30), rays(*TOUCHES, "miss before", "cut before", **{**BIG, "shift": 0, "stretch": (0, 20), "numbers": "int"})), skills=("whole numbers that are large", "scale invariance")),
    group("repeated", "Neighbouring calls differ in one argument.", grid("nnrpd", 3), turns=True, skills="nothing kept between calls"),
]
