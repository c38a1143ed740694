"""Where a ray first meets a sphere in space, and the normal there that faces the ray."""

from functools import partial
from math import cos, hypot, sin

from judge.geometry import Sphere, plain
from judge.geometry.hooks import hooks
from judge.geometry.pose import triple
from judge.geometry.scenes import AXIS, BIG, DECIMALS, FAR, HUGE, NEAR, OFFSET, PLAIN, SPLIT, TINY, LEANS, abreast, aimed, astray, either, enlarged, faint, grid, leaning, past, ratios, rays, skimming, spheres, still, telling, tried, uniform, whole, sloping
from judge.geometry.scenes.bands import raised, ray
from judge.problem.declare import group

HOOKS = hooks("sphere")
TOUCHES = ("touch before", "touch before", "touch near", "touch after")
ON_SPHERE = ("chord first", "chord last", "chord first anyway", "touch foot")
FLAT = rays("touch before", "touch before", "touch before", "touch foot", **{**SPLIT, "uneven": 18})
STRETCHED = {**PLAIN, "shift": (-17, -60), "stretch": tuple(range(-39, 90, 8))}
TELLING = plain.sphere_hit, partial(plain.sphere_hit, tolerance=1e-10)
BY_POWER = partial(plain.sphere_hit, power=True), partial(plain.sphere_hit, power=True, tolerance=1e-10)
CLEAR = {**NEAR, "least": 6}
DIAGONAL = {**CLEAR, "turn": "diagonal"}  # where |C − O| is 1.7 times the size


def solve(C, r, O, D):
    ray = Sphere(C, r, O, D)
    which = ray.hit()
    return None if which is None else (ray.time(which), ray.facing(which))


def along_an_axis(draw):
    C, r, O, D = spheres("cut before", "cut in", "through before", **{**AXIS, "numbers": "float"})(draw)
    return C, r, O, tuple(x or draw.sign() * 2.0 ** -draw.integer(10, 30) for x in D)


def flat(draw):
    """A touch in a plane of two axes: the third coordinate is the same everywhere."""
    (cx, cy, r, O, D), at, z = FLAT(draw), draw.integer(0, 2), draw.integer(-9, 9)
    C, O, D = ((*v[:at], h, *v[at:]) for v, h in (((cx, cy), z), (O, z), (D, 0)))
    return C, r, O, D


def side(C, r, O, D, slack=0, rest=False):
    """Whether the line is nearer than r to C, or farther: by the cross product with D's unit vector, or what is left of O − C across it."""
    f, length = [o - c for o, c in zip(O, C, strict=True)], hypot(*D)
    u = [x / length for x in D]
    foot = sum([x * y for x, y in zip(f, u, strict=True)])
    across = [x - foot * y for x, y in zip(f, u, strict=True)] if rest else [f[i] * u[i - 1] - f[i - 1] * u[i] for i in range(3)]
    gap, slack = hypot(*across) - r, slack * hypot(*f)
    return (gap > slack) - (gap < -slack)


BY_REST = partial(side, rest=True), partial(side, rest=True, slack=1e-6)


def outwards(case):
    """Whether the normal where the ray touches seems to look along it, for doubles."""
    C, r, O, D = case
    f, length = [o - c for o, c in zip(O, C, strict=True)], hypot(*D)
    u = [x / length for x in D]
    b = sum([x * y for x, y in zip(f, u, strict=True)])
    return sum([(x - b * y) * y for x, y in zip(f, u, strict=True)]) > 4e-13 * r


def lifted(drawn):
    """A ray in a plane through the centre, across an axis."""

    def in_space(draw):
        cx, cy, r, O, D = drawn(draw)
        z, at = draw.integer(-(2**40), 2**40) / 2**10, draw.integer(0, 2)
        C, O, D = ((*p[:at], n, *p[at:]) for p, n in (((cx, cy), z), (O, z), (D, 0.0)))
        return C, r, O, D

    return in_space


