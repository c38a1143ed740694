"""Two moving discs: the exact moment of their first touch."""

from fractions import Fraction
from functools import partial
from math import ldexp, sqrt, ulp

from judge.geometry import plain
from judge.geometry.hooks import hooks
from judge.geometry.motion import balls_meeting
from judge.geometry.pose import triple
from judge.geometry.scenes import ASKEW, AXIS, BIG, DECIMALS, HUGE, NEAR, OFFSET, PLAIN, STEEP, TILTED, TINY, balls, either, grid, lines, meeting, pinpoint, ratios, slivers, telling, tried, uniform, whole, sloping
from judge.geometry.scenes.bands import drifting
from judge.geometry.scenes.lines import astray
from judge.problem.declare import group

HOOKS = hooks("balls")
FULL = {**HUGE, "size": 2**36}
GRAZES = "touch before after", "touch before after rest", "touch before after along", "touch before after alone"
STARTS = "chord last after", "chord first before", "touch foot after", "chord last after rest", "chord last after dot"
ENDS = "chord before first", "touch before foot", "chord before first rest", "chord after last"
POINTS = "dot before after", "dot before after", "dot before foot", "dot before foot", "dot foot after", "dot-miss before after", "dot foot = rest"
TELLING = plain.balls_meet, partial(plain.balls_meet, tolerance=1e-10)
BELOW = [partial(plain.balls_meet, tolerance=tolerance) for tolerance in (-1e-17, -1e-10)]  # overlaps: what is equal is not below


def solve(P0, P1, r, Q0, Q1, s):
    return balls_meeting(P0, P1, r, Q0, Q1, s)


def almost_straight(draw):
    """A disc comes to one that rests, past its centre by 1e-8 to 1e-1 of the sum of the radii."""
    *C, R, A, B = lines("off-centre before after", "off-centre before foot", "off-centre before in", "flat before after", "flat before in", **FULL)(draw)
    r = R * draw.integer(0, 4) / 4
    return A, B, r, tuple(C), tuple(C), R - r


def late(draw):
    """Two points that run to one place, level with each other or on an axis or not, and rounding makes it later, or puts them beside each other."""
    P, X, r, Q, *_ = meeting(28)(draw)
    small, beside = draw.choice((-20, -20, -45)), draw.boolean()
    if beside:
        P, Q = (tuple([x / draw.integer(3, 999) for x in each]) for each in (P, Q))
    level = draw.choice((P, (0, 0), (0, 0)))
    Q = draw.choice((Q, *2 * ((level[0], Q[1]), (Q[0], level[1]))))
    P, Q = draw.choice(((P, Q), (Q, P)))
    for _ in range(12):
        Y = tuple([p + ldexp(x - p, small) * draw.integer(1, 1 << 20) for p, x in zip(P, X, strict=True)])
        (fx, dx), (fy, dy) = ((p - q, y - p - y + q) for p, y, q in zip(P, Y, Q, strict=True))
        if dx * fy != dy * fx if beside else plain.balls_meet(P, Y, r, Q, Y, r) is None:
            return P, Y, r, Q, Y, r
    return draw.reject()


def level(draw):
    """Two points that run to one place from nearly one height, or nearly above each other, and rounding puts them beside each other."""
    x, y = (draw.integer(1 << 50, 1 << 53) * draw.sign() / (1 << 26) for _ in "xy")
    p, q, far = (draw.integer(1, 1 << 52) * draw.sign() / (1 << bits) for bits in (58, 58, 34))
    turn, scale = draw.choice((1, -1)), 2.0 ** -draw.integer(0, 30)
    for _ in range(20):
        n = q + draw.integer(1, 1 << 20) * draw.sign() / (1 << 36)
        fx, fy, u, v = -far, q - n, (x - p) - (x - p - far), (y - q) - (y - n)
        if abs(u * fy - v * fx) > 2e-10 * sqrt(abs(fy) * max(abs(x), abs(y))) * abs(u):
            P, Q, X = ((a * scale, b * scale)[::turn] for a, b in ((p, q), (p + far, n), (x, y)))
            return P, X, 0, Q, X, 0
    return draw.reject()


