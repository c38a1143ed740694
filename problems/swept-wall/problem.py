"""A moving disc and a wall: the exact moment of their first touch."""

from functools import partial
from itertools import chain
from math import copysign, hypot, ldexp, sqrt

from judge.geometry import plain
from judge.geometry.hooks import hooks
from judge.geometry.motion import wall_meeting
from judge.geometry.pose import triple
from judge.geometry.scenes import ASKEW, AXIS, BIG, DECIMALS, HUGE, NEAR, OFFSET, PLAIN, STEEP, TILTED, TINY, either, grid, lines, meeting, slivers, telling, uneven, uniform, walls, whole, sloping
from judge.geometry.scenes.bands import driven
from judge.problem.declare import group

HOOKS = hooks("wall")
BIGGER = {**BIG, "size": 2**14}
FULL = {**HUGE, "size": 2**34}
CLEAR = {**NEAR, "least": 7}
AFAR = {**NEAR, "size": 2**8, "move": 30}
GRAZES = "graze cap", "graze post"
TELLING = plain.wall_meet, partial(plain.wall_meet, tolerance=1e-10)


def solve(P0, P1, r, A, B):
    return wall_meeting(P0, P1, r, A, B)


def almost_straight(draw):
    """A disc comes to the end of a wall that goes on as its way does, past it by 1e-8 to 1e-1 of the radius."""
    cx, cy, r, A, B = lines("off-centre before after", "off-centre before foot", "off-centre before in", "flat before after", "flat before in", **FULL)(draw)
    ends = [(cx, cy), (cx + B[0] - A[0], cy + B[1] - A[1])]
    return A, B, r, *ends[:: draw.choice((1, -1))]


def ending(draw):
    """A point that begins or ends its way at an end of the wall, level with it or with all to its sides."""
    P, X, r, Q, *_ = meeting(28)(draw)
    if draw.boolean():
        P, Q = (tuple([x + side * abs(n - x) for n, x in zip(each, X, strict=True)]) for each, side in ((P, draw.sign()), (Q, draw.sign())))
    if draw.boolean():
        P = (P[0], X[1]) if draw.boolean() else (X[0], P[1])
    return *draw.choice(((P, X), (X, P))), r, *draw.choice(((Q, X), (X, Q)))