def tipped(draw):
    """A ray in a plane of two axes, or one that leaves it by 1e-6 to 1e-4, and a chord whose ends a small part moves."""
    cx, cy, r, O, D = aimed(ratios(short=True))(draw)
    tip, at, turn = draw.integer(16, 99) * 10.0 ** -draw.integer(6, 7) * draw.choice((0, 1, -1)), draw.integer(0, 2), draw.choice((1, -1))
    C, O, D = ((x, *(y * cos(tip), y * sin(tip))[::turn]) for x, y in ((cx, cy), O, D))
    C, O, D = ((*p[at:], *p[:at]) for p in (C, O, D))
    return C, r, O, D


def sloped(draw):
    """A ray off an axis by a part of both others, whose origin is just off the sphere."""
    cx, cy, r, O, D = aimed(sloping(end="origin"))(draw)
    (p, q, c), upright, at = triple(draw, 65), abs(D[1]) > abs(D[0]), draw.integer(0, 2)
    pairs = ((v[::-1] if upright else v) for v in ((cx, cy), O, D))
    C, O, D = ((*both[:at], along, *both[at:]) for along, both in ((x, (y * p / c, y * q / c)) for x, y in pairs))
    return C, r, O, D


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", either(*9 * [grid("PrPD", 3)], still(grid("PrPD", 3))), cases=200, skills="the small grid"),
    group("outside", "From outside: the nearer of two points and the normal outward, or a miss.", spheres("cut before", "through before", "miss before", **PLAIN), skills=("three axes, the same formula", "a normal that faces the ray")),
    group("tilted", "Rays in every direction of space: no plane of two axes holds them.", spheres("cut before", "cut in", **BIG), skills="three axes, the same formula"),
    group("inside", "From inside: where the ray leaves, and the normal inward, towards it.", spheres("cut in", "cut foot", "cut in anyway", **PLAIN), skills=("a normal that faces the ray", "origin inside")),
    group("on-sphere", "The origin is on the sphere, and the ray looks in or out: t = 0.", spheres(*ON_SPHERE, **PLAIN), skills="origin on the circle"),
    group("touch", "The ray touches: ahead, behind, or at its origin.", spheres(*TOUCHES, "touch foot", **PLAIN), skills="collapse the tangent"),
    group("behind", "The sphere is behind the origin.", spheres("cut after", "touch after", **PLAIN), skills="clamp to a ray"),
    group("no-ray", "D = (0, 0, 0) is no ray, and with r = 0 there is no sphere.", either(lambda draw: (*spheres("chord first", "cut in", "miss before", **PLAIN)(draw)[:3], (0, 0.0, 0)), spheres("dot before", "dot foot", "dot-miss before", **PLAIN)), skills=("r = 0", "degenerate line")),
    group("random", "Any numbers, small and large.", either(*3 * [uniform("PrPD", 20, 1e4, 1e9)], lifted(aimed(past))), cases=80, skills="three axes, the same formula"),
]