def falling(draw):
    """Two points that run to one place, one of them, or the place, so far off along an axis that nothing else has a size."""
    far, turn, scale = draw.integer(2**26, 2**29) * draw.sign(), draw.choice((1, -1)), 2.0 ** -draw.integer(0, 40)
    at = draw.integer(0, 2)
    heights = [far if at == each else draw.integer(-9, 9) for each in range(3)]
    P, Q, X = ((draw.integer(-9, 9) * scale, y * scale)[::turn] for y in heights)
    return P, X, 0, Q, X, 0


def flat_end(draw):
    """A touch at the very end of a way that is nearly along the edge."""
    p, q, c = triple(draw, 65)
    k, a, b = draw.integer(1 << 10, 1 << 20), draw.integer(100, 1000), draw.integer(1, 3)
    Q, small = [draw.integer(-(1 << 28), 1 << 28) for _ in "xy"], 2.0 ** -draw.integer(1, 30)
    r, turn, way = draw.integer(0, c * k), draw.choice((1, -1)), draw.integer(1, k // a)
    ends = (p * k + (p * b - q * a) * way, q * k + (q * b + p * a) * way), (p * k, q * k)
    P0, P1, Q = ([x * small for x in each][::turn] for each in (*[(x + Q[0], y + Q[1]) for x, y in ends], Q))
    return tuple(P0), tuple(P1), r * small, tuple(Q), tuple(Q), (c * k - r) * small


def soon(draw):
    """A point that meets a resting one right before the end of its way, or right after the start."""
    p, q, _ = triple(draw, 65)
    at, small = 10**7 - draw.integer(3, 20), 2.0 ** -draw.integer(10, 40)
    x, y = (draw.integer(-(10**6), 10**6) for _ in "xy")
    points = (x, y), (x + p * 10**7, y + q * 10**7), (x + p * at, y + q * at)
    P0, P1, Q = (tuple([n * small for n in each]) for each in (points if draw.integer(0, 3) else (*points[1::-1], points[2])))
    return P0, P1, 0, Q, Q, 0


def landing(draw):
    """Two points that run to one place on an axis, or a hair beside it, and rounding puts them beside each other."""
    for _ in range(20):
        x, *P, a, b = (draw.integer(1, 1 << 53) * draw.sign() / (1 << 26) for _ in range(5))
        y = draw.choice((0, draw.integer(1, 1 << 20) * draw.sign() / (1 << 60)))
        fx, fy, u, v = P[0] - a, P[1] - b, (x - P[0]) - (x - a), (y - P[1]) - (y - b)
        if abs(u * fy - v * fx) > 2e-10 * sqrt(abs(y * x) * (u * u + v * v)):
            turn = draw.choice((1, -1))
            P, Q, X = ((*P,)[::turn], (a, b)[::turn], (x, y)[::turn])
            return P, X, 0, Q, X, 0
    return draw.reject()


def sliver(draw):
    """Two discs that are hardly above or beside each other at the start or at the end; one rests, or both move."""
    cx, cy, r, (px, py), (x, y) = slivers("dot", "through", *6 * ["slant"])(draw)
    more, own = draw.choice((0, 0, 1)), draw.choice((0, r / 4, r))
    u, v = more * (x - px), more * (y - py)
    if max(abs(cx + u), abs(cy + v), abs(x + u), abs(y + v)) > 2**30:
        draw.reject()
    one, other = ((px, py), (x + u, y + v), own), ((cx, cy), (cx + u, cy + v), r - own)
    return (*one, *other) if draw.boolean() else (*other, *one)


def hairline(draw):
    """Two points that run through each other off an axis by 0.6e-9 to 1e-9 of the way; one rests, or both move."""
    far, more = draw.integer(2**18, 2**20), draw.choice((0, 0, draw.integer(-3, 3)))
    hair, scale, turn = draw.integer(160, 255) * far * 2.0**-38 * draw.sign(), 2.0 ** -draw.integer(0, 40), draw.choice((1, -1))
    x, y, back, on = draw.integer(-3, 3), draw.integer(-3, 3), draw.integer(1, 3), draw.integer(1, 3)
    P0, P1, Q0, Q1 = (
        ((x + n) * far * scale, (y + n) * hair * scale)[::turn] for n in (-back, on + more * (back + on), 0, more * (back + on))
    )
    one, other = (P0, P1, 0), (Q0, Q1, 0)
    return (*one, *other) if draw.boolean() else (*other, *one)


def beside(draw, drawn):
    """The circle and the way that `drawn` draws: one of two discs rests in the centre, and the radius is that of both together."""
    cx, cy, r, A, B = drawn(draw)
    part = r * draw.integer(0, 4) / 4
    one, other = (A, B, part), ((cx, cy), (cx, cy), r - part)
    return (*one, *other) if draw.boolean() else (*other, *one)


def missed(case):
    """Whether the discs, as floats have them, pass each other."""
    P0, P1, r, Q0, Q1, s = case
    (fx, dx), (fy, dy) = ((q - p, b - p - (y - q)) for p, b, q, y in zip(P0, P1, Q0, Q1, strict=True))
    length = sqrt(dx * dx + dy * dy)
    return abs(fx * (dy / length) - fy * (dx / length)) > (r + s) * (1 + 2e-9)


def parting(draw, points):
    """Two discs that touch at the start, or two points in one place, and both move apart along one line."""
    p, q, c = triple(draw, 65)
    size, scale = 0 if points else draw.integer(1, 9), 2.0 ** -draw.integer(0, 9)
    x, y = (draw.integer(-99, 99) for _ in "xy")
    u, v = draw.choice(((p, q), (p, q), (draw.integer(-9, 9), draw.integer(-9, 9))))
    if u * p + v * q <= 0:
        draw.reject()
    back, on, r = -draw.integer(1, 9), draw.integer(1, 9), draw.integer(0, size * c)
    P0, Q0 = (x, y), (x + p * size, y + q * size)
    P1, Q1 = ((at + u * way, up + v * way) for (at, up), way in ((P0, back), (Q0, on)))
    P0, P1, Q0, Q1 = (tuple([n * scale for n in each]) for each in (P0, P1, Q0, Q1))
    one, other = (P0, P1, r * scale), (Q0, Q1, (size * c - r) * scale)
    return (*one, *other) if draw.boolean() else (*other, *one)


def rounded_apart(draw):
    """Two discs that touch at the start and move apart: the differences of their centres and the sum of the radii have more digits than a double."""
    j, scale = draw.integer(1, 3), 2.0 ** -draw.integer(36, 90)
    large, small = 4**j, 2 ** (j + 1)  # (large − 1)² + small² = (large + 1)²
    for _ in range(40):
        unit = draw.integer(2**52, 2**53 - 1) * scale
        dx, reach = large * unit - unit, large * unit + unit
        if Fraction(dx) ** 2 + Fraction(small * unit) ** 2 > (Fraction(reach) + Fraction(ulp(reach)) / 2) ** 2:
            break
    else:
        draw.reject()
    near, up = draw.choice(((0.0, small), (small, 0.0), (-small, 0.0)))
    P0, Q0 = (unit, near * unit), (large * unit, up * unit)
    turn, side, back = draw.choice((1, -1)), draw.sign(), draw.sign()
    away = [(q - p) * draw.integer(4, 99) / 16 for p, q in zip(P0, Q0, strict=True)]
    times = draw.choice((0, draw.integer(-30, 15) / 16))
    P1, Q1 = (P0[0] + times * away[0], P0[1] + times * away[1]), (Q0[0] + away[0], Q0[1] + away[1])
    P0, P1, Q0, Q1 = ((u * side + 0.0, v * back + 0.0)[::turn] for u, v in (P0, P1, Q0, Q1))
    one, other = (P0, P1, large * unit), (Q0, Q1, unit)
    return (*one, *other) if draw.boolean() else (*other, *one)


def head_on(draw):
    """Two points that run towards each other, to where the other one started and beyond or nearly, and along a diagonal or nearly."""
    scale = 2.0 ** -draw.integer(0, 30)
    x, y = (draw.integer(-999, 999) for _ in "xy")
    u, v = (draw.integer(80, 99) * draw.sign() for _ in "xy")
    apart, one, other = (draw.integer(90, 99) for _ in range(3))  # |D| is up to three times the size along each axis
    P0, P1, Q0, Q1 = (((x + u * way) * scale, (y + v * way) * scale) for way in (0, one, apart, -other))
    return P0, P1, 0, Q0, Q1, 0


def from_afar(draw):
    """A disc that rests, and another that comes along an axis from 1e5 to 1e7 radii away and touches at the very end."""
    P0, P1, r, *other = balls("chord very-far first rest", "through farther first rest", **{**FULL, "size": 2**28, "turn": "axis"})(draw)
    return *other, P0, P1, r


def in_time(P0, P1, r, Q0, Q1, s, tolerance=0):
    """Whether the quadratic's first root is not beyond 1."""
    (fx, dx), (fy, dy) = ((p - q, y - p - z + q) for p, y, q, z in zip(P0, P1, Q0, Q1, strict=True))
    a, b, k = dx * dx + dy * dy, dx * fx + dy * fy, dx * fy - dy * fx
    return (fx * fx + fy * fy - (r + s) ** 2) / (sqrt((r + s) ** 2 * a - k * k) - b) <= 1 + tolerance


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", grid("pprppr", 4), cases=180, skills="the small grid"),
    group("plain", "Both discs move, anyhow: they meet, pass each other, or stop before they meet.", either(balls("cut before after", "cut before in", "through before after", "miss before after", "cut before before", **PLAIN), balls("cut before after", "miss before after", **AXIS)), skills=("sit on one of them", "radii add", "t is not a distance")),
    group("chase", "One disc follows the other: it catches up, falls behind, or comes too late.", balls("cut before in along", "cut before before along", "cut after after along", "through before in along", **PLAIN), skills=("sit on one of them", "first in time")),
    group("away", "The discs leave each other: the touch was before the start.", balls("cut after after", "miss after after", "touch after after", "cut after after rest", "cut after -far", "cut after -far", **{**PLAIN, "shift": (0, -7, -9, -11)}), cases=80, skills="first in time"),
    group("overlap", "The discs overlap or touch from the start, whatever they do then: t = 0.", either(*4 * [balls("cut in after", "cut in in", "through foot after", "chord first in", "chord last after", "cut in =", **PLAIN)], partial(parting, points=False), partial(parting, points=True)), cases=90, skills="touching from the start"),
    group("graze", "Discs that graze each other once, or would have done so before the start or after the end.", balls("touch before after", "touch before after", "touch after after", "touch before before", **PLAIN), skills="a graze is a touch"),
    group("parallel", "Both move alike, or rest: what is apart stays so.", balls("cut in =", "miss foot =", "cut before =", "miss foot = rest", "chord first =", **PLAIN), skills="sit on one of them"),
    group("radii", "Radii of very different size, or one of 0.", balls("cut before after dot", "cut before after tiny", "cut in after dot", "miss before after dot", "cut before in tiny", **PLAIN), cases=80, skills="radii add"),
    group("points", "Both radii are 0: two points, which meet or do not.", either(balls(*POINTS, **PLAIN), balls(*POINTS, "dot~ before after", "dot before foot~", "dot foot~ after", **NEAR), balls(*POINTS, **FULL), balls("dot before foot home", "dot before after home", "dot foot after home", **{**FULL, "move": 0}), head_on), cases=125, skills="radii add"),
    group("meeting", "Both radii are 0, and both points run to one place.", either(meeting(29), meeting(29), *4 * [late], level, landing, falling), cases=270, skills="first in time"),
    group("fast", "A way of many radii: at no moment of a coarse clock the discs touch.", balls("cut far after", "through far after", "cut far -far", **PLAIN), skills="never step through"),
    group("repeated", "Neighbouring calls differ in one argument.", grid("pprppr", 4), turns=True, skills="nothing kept between calls"),
]

