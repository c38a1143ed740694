"""What of a ray is inside a solid made of discs: exact intervals."""

from functools import partial
from math import hypot, sqrt

from judge.geometry import Crowd, plain
from judge.geometry.crowd import DIFFERENCE, INTERSECTION, UNION
from judge.geometry.hooks import hooks
from judge.geometry.pose import triple
from judge.geometry.scenes import ASKEW, BIG, DECIMALS, FAR, HUGE, LEVEL, NEAR, OFFSET, PLAIN, STEEP, TILTED, TINY, aimed, aligned, anywhere, crowd_of, crowds, either, hardly, lines, pinpoint, ratios, sloping, solids, telling
from judge.geometry.scenes.crowds import apart, mixed
from judge.geometry.scenes.lines import astray
from judge.problem.declare import group

HOOKS = hooks("spans")
FULL = {**HUGE, "size": 2**36}
OVERLAP = "cut cut", "enter1 exit3 enter2", "cut1 enter2 cut3", "around cut exit2"
ABUT = "exit2 enter2", "exit3 exit3 enter1", "enter2 enter2", "exit2 enter2 enter2", "enter1 copy exit2"
BARE = "exit2 enter2 about", "enter2 enter2 about", "exit2 enter2 dot5", "enter2 enter2 dot5", "exit2 enter2 dot5 about"
HOLES = "around enter1 exit3 cut5", "around exit1 enter2 exit4"
TELLING = plain.spans, partial(plain.spans, tolerance=1e-10)


def solve(circles, O, D, program):
    return Crowd(circles, O, D).spans(program)


def cuts(circles, O, D, _program, slack=0):
    """Which circles a direction of length 1 cuts."""
    n = hypot(*D)
    return [abs(D[0] / n * (y - O[1]) - D[1] / n * (x - O[0])) < r - slack * r for x, y, r in circles]


def passed(draw):
    """Discs, one of which the ray passes where another one nearly begins or ends."""
    circles, O, D = crowds("enter1 beside1", "exit1 beside1", "enter1 beside1 around", "cut1 exit3 beside3", **{**NEAR, "turn": "axis"})(draw)
    gap = draw.choice((draw.integer(102, 116), draw.integer(300, 600))) / 10**11 * max(max(map(abs, each)) for each in circles) * draw.sign()
    return tuple([(x + gap * bool(D[0]), y + gap * bool(D[1]), r) if abs(y if D[0] else x) > r else (x, y, r) for x, y, r in circles]), O, D


def ahead(draw):
    """A disc that begins or ends just after the ray's origin or just before, and the ray goes through its centre."""
    ((x, y, r),), O, D = crowds("about", **NEAR)(draw)
    times = r * draw.sign() * (1 + draw.integer(101, 150) / 10**9 * draw.sign()) / hypot(*D)
    return ((x + times * D[0], y + times * D[1], r),), O, D, (0,)


def bored(draw):
    """A disc about the ray's origin, less one that begins there."""
    (hole,), O, D = aligned(draw.choice((20, 2**28)), (1, 1))(draw)
    return ((*O, 3 * hole[2]), hole), O, D, (0, 1, -3)


def leaving(draw, along):
    """A disc that the ray leaves or enters at its origin, almost through its centre, or `along` its edge and a million times as large as another one."""
    disc, (x, y), _ = aligned(2**28, (1, 1))(draw)
    D = draw.sign(), (draw.integer(900, 2200) if along else draw.integer(2**20, 2**25)) * draw.sign()
    small = disc[0][2] >> draw.integer(16, 20)
    if (disc[0][1] == y) is along:
        return (*disc, *[(x, y + small * draw.integer(-2, 2), small)] * along), (x, y), D
    return (*disc, *[(x + small * draw.integer(-2, 2), y, small)] * along), (x, y), D[::-1]