PRODUCTION = [  # the same, where rounding bites
    group("decimals", "Touches in short decimals, which == does not see.", telling(spheres(*TOUCHES, "touch foot", **DECIMALS), *TELLING), skills="collapse the tangent"),
    group("turned", "A touch that squares cannot see.", spheres(*TOUCHES, **BIG), skills="a tangent has a width"),
    group("full", "A touch that no formula in floats can see.", either(spheres(*TOUCHES, "touch foot", "touch nearer", **HUGE), spheres(*TOUCHES, **SPLIT), *[telling(telling(flat, side, partial(side, slack=1e-6)), *BY_REST)] * 4), cases=150, skills="a tangent has a width"),
    group("off-centre", "Rays past the centre by 1e-8 to 1e-1 of the radius, and chords that bend by 2e-6 to 2e-4 of it.", spheres("off-centre before", "off-centre in", "flat before", "flat in", **HUGE), cases=100, skills="three axes, the same formula"),
    group("near", "Nearly a touch: 1e-7 of the figure away.", either(spheres("touch~ before", "touch~ before", "touch~ foot", **CLEAR), telling(spheres("touch~ far", **DIAGONAL), side, partial(side, slack=0.65e-7))), skills="nearly is not touching"),
    group("on-full", "The origin is on the sphere, and rounding puts it beside.", either(telling(spheres(*ON_SPHERE, **HUGE), *TELLING), telling(spheres(*ON_SPHERE, **BIG), *BY_POWER), spheres("through first anyway", "through last anyway", **{**HUGE, "turn": "axis"}), spheres("through last", **{**HUGE, "turn": "axis"}), *[spheres("through last", **HUGE)] * 2, lifted(skimming)), cases=135, skills="origin on the circle"),
    group("on-near", "The origin is just off the sphere, inside or outside.", spheres("chord first~", "chord last~", "chord last~ anyway", "through first~", "through first~", "through last~", "through last~", **CLEAR), cases=100, skills="origin on the circle"),
    group("along-an-axis", "Rays that are off an axis by 1e-9 to 1e-3 of their length: that small part counts.", either(*4 * [along_an_axis], *[lifted(aimed(leaning(*leans, depth=depth))) for leans, depth in (*4 * [(LEANS, 1)], *2 * [([3e-8], 10**6)])], *2 * [lifted(abreast)]), cases=205, skills="three axes, the same formula"),
    group("sloping", "Rays off an axis by 1e-4 to 1e-1, whose origin is just off the sphere: 1e-7 to 1e-6 of the figure.", sloped, cases=50, skills="three axes, the same formula"),
    group("direction-length", "Directions up to 1e39 times shorter than the figure, or 1e24 times longer.", either(*2 * [spheres("cut before", "cut in", "cut in anyway", "miss before", "touch before", "chord last", "chord last anyway", "chord first~", "chord last~", "touch~ before", **STRETCHED), spheres("cut before", "cut in", **{**OFFSET, "stretch": (20, 40)}), spheres("cut before", "cut in", "touch before", **{**HUGE, "move": 0, "shift": -60, "stretch": (-60, -39, -20, 40, 80)}), spheres("chord first~", "chord last~", "touch~ before", "touch~ after", **{**NEAR, "shift": 0, "stretch": (20, 40)}), spheres("cut before", "cut in", "chord last", **{**HUGE, "move": 0, "shift": 0, "stretch": -80}), spheres("miss before", "cut after", "cut in", "touch after", **{**PLAIN, "shift": -60, "stretch": (60, 75, 90)})], *2 * [faint(spheres("cut in", **{**PLAIN, "shift": -70}))], faint(spheres("cut in", "cut before", **{**PLAIN, "shift": (18, 18, 0)})), *[enlarged(lifted(drawn)) for drawn in (aimed(leaning(*LEANS, 1e-7, 1e-6)), aimed(past), abreast)]), cases=234, skills="t is not a distance"),
    group("small-parts", "A part that is 1e-9 to 1e-1 of another one, and counts.", either(raised(ray), *2 * [tipped]), cases=240, skills="three axes, the same formula"),
    group("tiny", "All of it tiny, down to 1e-29.", either(spheres("touch before", "touch~ before", "chord first~", "cut before", "touch after", "cut after", **TINY), spheres("touch before", "cut before", "cut in", **{**TINY, "turn": "axis"})), skills=("no absolute epsilon", "scale invariance")),
    group("offset", "A small figure far from the origin.", either(*3 * [spheres("cut before", "cut in", "miss before", "cut after", "chord last", "chord first~", "chord last~", **OFFSET)], lifted(aimed(astray()))), cases=80, skills="far from the origin"),
    group("offset-touch", "A small figure far from the origin, and a touch.", spheres("touch before", "touch before", "touch before", "touch near", "touch near", "touch~ before", **OFFSET), cases=120, skills="far from the origin"),
    group("far", "The sphere is thousands of times smaller than its distance, or, where the ray touches it, a million times.", either(*2 * [spheres("touch far", "cut far", "touch~ far", **{**FAR, "size": 1 << 20})], tried(spheres("touch far", "touch very-far", **{**FAR, "size": 1 << 10, "turn": "any", "move": 30}), outwards)), cases=90, skills="nearly is not touching"),
    group("large", "Whole numbers up to 2**30, some of them touches.", either(whole("PrPD", 30), spheres(*TOUCHES, "miss before", "cut before", "cut in", **{**BIG, "shift": 0, "stretch": (0, 20, 30), "numbers": "int"})), skills=("whole numbers that are large", "scale invariance")),
    group("repeated", "Neighbouring calls differ in one argument.", grid("PrPD", 3), cases=60, turns=True, skills="nothing kept between calls"),
]
