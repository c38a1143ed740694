"""Every hit of a ray with a list of circles: exactly, in order, those at one place in any order."""

from functools import partial
from itertools import chain, permutations, product
from math import factorial, frexp, ldexp, prod, sqrt

from judge.geometry import Crowd, plain
from judge.geometry.hooks import hooks
from judge.geometry.pose import triple
from judge.geometry.scenes import ASKEW, AXIS, BIG, DECIMALS, FAR, HUGE, NEAR, OFFSET, PLAIN, STEEP, TILTED, TINY, aimed, aligned, anywhere, crowd_of, crowds, either, hardly, lines, pinpoint, ratios, sloping, telling, tried
from judge.geometry.scenes.crowds import apart
from judge.geometry.scenes.lines import astray
from judge.problem.declare import AnyOf, InvalidCase, group

HOOKS = hooks("hits")
TAGS = {-1: "enter", 0: "touch", 1: "exit"}
FULL = {**HUGE, "size": 2**36}
MANY = "cut", "cut", "around", "behind", "beside"
TIES = "exit2 enter2", "cut1 mirror copy", "enter3 touch3 exit3", "exit1 enter1 touch2 enter2"
TOUCHES = "touch2 copy", "touch2 copy copy", "touch2 mirror", "touch2 copy mirror", "touch3 touch3", "touch3 touch3 touch3", "touch0 mirror", "touch0 copy cut"
POINTS = "dot0 copy", "dot0 dot0", "dot copy", "dot copy", "dot copy copy cut", "dot0 copy copy", "dot0 copy touch0", "dot0 touch0 exit0", "dot0 exit0 enter0"
ORIGIN = "exit0 enter", "touch0 enter", "enter0 touch", "enter0 exit0"
MOST_ORDERS = 720
TELLING = plain.hits, partial(plain.hits, tolerance=1e-10)


def solve(circles, O, D):
    crowd = Crowd(circles, O, D)
    places = [[(crowd.time(hit), hit.circle, TAGS[hit.which]) for hit in place] for place in crowd.places()]
    if prod(factorial(len(hits)) for hits in places) > MOST_ORDERS:
        raise InvalidCase(f"The hits at one place can be put into more than {MOST_ORDERS} orders.")
    orders = [[*chain(*order)] for order in product(*map(permutations, places))]
    return AnyOf(orders) if len(orders) > 1 else orders[0]


def order(circles, O, D, bits=53):
    """The hits of circles that the ray leaves, in the order of t, which has so many bits."""
    length = sqrt(D[0] * D[0] + D[1] * D[1])
    found = []
    for index, (x, y, r) in enumerate(circles):
        fx, fy = O[0] - x, O[1] - y
        across, foot = (D[0] * fy - D[1] * fx) / length, -(D[0] * fx + D[1] * fy) / length
        part, power = frexp((foot + sqrt(max(0, (r - across) * (r + across)))) / length)
        found.append((round(ldexp(part, bits)), power, index))
    return [index for *_, index in sorted(found, key=lambda hit: hit[1::-1])]


def leaning(draw, least=20, most=2000):
    """As `aligned`, with a ray nearly along the tangent at its origin."""
    circles, O, _ = aligned(2**20, (1, 3))(draw)
    D = draw.sign(), draw.integer(least, most)
    return circles, O, D if circles[0][1] == O[1] else D[::-1]


def outwards(draw):
    """As `aligned`, with a ray nearly along the normal at its origin."""
    circles, O, D = leaning(draw, 1 << 21, 1 << 29)
    return circles, O, (D[1] * draw.sign(), D[0])


def grazing(draw):
    """A ray that touches a circle whose centre is level with its origin, or upright."""
    p, q, c = triple(draw, 65)
    k, m = draw.integer(1, 1 << 40), draw.integer(1, 1 << 24)
    x, y, far = draw.integer(-(1 << 40), 1 << 40), draw.integer(-(1 << 40), 1 << 40), c * k * draw.sign()
    C, O, D = (x + far, y), (x, y), (m * q * (1 if far > 0 else -1), m * p * draw.sign())
    turn = draw.choice((1, -1))
    unit = ldexp(1.0, draw.integer(-40, -18))
    return ((*[n * unit for n in C[::turn]], p * k * unit),), tuple([n * unit for n in O[::turn]]), D[::turn]


def touched(draw, drawn, times=(1,)):
    """The circle and the ray along the line that `drawn` draws; or two circles about one centre, the second one some `times` as large."""
    cx, cy, r, O, D = aimed(drawn)(draw)
    return tuple([(cx, cy, r * each) for each in {1: None, draw.choice(times): None}]), O, D