def beads(draw, bored=False):
    """Discs in a row that do not meet, most of them with a smaller one inside: the union of all, in any order; or
    a disc about all of them less that union.
    """
    discs, axis = [], draw.sign()
    for at in range(draw.integer(9, 10) if bored else draw.integer(5, 6)):
        x, y, r = 100 * at + draw.integer(60, 70), draw.integer(-9, 9), draw.integer(25, 29)
        discs += [(x, y, r), (x + draw.integer(-5, 5), y, draw.integer(12, 18))][: 1 + (not bored and draw.integer(0, 3) > 0)]
    discs = [*mixed(draw, discs), *[(500, draw.integer(-9, 9), 600)] * bored]
    O, D = (draw.integer(-9, 9), draw.integer(-9, 9)), (draw.integer(1, 9), 0)
    all_ = [0, *[step for disc in range(1, len(discs) - bored) for step in (disc, UNION)]]
    program = (len(discs) - 1, *all_, DIFFERENCE) if bored else tuple(all_)
    return tuple([(*(x, y)[::axis], r) for x, y, r in discs]), O[::axis], D[::axis], program


def touched(draw, drawn, alike=False):
    """The disc and the ray along the line that `drawn` draws: nothing; or with a second disc about the same centre, which may be no larger."""
    cx, cy, r, O, D = aimed(drawn)(draw)
    program = draw.choice(((0,), (0,), (0, 1, UNION)) if alike else ((0,), (0,), (0, 1, UNION), (1, 0, DIFFERENCE), (0, 1, INTERSECTION), (0, 1, DIFFERENCE)))
    times = 1 if alike else draw.choice((2, 3, 5))
    if r * times > 2**30:
        draw.reject()
    return ((cx, cy, r), (cx, cy, r * times))[: len(program)], O, D, program


def strings(draw, kind):
    """Two solids of two to ten pieces each, in one row of slots: some discs are in both, or a second disc like one of
    the first overlaps it, is inside it, reaches into the next slot, or is elsewhere. Of the kinds, "self" takes a
    solid with itself, "none" an empty one less a solid, "all" a disc about all of them, "origin" has the ray begin in
    both, "pair" are two pieces that begin alike, "more" are nine or ten.
    """
    count = {"pair": 2, "more": draw.integer(9, 10), "origin": draw.integer(2, 5)}.get(kind, draw.integer(3, 9))
    start = 0 if kind == "origin" else draw.integer(0, 1)
    discs, one, other = [], [], []

    def disc(x, y, r):
        discs.append((x, y, r))
        return len(discs) - 1

    for at in range(start, start + count):
        x, y, r = 100 * at + draw.integer(-9, 9), draw.integer(-9, 9), draw.integer(25, 29)
        one.append(disc(x, y, r))
        how = draw.integer(0, 5)
        if kind == "pair" and at == start:
            other.append(draw.choice((one[-1], disc(x, y, r))))
        elif how == 0:
            other.append(one[-1])
        elif how == 1:
            other.append(disc(x, y, r + draw.integer(-8, 8)))
        elif how == 2 and kind not in ("origin", "pair"):
            other.append(disc(x + 50, y, draw.integer(12, 14) + draw.integer(0, 1) * 40))
        else:
            other.append(disc(x + draw.integer(4, 20) * draw.sign(), draw.integer(-9, 9), draw.integer(25, 29)))
    step = draw.choice((DIFFERENCE, INTERSECTION))
    solids = [_joined(mixed(draw, each)) for each in (one, other)]
    if kind == "self":
        solids, step = [solids[0], draw.choice((solids[0], _joined(mixed(draw, one))))], draw.choice((step, *5 * [DIFFERENCE]))
    elif kind == "none":
        beside, touch = disc(300, 60, 20), disc(200, 70, 70)
        solids[0], step = draw.choice(((beside,), (touch,), (one[0], one[0], DIFFERENCE))), draw.choice((UNION, *5 * [DIFFERENCE]))
    elif kind == "all":
        solids[0] = (disc(500, draw.integer(-9, 9), 700),)
    elif kind == "origin":
        step = draw.choice((step, *3 * [UNION]))
    elif kind == "pair":
        step = draw.choice((step, *3 * [DIFFERENCE]))
    elif kind == "more":
        step = draw.choice((step, INTERSECTION))
    if kind != "none" and draw.boolean():
        solids.reverse()
    axis = draw.choice((1, -1))
    O, D, turn = (0 if kind == "origin" else draw.integer(-9, 9), 0), (draw.integer(1, 9), 0), draw.sign()
    return tuple([(*(x * turn, y)[::axis], r) for x, y, r in discs]), (O[0] * turn, 0)[::axis], (D[0] * turn, 0)[::axis], (*solids[0], *solids[1], step)