def narrow(draw):
    """A point whose way leaves an axis by 1e-9 to 1e-4 ends at an end of a wall, which is slanting or much longer and nearly level; or one that rests beside a long wall."""
    far, kind = draw.integer(11, 99) * 10 ** draw.choice((3, 5, 6, 7, 7, 7, 7)), draw.choice((0, 0, 1, 1, 2, 3, 3))
    high, way = draw.integer(1, 9), far // 10 ** draw.integer(1, 5) * draw.sign()
    part = draw.choice((1, far // draw.integer(10, 10**3)))
    P0, X = (
        ((far, high), (draw.integer(1, 9) * part, draw.integer(1, 9) * part * draw.sign())),
        ((way, high), (far, draw.choice((0, far // 10 ** draw.integer(2, 4) * draw.sign())))),
        ((draw.integer(0, 10**3), high), (far, draw.integer(-9, 9))),
        ((-high, far), (far * draw.integer(1, 9) // draw.choice((1, 10)), 0)),
    )[kind]
    size, away = max(map(abs, (*P0, *X))), abs(P0[0] * X[1] - P0[1] * X[0]) / hypot(*X)
    if away < 1.2e-7 * size or size > 2**30:
        draw.reject()
    turn, x, y, scale = draw.choice((1, -1)), draw.sign(), draw.sign(), 2.0 ** -draw.choice((0, 20, 60))
    P0, X, end = ((a * x * scale + 0.0, b * y * scale + 0.0)[::turn] for a, b in (P0, X, (0, 0)))
    r = draw.choice((0, 0, away * scale * draw.integer(10, 90) / 100)) if kind == 2 else 0
    return P0, P0 if kind == 2 else end, r, *((X, end) if draw.boolean() else (end, X))


def resting(draw):
    """A point that rests at an end of the wall, or goes from there to the other one."""
    _, X, r, Q, *_ = meeting(28)(draw)
    return X, draw.choice((X, Q, Q)), r, *draw.choice(((X, Q), (Q, X)))


def late(draw):
    """A point that ends its way at an end of the wall, and rounding makes the touch later."""
    P0, P1, *wall = ending(draw)
    for _ in range(12):
        n = draw.integer(1, 1 << 20) / (1 << 20)
        begin = tuple([q + n * (p - q) for p, q in zip(P0, P1, strict=True)])
        if plain.wall_meet(begin, P1, *wall) is None:
            return begin, P1, *wall
    return draw.reject()


def late_way(draw, shift):
    """A way whose square over itself, twice, is above 1 in floats."""
    ways = (ldexp(draw.integer(1 << 52, 1 << 53), shift) for _ in range(99))
    return next((x for x in ways if x * x / x / x > 1), None) or draw.reject()


def head_on(draw):
    """A point that comes to an end of the wall in line with it, along an axis or any way."""
    if draw.integer(0, 2) == 0:
        return mirrored(draw, 0, (-late_way(draw, -27), 0.0), (0.0, 0.0), (0.0, 0.0), (ldexp(draw.integer(1 << 52, 1 << 53), -27), 0.0))
    for _ in range(draw.choice((1, 50))):
        p, q, m, n = (draw.integer(1 << 13, 1 << 15) for _ in range(4))
        wall = n * sqrt(p * p + q * q)
        height, pace = (n * p / wall * (k * q) - n * q / wall * (k * p) for k in (m + n, m))
        if pace and 1 < height / pace < 1 + n / m:  # as rounding sees it, the wall's line is crossed after the end
            break
    return mirrored(draw, 0, (-m * p, -m * q), (0, 0), (0, 0), (n * p, n * q))


def leaving(draw):
    """A disc that passes an end of the wall, and touches it again at the very end of its long way."""
    p, q, c = triple(draw, 65)
    k, scale = draw.integer(1, 1 << 10), 2.0 ** draw.integer(-40, -12)
    x, y, r, way, wall = (n * k * scale for n in (p, q, c, c * draw.integer(1000, 10**5), c * draw.integer(1, 99)))
    return mirrored(draw, r, (x - way, y), (x, y), (0.0, 0.0), draw.choice(((0.0, -wall), (0.0, 0.0))))


def slipping(draw):
    """A point that comes to B, level with an end: as rounding sees it, past B from the cap, short of B from the side."""
    _, B, r, A, *_ = meeting(28)(draw)
    wx, wy, axis, level = B[0] - A[0], B[1] - A[1], draw.integer(0, 1), draw.choice((A, B))
    wall = hypot(wx, wy) or draw.reject()
    ux, uy = wx / wall, wy / wall
    for _ in range(20):
        P = list(level)
        P[axis] = copysign(ldexp(draw.integer(0, 1 << 53), draw.integer(-40, -25)), (wx, wy)[axis])
        (fx, fy), (dx, dy) = ([n - m for m, n in zip(*each, strict=True)] for each in ((A, P), (P, B)))
        x, y, u, v = fx * ux + fy * uy - wall, ux * fy - uy * fx, dx * ux + dy * uy, ux * dy - uy * dx
        if u < 0 != v and -(x * u + y * v) / hypot(u, v) / hypot(u, v) > -x / u > -y / v:
            return tuple(P), B, r, A, B
    return draw.reject()


def beside(drawn):
    """A way that ends in touch and begins level with its end, or with an end of the wall, and rounding makes the touch later."""

    def draw_case(draw):
        P0, *rest = drawn(draw)
        P1, _, A, B = rest
        for _ in range(20):
            n = draw.choice((0, draw.integer(-64, 64) / 64))
            other = draw.choice((P1, A, B) if n else (A, B))
            x, y = (q + n * (p - q) for p, q in zip(P0, P1, strict=True))
            begin = (other[0], y) if draw.boolean() else (x, other[1])
            if plain.wall_meet(begin, *rest) is None:
                return begin, *rest
        return draw.reject()

    return draw_case


def back(drawn):
    """The way goes on from where that of another case ends, or goes it back."""

    def draw_case(draw):
        P0, P1, *wall = drawn(draw)
        times = draw.integer(1, 40)
        return P1, draw.choice((P0, tuple([q + times * (q - p) for p, q in zip(P0, P1, strict=True)]))), *wall

    return draw_case


def parallel(draw):
    """A way parallel to the wall that begins right above or beside an end of it."""
    x, y, u, v, h = (draw.integer(-99, 99) for _ in range(5))
    z, w = draw.choice(((x + h, y), (x, y + h)))
    times = draw.integer(-3, 3)
    return (z, w), (z + times * u, w + times * v), draw.choice((0, draw.integer(0, abs(h)))), *draw.choice((((x, y), (x + u, y + v)), ((x + u, y + v), (x, y))))


def upright(draw, stops=False):
    """A graze along an axis, at which the height times the way through the way is not the height in floats."""
    bits, seems = draw.integer(-28, -12), draw.sign()
    x, end = (ldexp(draw.integer(1 << 27, 1 << 30), bits) for _ in range(2))
    x, end = (late_way(draw, bits - 23), 0.0) if stops else (x, draw.choice((0.0, end)))  # to the graze, or on
    heights = (ldexp(draw.integer(1 << 28, 1 << 31), bits) for _ in range(99))
    height = next((r for r in heights if (r * (x + end) / (x + end) - r) * seems > 0), None) or draw.reject()
    k = ldexp(1.0, draw.integer(-6, 6))
    over, level, down, post = (-x, -height * k), (-x * k, -height), (0.0, -height * k), (0.0, 0.0)
    other = draw.choice((over, over, over, level, level, (x * k, -height * k), (-height * k, -x * k), post, post, *[down] * (4 if stops else 1)))
    return mirrored(draw, height, (-x, height), (end, height), (0.0, 0.0), other)


def abreast(draw):
    """A disc that touches an end of the wall from level with it at the start, and seems apart in the wall's frame."""
    r, x, y = (ldexp(draw.integer(1 << 52, 1 << 53), -24) for _ in range(3))
    walls = ([ldexp(draw.integer(1 << 52, 1 << 53), -24) for _ in range(2)] for _ in range(40))
    u, v = next((w for w in walls if hypot(w[0] / hypot(*w) * r, w[1] / hypot(*w) * r) > r), None) or draw.reject()
    return mirrored(draw, r, (r, 0.0), (r + x, y), (0.0, 0.0), (-u, v))


def squared(x, y):
    """A length by its squares, which may differ from hypot in the last bit."""
    return sqrt(x * x + y * y)


def sinking(draw):
    """A disc that slides all along the wall, and as rounding sees it in the wall's frame comes down on it at another time."""
    norm = draw.choice((hypot, squared))
    for _ in range(400):
        p, q, c = triple(draw, 4_418)
        k, before, wall = (ldexp(draw.integer(1, 1 << bits), -10) for bits in (10, 20, 20))
        after = wall + before
        points = (-before * p - k * q, k * p - before * q), (after * p - k * q, k * p + after * q), (0.0, 0.0), (wall * p, wall * q)
        length = norm(wall * p, wall * q)
        m, n, (x, y), way = wall * p / length, wall * q / length, points[0], before + after
        height, rise = m * y - n * x, m * (way * q) - n * (way * p)
        if height > c * k and rise < -1e-16 * (after * max(p, q) + k * c) and 0 < (height - c * k) / -rise * way - before < wall:
            return mirrored(draw, c * k, *points)
    return draw.reject()


def tangent(draw):
    """A graze of the end of a wall from right above or beside it."""
    p, q, c = triple(draw, 65)
    k = draw.integer(1 << 20, 1 << 31)
    far = k * q // c + draw.integer(1, k)
    B = draw.integer(0, 1 << 36), draw.integer(0, 1 << 36)
    points = (0, c * k), (p * far, c * k - q * far), (0, 0), (-B[0], -B[1])
    small = ldexp(1.0, draw.integer(-30, -10))
    return mirrored(draw, k * p * small, *[(x * small, y * small) for x, y in points])


def past(draw):
    """A disc that begins just past an end of a long wall, within its radius of the wall's line, and clear of the end."""
    p, q, c = triple(draw, 65)
    b, h, i, j = draw.integer(8, 99), draw.integer(0, 99), draw.integer(-16, 16), draw.integer(-16, 16)
    part, r = b * draw.integer(20, 200), h + (sqrt(b * b + h * h) - h) * draw.integer(1, 7) / 8
    i, j = draw.choice(((0, 0), (i, j), (i, j)))
    points = (b, h), (b + i * part, h + j * part), (0, 0), (-16 * part, 0)
    small = 2.0 ** draw.integer(-20, 4)
    return mirrored(draw, r * c * small, *[((x * p - y * q) * small, (x * q + y * p) * small) for x, y in points])


def turned(draw, r, *points):
    """The points, in whole numbers, turned by any angle, scaled and mirrored."""
    p, q, c = triple(draw, 4_418)
    small = 2.0 ** (28 - max(map(abs, chain(*points, (r,)))).bit_length() - c.bit_length() - draw.integer(0, 9))
    return mirrored(draw, r * c * small, *[((x * p - y * q) * small, (x * q + y * p) * small) for x, y in points])


def soon(draw):
    """A disc that grazes an end right after the start, or a point that runs into one."""
    if draw.boolean():
        end = draw.integer(2, 9), 0
        return turned(draw, 0, (0, 0), (10**7, 0), end, draw.choice((end, (draw.integer(-(10**6), 10**6), draw.integer(10**3, 10**6)))))
    h = draw.integer(8000, 12000)
    return turned(draw, h, (-draw.integer(6, 12), h), (draw.integer(99, h // 2), h), (0, 0), (draw.integer(-h, h) // 2, -draw.integer(0, h) // 2))


def creeping(draw):
    """A disc whose way is hardly more than e/1000, to the side of a wall, an end of it or a post."""
    reach, way, up, down = 10**6, draw.integer(1050, 1090), draw.integer(10**3, 10**5), draw.integer(0, 10**5)
    r = reach - draw.integer(100, way - 100)
    wall = draw.choice((((reach, 0), (reach, 0)), ((reach, -down), (reach, up)), ((reach, 0), (reach + up // 4, up))))
    return turned(draw, r, (0, 0), (way, draw.integer(-way // 8, way // 8)), *wall)


def flat_start(draw):
    """A small disc that leaves the side of a long wall."""
    wall, r = draw.integer(10**6, 10**7), draw.integer(1, 1000)
    x, up = draw.integer(0, wall), draw.integer(10**4, 10**7)
    return turned(draw, r, (x, r), (x + draw.integer(-wall, wall), r + up), (0, 0), (wall, 0))


def flat_end(draw):
    """A short way that ends in a touch of the side, nearly along the wall."""
    m, a = draw.integer(5, 3000), draw.integer(1, 2000)
    wall = a * m * draw.integer(2, 400)
    x, r = draw.integer(0, wall), draw.integer(1, wall)
    return turned(draw, r, (x - a * m, r + a), (x, r), (0, 0), (wall, 0))


def into(drawn):
    """The other way from where another case begins."""

    def draw_case(draw):
        P0, P1, *rest = drawn(draw)
        P2 = tuple([2 * p - q for p, q in zip(P0, P1, strict=True)])
        return (P0, P2, *rest) if max(map(abs, P2)) <= 2**30 else draw.reject()

    return draw_case


def sliver(draw):
    """A disc and an end of a wall that are hardly above or beside each other; or the wall leads there."""
    cx, cy, r, (px, py), P1 = slivers("dot", "through", *6 * ["slant"])(draw)
    times = draw.choice((0, 0, draw.integer(1, 12) / 8))
    u, v = times * (cx - px), times * (cy - py)
    end = draw.choice(((cx + u, cy + v), (cx + u, cy + v), (cx - v, cy + u)))
    if max(map(abs, end)) > 2**30:
        draw.reject()
    return (px, py), P1, r, *(((cx, cy), end) if draw.boolean() else (end, (cx, cy)))


def crawling(draw):
    """A disc of 1e-29 that meets an end of the wall, or a post, on a way of less than 1e-30."""
    p, q, c = triple(draw, 17)
    times, before, after, unit = draw.integer(50, 400), draw.integer(1, 2), draw.integer(0, 2), 2.0**-105
    r, P0, P1 = c * times * unit, *((p * n * unit, q * n * unit) for n in (times + before, times - after))
    wall = -draw.integer(0, 1) * p * times * unit, -draw.integer(0, 1) * q * times * unit
    return mirrored(draw, r, P0, P1, (0, 0), wall)


def mirrored(draw, r, *points):
    """The points by any symmetry of the axes, and the ends of the wall in either order."""
    turn, s, t = draw.choice((1, -1)), draw.sign(), draw.sign()
    P0, P1, A, B = ((x * s, y * t)[::turn] for x, y in points)
    return P0, P1, r, *draw.choice(((A, B), (B, A)))


def just_off(draw):
    """A way nearly along an axis, which begins or ends 1e-7 to 1e-6 of the figure off a touch of the wall's side or end."""
    end = draw.choice(("first", "last", "last", "last"))
    cx, cy, r, P0, P1 = sloping(end=end)(draw)
    (x, y), (u, v) = (P0, P1) if end == "first" else (P1, P0)
    way, side = hypot(u - x, v - y), draw.sign()
    u, v, x, y = (u - x) / way, (v - y) / way, x - cx, y - cy  # from the circle, or back across it
    if x * u + y * v < 0:
        u, v = -u, -v
    if draw.boolean():  # a side: as far from the end as the circle is
        off = x * v - y * u
        back = sqrt(r * r - off * off) - r
        near, far = (r * draw.integer(20, 150) / 100 * each for each in (side, -side))
        ends = [(cx + off * v + back * u - n * v, cy - off * u + back * v + n * u) for n in (near, far)]
    else:
        long, lean = r * draw.integer(20, 150) / 100, draw.integer(-8, 8) / 10
        ends = [(cx, cy), (cx - long * (u - lean * v), cy - long * (v + lean * u))]
    return P0, P1, r, *ends[::side]


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", grid("pprpp", 4), cases=160, skills="the small grid"),
    group("side", "Onto the side of a wall at any angle.", either(walls("hit side", **PLAIN), walls("hit side", **AXIS)), cases=45, skills=("fatten the wall", "t is not a distance")),
    group("past", "Past the wall, where its line would be hit.", walls("past side", "past side", "hit side", **PLAIN), cases=45, skills="fatten the wall"),
    group("ends", "Onto an end, which is round.", either(walls("hit cap", **PLAIN), walls("hit cap", "hit cap level", **{**AXIS, "shift": -6, "move": 0})), cases=80, skills=("fatten the wall", "a wall has round ends")),
    group("overlap", "Disc and wall overlap or touch from the start, whatever the disc does then: t = 0.", walls("overlap side", "overlap cap", "start side", "start cap", "start post", **PLAIN), cases=45, skills="touching from the start"),
    group("away", "The disc leaves the wall, or rests beside it: the touch was before the start, or never.", either(walls("away side", "away cap", "rest side", "rest cap", **PLAIN), back(walls("shy cap", "shy post", **PLAIN)), back(walls("flat side", **PLAIN)), back(walls("flat side", **PLAIN)), past), cases=140, skills="first in time"),
    group("short", "The disc stops before the wall, or before it would graze it.", walls("short side", "short cap", "short post", "shy cap", "shy post", **PLAIN), cases=45, skills="first in time"),
    group("graze", "The disc grazes an end.", walls(*GRAZES, "graze cap", **PLAIN), cases=45, skills="a graze is a touch"),
    group("slide", "The disc slides along the wall, and touches it from its first end on.", either(walls("slide side", **PLAIN), walls("slide side", **{**BIG, "turn": "axis"})), cases=45, skills=("a graze is a touch", "a wall has round ends")),
    group("parallel", "A way parallel to the wall, from right above or beside an end of it.", parallel, cases=45, skills="first in time"),
    group("post", "A wall that is a point.", walls("hit post", "hit post", "graze post", "short post", **PLAIN), cases=45, skills="a wall has round ends"),
    group("point", "The radius is 0, or so small beside the way and the wall: the disc is a point.", walls("hit side dot", "hit post dot", "end side dot", "end post dot", "start cap dot", "short side dot", "rest post dot", "hit side grain", "hit side grain", "short side grain", "past side grain", "hit cap grain", "hit cap grain", **{**PLAIN, "shift": -20}), cases=100, skills="first in time"),
    group("still", "The disc rests, on the wall or beside it.", walls("rest side", "rest cap", "rest post", "rest post dot", **PLAIN), cases=45, skills="touching from the start"),
    group("fast", "A way of many radii: no coarse clock sees the touch.", either(*3 * [walls("fast side", "fast cap", "fast post", **{**PLAIN, "shift": -20})], leaving), cases=60, skills="never step through"),
    group("repeated", "Neighbouring calls differ in one argument.", grid("pprpp", 4), turns=True, cases=70, skills="nothing kept between calls"),
]

PRODUCTION = [  # the same, where rounding bites
    group("decimals", "Touches in short decimals, which == does not see.", either(telling(walls("slide side", "end side", "start side", "start side", **DECIMALS), *TELLING), *2 * (walls("end post dot level", "end cap dot level", "end cap dot level", **DECIMALS),)), cases=80, skills="a graze is a touch"),
    group("turned", "Grazes that squares cannot see.", walls(*GRAZES, "graze cap dot", "graze cap dot", "graze cap dot", "slide side", **BIGGER), cases=110, skills="a tangent has a width"),
    group("upright", "Grazes along an axis that seem to be apart or to overlap, from level with an end of the wall, from its line, or right beside it.", either(*3 * [upright], *2 * [partial(upright, stops=True), telling(tangent, *TELLING)]), cases=215, skills="a tangent has a width"),
    group("graze-full", "Grazes that no formula in floats can see, or that seem to overlap.", telling(walls(*GRAZES, **FULL), *TELLING), cases=46, skills="a tangent has a width"),
    group("slide-full", "The disc slides along the wall, or stops where it would, and rounding puts it beside.", either(*3 * [telling(walls("slide side", "stop side", **FULL), *TELLING)], *2 * [sinking]), cases=84, skills="a tangent has a width"),
    group("start-full", "The disc touches at the start, and rounding puts it apart.", either(*2 * [telling(walls("rest side", **FULL), *TELLING)], telling(walls("start side", **{**FULL, "turn": "axis"}), *TELLING), walls("start cap", **FULL), walls("start side dot", **FULL), walls("start side dot", **FULL), *4 * [abreast], telling(flat_start, *TELLING)), cases=100, skills="touching from the start"),
    group("end-full", "The disc touches at the very end, and rounding makes it later.", telling(either(walls("end side", "end cap", **FULL), walls("end cap level", "end cap dot level", "end side level", "end post level", **{**FULL, "turn": "axis"}), walls("end cap afar", "end post afar", **AFAR), walls("end side dot", "end cap dot", "end post dot", **FULL), walls("end cap", "end side", **{**STEEP, "size": 2**7}), walls("end cap home", "end side home", "end post home", "stop cap home", "stop post home", **{**FULL, "move": 0}), *2 * [flat_end]), *TELLING), cases=96, skills="first in time"),
    group("beside", "The disc touches at the very end, and its way begins level with an end of the wall.", beside(walls("end side", "end side", "end side", "end side dot", "end cap dot", "end post dot", **FULL)), cases=70, skills="first in time"),
    group("at-an-end", "A point that begins or ends its way at an end of the wall.", either(ending, late, *3 * [slipping], *2 * [head_on, resting, resting]), cases=160, skills="first in time"),
    group("head-on", "The disc comes to an end of the wall almost straight.", almost_straight, cases=90, skills="full precision"),
    group("near-graze", "Nearly a graze: 1e-7 of the figure away.", walls("graze~ cap", "graze~ cap dot", "graze~ cap dot", "graze~ cap dot", "graze~ post", "slide~ side", **CLEAR), cases=90, skills="nearly is not touching"),
    group("near-start", "The disc nearly touches at the start, and leaves or comes nearer; or it touches right after the start.", either(*4 * [walls("start~ side", "start~ cap", **CLEAR)], *6 * [into(walls("start~ side", "start~ side", "start~ cap", **CLEAR))], soon, soon, creeping), cases=172, skills="touching from the start"),
    group("near-end", "The disc touches just before the end, or does not quite.", either(walls("end~ side", "end~ cap", "end~ side dot level", "end~ post dot level", **CLEAR), walls("shy cap", "shy post", **{**FULL, "shift": 0}), walls("shy post afar", **AFAR), walls("end~ side grain", "end~ side", **{**PLAIN, "shift": -20})), cases=115, skills="first in time"),
    group("flat", "Onto the side nearly along the wall: it still is the side.", either(walls("flat side", "flat side grain", **{**PLAIN, "shift": -20}), walls("flat side", **{**PLAIN, "size": 100}), walls("flat side", **{**PLAIN, "size": 100})), cases=90, skills="fatten the wall"),
    group("rim", "Onto the side, close to an end: it still is the side.", walls("hit side rim", "end side rim", **{**BIG, "size": 2**16}), skills="a wall has round ends"),
    group("broad", "A wall that is less than a hundredth of the disc: it is no post.", walls("broad side", **PLAIN), cases=45, skills="a wall has round ends"),
    group("small-parts", "A part that is 1e-9 to 1e-1 of another one, and counts.", driven, skills="full precision"),
    group("tiny", "All of it tiny, down to 1e-29.", either(*4 * [walls("graze cap", "graze~ cap", "stop cap", "end~ side", "hit side", **TINY)], crawling), cases=60, skills=("no absolute epsilon", "scale invariance")),
    group("offset", "A small figure far from the plane's origin.", walls("hit side", "hit cap", "graze cap", "end side", "start side", "shy cap", **OFFSET), skills="far from the origin"),
    group("offset-near", "Nearly a touch at the start, on the way or at the end, far from the plane's origin.", walls("graze~ cap", "slide~ side", "start~ side", "end~ side", "end~ cap", "end~ post dot level", **OFFSET), skills="far from the origin"),
    group("steep", "Ways or walls almost along an axis, and points hardly apart.", either(walls("hit side level", "hit cap level", "hit side", "hit cap", **ASKEW), walls("hit side", "hit cap", "graze cap", "short cap", **{**STEEP, "size": 2**7}), walls("hit side level", "hit cap level", "short side", "away side level", **TILTED), *3 * [sliver], *2 * [uneven("pprpp")]), cases=230, skills="no slopes"),
    group("narrow", "A point whose way leaves an axis by 1e-9 to 1e-4 and ends at an end of the wall, or that rests beside a long wall.", narrow, cases=200, skills="no slopes"),
    group("sloping", "Ways off an axis by 1e-4 to 1e-1, which begin or end just off a touch: 1e-7 to 1e-6 of the figure.", just_off, cases=50, skills="no slopes"),
    group("random", "Any numbers, small and large.", uniform("pprpp", 20, 1e4, 1e9), cases=45, skills="full precision"),
    group("large", "Whole numbers up to 2**30, some of them grazes.", either(whole("pprpp", 30), walls(*GRAZES, "hit side", "end cap", **{**BIGGER, "shift": 0, "numbers": "int"})), cases=45, skills=("whole numbers that are large", "scale invariance")),
]