def mislaid(case):
    """Whether the foot, as a point of the plane, is rounded too much, and the origin is not a hundred million sizes away from the plane's."""
    circles, (ox, oy), D = case
    length, (x, y, r) = sqrt(D[0] * D[0] + D[1] * D[1]), circles[0]
    ux, uy = D[0] / length, D[1] / length
    foot, size = (x - ox) * ux + (y - oy) * uy, max(abs(x - ox), abs(y - oy), *[each[2] for each in circles])
    fx, fy = ox + foot * ux - x, oy + foot * uy - y
    return abs(sqrt(fx * fx + fy * fy) - r) > 1.2e-9 * size and abs(ox) + abs(oy) < 9.9e7 * size


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", anywhere(3, (1, 4)), cases=120, skills="the small grid"),
    group("two", "Two circles ahead of the origin, and one behind it or beside the ray.", either(crowds("cut cut behind", "cut enter beside", "enter cut", **PLAIN), crowds("cut cut beside", **AXIS)), skills=("hits in order", "enter, touch, exit")),
    group("many", "Up to forty circles that overlap, in any order of the list.", crowd_of(*MANY, count=(2, 40), first="cut", **PLAIN), skills="hits in order"),
    group("inside", "The origin inside circles, and others behind it: only hits with t >= 0 count.", crowds("around behind cut", "around around behind", "around beside", **PLAIN), skills=("origin inside", "enter, touch, exit")),
    group("ties", "Circles that are met at one place: all of their hits count, in any order.", either(*3 * [crowds(*TIES, **PLAIN)], *2 * [crowds(*TOUCHES, **PLAIN)]), cases=100, skills="hits at one place"),
    group("touch", "Circles that the ray touches: one hit each, be it ahead, at the origin or behind.", crowds("touch cut", "touch touch0", "touch-behind touch", "around touch", **PLAIN), skills=("collapse the tangent", "enter, touch, exit")),
    group("on-circle", "The origin on circles, entering or leaving them: a hit at t = 0.", crowds(*ORIGIN, "exit0", "enter0 cut", **PLAIN), skills="origin on the circle"),
    group("copies", "The same circle several times, and circles about one centre.", crowds("cut copy", "cut copy copy cut", "cut room copy", "enter within cut", "around copy", **PLAIN), skills="hits at one place"),
    group("radius-zero", "Circles of radius 0: points on the ray, beside it, behind it or at its origin.", either(*3 * [crowds("dot0", "dot cut", "dot0 enter", "dot dot", "enter2 dot2", "around dot", **PLAIN)], *2 * [crowds(*POINTS, **PLAIN)]), cases=100, skills="r = 0"),
    group("repeated", "Neighbouring calls differ in one argument.", anywhere(4, (1, 3)), turns=True, skills="nothing kept between calls"),
]