def _joined(discs):
    return (discs[0], *[step for disc in discs[1:] for step in (disc, UNION)])


def seam(draw):
    """Two discs that begin or end at one place, 1.05e-7 to 9e-6 of the figure from the ray's origin, and floats put the ends more than 1e-9 of that way apart."""
    (p, q, c), k = triple(draw, 65), draw.integer(1, 9)
    x, y = (draw.integer(-99, 99) for _ in "xy")
    turn, back, scale, way = draw.choice((1, -1)), draw.sign(), 2.0 ** -draw.integer(6, 60), c * k
    for _ in range(60):
        discs, ends, ahead = [], [], []
        for size in (draw.integer(10**6, 8 * 10**6), draw.choice((draw.integer(10**6, 8 * 10**6), draw.integer(2, 9)))):
            u, v, w = triple(draw, 4_418)
            n = size * way // w + 1
            a, b, r = p * k + u * n * draw.sign(), q * k + v * n * draw.sign(), w * n
            foot, off = p / c * a + q / c * b, p / c * b - q / c * a
            half = sqrt(max(0, (r - abs(off)) * (r + abs(off))))
            discs.append((x + a, y + b, r))
            ends.append(min(foot - half, foot + half, key=lambda at: abs(at - way)))
            ahead.append(foot > way)
        if abs(ends[0] - ends[1]) > 1.2e-9 * way:
            break
    else:
        draw.reject()
    program = draw.choice((UNION, INTERSECTION) if ahead[0] != ahead[1] else (DIFFERENCE,))
    rows = [(*(a * scale * back, b * scale)[::turn], r * scale) for a, b, r in discs]
    return mixed(draw, rows), (x * scale * back, y * scale)[::turn], (p * back, q)[::turn], draw.choice(((0, 1, program), (1, 0, program)))


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", solids(anywhere(3, (2, 3))), cases=120, skills="the small grid"),
    group("union", "Discs that overlap, or do not: their union has no seams.", either(*3 * [solids(crowds(*OVERLAP, "cut1 cut5 beside", "cut room cut", "cut within exit2", **PLAIN), "union")], beads), cases=75, skills="a solid is intervals"),
    group("intersection", "What all of the discs hold, which may be nothing.", solids(crowds(*OVERLAP, "enter1 exit3", "cut1 cut9", "around around", **PLAIN), "intersection"), skills="a solid is intervals"),
    group("difference", "A disc less others: an end is cut off, or a hole is in the middle.", solids(crowds(*OVERLAP, "around around", "cut room", "around cut within", **PLAIN), "difference"), skills="a solid is intervals"),
    group("deep", "All three operations, nested, with up to twenty discs, some of them used twice.", either(*5 * [solids(crowd_of("cut", "enter", "exit", "around", "beside", count=(2, 11), first="cut1", **PLAIN), form="tree")], *[partial(strings, kind=each) for each in ("any", "self", "none", "none", "all", "origin", "origin", "pair", "pair", "more", "more")]), cases=180, skills="operations in any nesting"),
    group("inside", "The ray begins inside discs, and leaves others behind it: a span begins at t = 0.", solids(crowds("around behind cut", "around around behind", "around cut", "around exit1 behind", **PLAIN)), skills="origin inside"),
    group("touch", "Discs that the ray only touches: they hold nothing of it and take nothing away.", solids(crowds("cut touch", "touch around", "enter1 exit3 touch2", "touch0 cut", "touch touch", **PLAIN)), skills="collapse the tangent"),
    group("holes", "A large disc less the union of several small ones: several holes in one interval.", either(*3 * [solids(crowd_of("enter", "exit", "cut", count=(2, 5), first="around", **PLAIN), form="holes")], partial(beads, bored=True)), cases=75, skills="a solid is intervals"),
    group("radius-zero", "Discs of radius 0: points, which hold nothing.", solids(crowds("dot0 dot0", "cut dot", "dot enter", "around dot2", "dot0 enter", "dot dot", **PLAIN)), skills="r = 0"),
    group("repeated", "Neighbouring calls differ in one argument.", solids(anywhere(4, (2, 3))), turns=True, skills="nothing kept between calls"),
]