PRODUCTION = [  # the same, where rounding bites
    group("decimals", "Grazes in short decimals, which == does not see.", telling(balls("touch before after rest", "touch before after rest dot", "touch before after alone dot", "dot before foot rest", "dot before foot alone", **DECIMALS), *TELLING), cases=30, skills="a graze is a touch"),
    group("turned", "Grazes that squares cannot see.", balls(*GRAZES, "touch before after alone", "touch before after alone dot", "touch before after rest dot", **BIG), cases=120, skills="a tangent has a width"),
    group("graze-full", "Grazes that no formula in floats can see, or that seem to overlap.", either(telling(either(balls(*GRAZES, **FULL), balls("touch before after", "touch before after dot", **{**FULL, "turn": "axis"}), balls("touch before after alone dot", **FULL)), *TELLING), telling(balls("touch before after dot", **FULL), *BELOW), telling(balls("touch before after dot", "touch before after dot rest", **{**FULL, "turn": "axis"}), *BELOW)), cases=70, skills="a tangent has a width"),
    group("start-full", "The discs touch at the start, and rounding puts them apart.", either(*3 * [balls(*STARTS, **FULL)], rounded_apart), cases=70, skills="touching from the start"),
    group("end-full", "The discs touch at the very end, and rounding makes it later.", either(*5 * [telling(either(balls(*ENDS, **FULL), balls("chord before first", "chord before first along", "dot before foot", **{**FULL, "turn": "axis"}), balls(*ENDS, "dot before foot", "dot before foot rest", "dot before foot alone", **STEEP), balls("chord before first home", "touch before foot home", "chord before first home dot", **{**FULL, "move": 0}), flat_end), *TELLING)], telling(from_afar, in_time, partial(in_time, tolerance=1e-12))), cases=104, skills="first in time"),
    group("head-on", "One disc comes to the other almost straight.", almost_straight, cases=90, skills="full precision"),
    group("near-graze", "Nearly a graze: 1e-7 of the figure away.", balls("touch~ before after", "touch~ before after rest", "touch~ before after along", "touch~ before after rush", "touch~ before after rush", **{**NEAR, "least": 7}), skills="nearly is not touching"),
    group("near-start", "The discs nearly touch at the start, and come together or leave each other.", balls("chord last~ after", "chord first~ before", "chord first~ in", "chord last~ after rest", **{**NEAR, "least": 7}), skills="touching from the start"),
    group("near-end", "The discs touch just before the end, or do not quite.", either(balls("chord before first~", "chord before first~ rest", "chord after -last~", **{**NEAR, "least": 7}), balls("chord before first~", "dot before foot~", **{**NEAR, "shift": (-60, -40, 17)}), soon), cases=100, skills="first in time"),
    group("slow", "The discs go far together, and hardly move as seen from each other.", balls("cut before in together", "cut before after together", "touch before after together", "cut before before together", **{**PLAIN, "shift": -20}), skills="t is not a distance"),
    group("long-way", "A way of up to a million radii.", balls("cut very-far after", "touch very-far after", "through far after", "dot before after rest grain", "chord very-far last", "chord very-far last", "chord far last", **{**PLAIN, "shift": -20}), cases=60, skills="never step through"),
    group("grain", "Discs so small beside the way that they are hardly hit.", either(*5 * [balls("dot before foot rest grain", "dot before foot grain", **{**PLAIN, "shift": -20})], tried(partial(beside, drawn=pinpoint()), missed)), cases=120, skills="full precision"),
    group("rush", "The discs run towards each other and beyond: t is known to a few parts in 1e10.", balls("cut before after rush", "cut before after rush", "through before after rush", **PLAIN), skills="full precision"),
    group("small-parts", "A part that is 1e-9 to 1e-1 of another one, and counts.", either(drifting, partial(beside, drawn=ratios(short=True))), cases=150, skills="full precision"),
    group("tiny", "All of it tiny, down to 1e-29.", balls("touch before after", "touch~ before after", "chord before first~", "chord last~ after", **TINY), skills=("no absolute epsilon", "scale invariance")),
    group("offset", "Small discs far from the plane's origin.", either(*3 * [balls("touch before after", "cut before after", "chord before first", "chord last after", **OFFSET)], partial(beside, drawn=astray())), cases=80, skills="far from the origin"),
    group("offset-near", "Nearly a touch at the start, on the way or at the end, far from the plane's origin.", balls("touch~ before after", "chord before first~", "chord last~ after", "dot~ before after", "dot before foot~", "dot foot~ after", **OFFSET), skills="far from the origin"),
    group("steep", "Ways almost along an axis.", either(balls("cut before after", "cut before in", "cut before after rest", **ASKEW), balls("touch before after", "cut before in", "cut before after", "miss before after", **STEEP), balls("dot after after", "cut before after", "miss before after", "cut after after", **TILTED), *2 * [sliver], hairline), cases=155, skills="no slopes"),
    group("sloping", "Ways off an axis by 1e-4 to 1e-1, which begin or end just off a touch: 1e-7 to 1e-6 of the figure.", partial(beside, drawn=sloping(end="last")), cases=60, skills="no slopes"),
    group("random", "Any numbers, small and large.", uniform("pprppr", 20, 1e4, 1e9), skills="full precision"),
    group("large", "Whole numbers up to 2**30, some of them grazes.", either(whole("pprppr", 30), balls(*GRAZES, "cut before in", **{**BIG, "shift": 0, "numbers": "int"})), skills=("whole numbers that are large", "scale invariance")),
]