PRODUCTION = [  # the same, where rounding bites
    group("decimals", "Touches in short decimals, which == does not see.", telling(crowds("touch touch", "touch0 touch", "touch around", **DECIMALS), *TELLING), skills="collapse the tangent"),
    group("turned", "Touches and ties that squares cannot see.", crowds("touch touch", "touch exit2 enter2", "touch cut", "around touch", **BIG), skills="a tangent has a width"),
    group("ties-full", "Hits at one place that floats put in order, and touches that they miss.", crowds("exit2 enter2 touch", "cut1 mirror copy", "enter3 touch3 exit3", "dot cut", "dot2 dot", "dot0 enter dot", "enter2 dot2", "dot0 touch", "dot0 touch", "dot0 touch touch", "dot0 exit0 touch", **FULL), cases=160, skills=("hits at one place", "a tangent has a width")),
    group("origin-full", "The origin on a circle, and rounding puts it beside.", telling(crowds(*ORIGIN, "exit0", "touch0", "touch0 behind", **FULL), *TELLING), skills="origin on the circle"),
    group("origin-touch", "The ray touches a circle at its origin, and rounding puts that behind.", crowds("touch0", "touch0 behind", "touch0 exit0", **BIG), cases=90, skills="origin on the circle"),
    group("origin-level", "The origin on circles, level with their centres or upright, and the ray any way or nearly along them, or it touches a circle further on.", either(telling(either(aligned(20, (1, 3)), aligned(2**28, (1, 3))), *TELLING), *2 * [telling(grazing, *TELLING)], leaning, telling(outwards, *TELLING)), cases=150, skills="origin on the circle"),
    group("off-centre", "Rays past the centre by 1e-8 to 1e-1 of the radius, and chords that bend by 2e-6 to 2e-4 of it.", partial(touched, drawn=lines("off-centre before foot", "off-centre in foot", "flat before foot", "flat in foot", **HUGE)), cases=100, skills="full precision"),
    group("near", "Nearly a touch: 1e-7 of the figure away.", either(crowds("touch~ cut", "touch~ touch~", "around touch~", "dot~ cut", **{**NEAR, "least": 7}), crowds("touch9~", "touch9~ cut", **{**NEAR, "least": 7})), cases=100, skills="nearly is not touching"),
    group("ties-near", "Two hits nearly at one place: their order counts.", either(*[crowds("exit2~ enter2", "enter2 enter2~", "exit2~ exit2", "touch2 enter2~", **each) for each in (NEAR, {**NEAR, "least": 7})], telling(crowds("exit3~ exit3", "exit4~ exit4", **{**NEAR, "least": 7}), order, partial(order, bits=24))), cases=75, skills="hits in order"),
    group("origin-near", "The origin is just off a circle, inside or outside.", crowds("exit0~ enter", "enter0~ cut", "exit0~", "enter0~ exit0~", **NEAR), skills="origin on the circle"),
    group("dot-turned", "r = 0, and directions at any angle: |f|² − (f·u)² is all rounding there.", crowds("dot cut", "dot dot", "around dot", "enter2 dot2", **BIG), skills="r = 0"),
    group("lopsided", "A circle hundreds to tens of thousands of times as large as the others: its size is the figure's.", either(*[crowds("touch cut", "touch touch cut", "exit0 enter", "enter1 beside", "around touch exit2 enter2", **{**BIG, "size": 2**12, "uneven": each}) for each in (9, 14)], *[crowds("cut behind", "behind cut", "behind enter", **{**BIG, "size": 2**9, "uneven": 15})]), skills="the size of the whole"),
    group("far", "Circles a hundred to a hundred thousand times smaller than their distance.", either(crowds("speck cut", "speck speck", "tiny cut", **FAR), crowds("speck cut", "speck speck", **{**FAR, "size": 2**16, "turn": "any"}), partial(touched, drawn=pinpoint())), cases=90, skills="a tangent has a width"),
    group("direction-length", "Directions up to 1e24 times longer or shorter than the figure.", either(crowds("cut behind", "around behind", "exit2 enter2 behind", "exit0 touch", "exit0~ behind", **{**PLAIN, "shift": -17, "stretch": tuple(range(-40, 31, 10))}), crowds("cut behind", "touch~ cut", "exit0~ enter", "exit2~ enter2", **{**NEAR, "shift": -60, "stretch": (0, 40, 70, 82)}), crowds("exit0 enter", "enter0 touch", "exit0", **{**FULL, "stretch": (-60, -30, 22)})), cases=120, skills="t is not a distance"),
    group("tiny", "All of it tiny, down to 1e-29.", crowds("touch cut", "touch~ cut", "exit0 enter", "exit0~ enter", "exit2~ enter2", **TINY), skills=("no absolute epsilon", "scale invariance")),
    group("offset", "A small figure far from the plane's origin.", either(*3 * [crowds("cut cut", "around touch", "touch exit2 enter2", "exit0 enter", "touch~ cut", "exit0~ enter", "exit2~ enter2", "dot~ cut", **OFFSET)], partial(touched, drawn=astray(), times=(1, 2, 4)), tried(partial(touched, drawn=astray(times=4), times=(1, 2)), mislaid)), cases=100, skills="far from the origin"),
    group("steep", "Directions almost along an axis.", either(crowds("cut cut", "around cut", "cut behind", **ASKEW), crowds("touch cut", "cut behind", "around beside", "exit2 enter2", **STEEP), crowds("cut cut", "around beside", "dot-behind cut", **{**TILTED, "tilt": (20, 75)}), *2 * [hardly]), cases=145, skills="no slopes"),
    group("small-parts", "A coordinate, a product or the short side of a triangle is tiny beside the others, and still counts.", either(partial(touched, drawn=ratios()), *2 * [partial(touched, drawn=ratios(short=True))]), cases=120, skills="full precision"),
    group("sloping", "Rays off an axis by 1e-4 to 1e-1, whose origin is just off a circle, or that leave one just before they enter another, or just after.", either(apart, *2 * [partial(touched, drawn=sloping(end="origin"))]), cases=50, skills="no slopes"),
    group("random", "Any numbers, small and large.", either(anywhere(1000, (1, 12)), anywhere(2**30, (1, 12))), skills=("full precision", "whole numbers that are large")),
    group("large", "Whole numbers up to 2**30, with touches and ties.", crowds("touch cut", "exit2 enter2", "exit0 touch", **{**BIG, "shift": 0, "numbers": "int"}), skills=("whole numbers that are large", "scale invariance")),
    group("full", "As many circles as there may be: sixty-four.", crowd_of("cut", "cut", "around", "behind", "beside", count=(63, 63), first="cut", **PLAIN), cases=20, skills="hits in order"),
]