PRODUCTION = [  # the same, where rounding bites
    group("decimals", "Touches in short decimals, which == does not see.", either(telling(solids(crowds("touch cut", "touch touch", "cut touch touch", **DECIMALS)), *TELLING), telling(solids(crowds("touch0", "touch0", "touch0 cut", **DECIMALS)), *TELLING)), cases=60, skills="collapse the tangent"),
    group("abut", "Discs that begin where others end: no seam and no sliver is left.", telling(solids(crowds(*ABUT, **BIG)), *TELLING), skills="no slivers"),
    group("abut-full", "The same, where floats put the ends in order.", either(*3 * [telling(solids(crowds(*ABUT, *BARE, **FULL)), *TELLING)], telling(solids(crowds("exit1 enter1", **{**FULL, "size": 2**20, "uneven": 14}), "intersection"), *TELLING), *2 * [telling(solids(crowds("exit1 enter1", **{**FULL, "size": 2**18, "uneven": 20}), "intersection"), *TELLING)]), cases=150, skills="no slivers"),
    group("origin-full", "The ray begins where a disc ends or begins.", telling(either(solids(crowds("exit0 enter0", "exit0 enter", "enter0 exit2", "exit0 around", "exit0 enter0 about", "exit0 enter dot5", **FULL)), *2 * [solids(either(aligned(20, (2, 3)), aligned(2**28, (2, 3))))], bored, *[telling(solids(partial(leaving, along=each)), *TELLING) for each in (True, False)]), *TELLING), cases=140, skills="no slivers"),
    group("touch-full", "Touches that floats take for short chords.", either(solids(crowds("touch cut", "touch touch", "around touch", "dot cut", "around dot dot", "dot0 enter", "touch0", "touch0 cut", **FULL)), telling(solids(crowds("touch0", "touch0", "touch0 touch0", **FULL)), cuts, partial(cuts, slack=1e-10))), cases=105, skills="a tangent has a width"),
    group("off-centre", "Rays past the centre by 1e-8 to 1e-1 of the radius, and chords that bend by 2e-6 to 2e-4 of it.", partial(touched, drawn=lines("off-centre before foot", "off-centre in foot", "flat before foot", "flat in foot", **HUGE)), cases=100, skills="full precision"),
    group("near-ties", "Ends nearly at one place: what is between them counts.", either(solids(crowds("exit2~ enter2", "enter2 enter2~", "exit2~ exit2", "exit0~ enter", **NEAR)), *2 * [ahead], solids(crowds("enter0~", "enter0~ cut", "exit0~", **NEAR)), solids(crowds("enter2 enter2~", "exit2~ exit2", **NEAR), "difference"), solids(crowds("exit2~ enter2", **NEAR), "intersection"), solids(crowds("around exit2~ enter2", **NEAR), form="holes")), cases=190, skills="nearly is not touching"),
    group("near-touch", "Nearly a touch: a short chord, or nothing.", solids(crowds("touch~ cut", "touch~ touch~", "around touch~", **{**NEAR, "least": 7})), skills="nearly is not touching"),
    group("specks", "Discs a hundred to a hundred thousand times smaller than their distance.", either(*3 * [solids(crowds("speck cut", "speck speck", "tiny cut", "tiny tiny", **{**FAR, "size": 2**16, "turn": "any"}))], *2 * [partial(touched, drawn=pinpoint(), alike=True)]), cases=100, skills=("a tangent has a width", "the size of the whole")),
    group("lopsided", "A disc hundreds to tens of thousands of times as large as the others: its size is the figure's.", either(solids(either(*[crowds("enter1 beside", "exit1 enter2 around", "exit2 enter2 beside", "around cut cut", **{**BIG, "size": 2**12, "uneven": each}) for each in (9, 14, 20)])), *[solids(crowds(*HOLES, **{**BIG, "size": 2**12, "uneven": each}), form="holes") for each in (5, 9, 20)], solids(crowds("cut1 beside1", "cut1 beside1 cut4", **{**BIG, "size": 2**12, "uneven": 20})), *3 * [solids(passed)]), cases=170, skills="the size of the whole"),
    group("near-seam", "Discs a million times as large as the way from the ray's origin to where they meet: no seam and no sliver is left.", seam, cases=22, skills="no slivers"),
    group("stacked", "Programs that put up to 32 discs on the stack before the first operation.", solids(crowd_of("cut", "enter", "around", count=(19, 31), first="cut1", **PLAIN), form="stack"), cases=40, skills="operations in any nesting"),
    group("direction-length", "Directions up to 1e24 times longer or shorter than the figure.", either(solids(either(crowds("cut behind", "around cut", "exit2 enter2", "around exit2", **{**PLAIN, "shift": -17, "stretch": tuple(range(-40, 31, 10))}), crowds("around cut", "touch~ cut", "exit0~ enter", "exit2~ enter2", **{**NEAR, "shift": -60, "stretch": (0, 40, 70, 82)}))), solids(crowds(*HOLES, **{**PLAIN, "shift": -60, "stretch": (70, 82)}), form="holes"), telling(solids(crowds("exit0 enter0", "exit0 enter", *ABUT, **{**FULL, "stretch": (-60, -30, 22)})), *TELLING)), cases=90, skills="t is not a distance"),
    group("tiny", "All of it tiny, down to 1e-29.", either(solids(crowds("touch cut", "touch~ cut", "exit2 enter2", "exit2~ enter2", **TINY)), solids(crowds("cut cut", "exit2~ enter2", **TINY), "intersection")), cases=80, skills=("no absolute epsilon", "scale invariance")),
    group("offset", "A small figure far from the plane's origin.", either(*[solids(crowds("cut cut", "around touch", "exit2 enter2", "around cut exit2", "touch~ cut", "exit0~ enter", "exit2~ enter2", **OFFSET))] * 3, solids(crowds(*HOLES, **OFFSET), form="holes"), solids(crowds("cut cut", "around cut", **LEVEL)), *2 * [partial(touched, drawn=astray())]), cases=120, skills="far from the origin"),
    group("steep", "Directions almost along an axis.", solids(either(crowds("cut cut", "around cut", "cut behind", **ASKEW), crowds("touch cut", "around behind", "cut cut", "exit2 enter2", **STEEP), crowds("cut cut", "around behind", "dot-behind cut", **{**TILTED, "tilt": (20, 75)}), *3 * [hardly])), cases=175, skills="no slopes"),
    group("small-parts", "A coordinate, a product or the short side of a triangle is tiny beside the others, and still counts.", either(partial(touched, drawn=ratios()), *2 * [partial(touched, drawn=ratios(short=True))]), cases=120, skills="full precision"),
    group("sloping", "Rays off an axis by 1e-4 to 1e-1, whose origin is just off a disc, or with a gap or a seam of 1e-7 to 1e-6 of the figure.", either(*4 * [solids(apart)], partial(touched, drawn=sloping(end="origin"))), cases=38, skills="no slopes"),
    group("random", "Any numbers, small and large.", solids(either(anywhere(1000, (2, 12)), anywhere(2**30, (2, 12))), form="tree"), skills=("full precision", "whole numbers that are large")),
    group("large", "Whole numbers up to 2**30, with touches and common ends.", solids(crowds("touch cut", "exit2 enter2", "around exit2", **{**BIG, "shift": 0, "numbers": "int"})), skills=("whole numbers that are large", "scale invariance")),
]
