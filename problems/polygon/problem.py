"""Where the boundary of a polygon crosses a circle: exactly, edge by edge."""

from functools import partial
from math import sqrt

from judge.geometry import plain
from judge.geometry.hooks import hooks
from judge.geometry.polygon import crossings
from judge.geometry.pose import triple
from judge.geometry.scenes import ASKEW, AXIS, BIG, FAR, HUGE, LEANS, NEAR, OFFSET, PLAIN, STEEP, TINY, cornered, either, grid, leaning, lines, merged, past, pinpoint, polygons, polygons_of, ratios, slivers, telling, tried, uneven, uniform, whole
from judge.problem.declare import group

HOOKS = hooks("polygon")
FULL = {**HUGE, "size": 2**35, "move": 49}
WHOLE = {**BIG, "shift": 0, "numbers": "int"}
LEVEL = {**FULL, "turn": "axis"}
STARS = "in out in out", "in out out", "in in out out in", "out in out across"
ON = "on out on in", "on in on out out", "on on on", "on out out in"
TOUCHES = "tangent out", "tangent tangent", "in tangent", "brush out"
TELLING = plain.crossings, partial(plain.crossings, tolerance=1e-10)


def solve(cx, cy, r, V):
    return crossings(cx, cy, r, V)


def between(cx, cy, r, V, tolerance=0):
    """How many crossings are between the corners of their edges, as ways from the foot."""
    corners = [complex(x - cx, y - cy) for x, y in V]
    near, found = tolerance * max(r, *map(abs, corners)), 0
    for start, end in zip(corners, [*corners[1:], corners[0]], strict=True):
        way = end - start
        turned = -start * (way / abs(way)).conjugate()
        half = sqrt(max(0, (r - abs(turned.imag)) * (r + abs(turned.imag))))
        found += sum(near < turned.real + side * half < abs(way) - near for side in (-1, 1))
    return found


def triangle(drawn):
    """A line's A and B, and B turned about C by a quarter, in any order of the three."""

    def closed(draw):
        cx, cy, r, A, B = drawn(draw)
        V, at = (A, B, (cx + cy - B[1], cy - cx + B[0])), draw.integer(0, 2)
        if max(map(abs, V[2])) > 2**30:
            draw.reject()
        return cx, cy, r, V[at:] + V[:at]

    return closed


def beside(case, part=1e-7):
    """Whether a touch is more than a part of the radius beside it, by the unit vector of the way from A to B."""
    cx, cy, r, (ax, ay), (bx, by) = case
    way = sqrt((bx - ax) ** 2 + (by - ay) ** 2)
    return abs(abs((ax - cx) * ((by - ay) / way) - (ay - cy) * ((bx - ax) / way)) - r) > part * r


def mite(draw):
    """A touch of a circle that is 1e12 to 1e14 times smaller than the way to A and B, on both sides of it."""
    (p, q, c), r, scale = triple(draw, 65), draw.integer(1, 3), 2.0 ** -draw.integer(23, 80)
    far, turn, back = draw.integer(2**45, 2**46) >> draw.integer(0, 3), scale * draw.sign(), scale * draw.sign()
    A, B = (((x * p - r * q) * turn, (x * q + r * p) * back) for x in (far, -draw.integer(far // 4, far)))
    return 0, 0, scale * r * c, A, B


def splinter(draw):
    """r = 0, and C is 1e9 to 1e15 times nearer the origin than A and B, which are on both sides of it."""
    p, q = draw.integer(1, 99) * draw.sign(), draw.integer(1, 99) * draw.sign()
    a, b = draw.integer(10**5, 10**7), -draw.integer(10**5, 10**7)
    near, scale = draw.integer(1, 2**16) * draw.sign() * 2.0 ** -draw.integer(30, 42), 2.0 ** -draw.choice((0, 0, 20, 50))
    (cx, cy), A, B = ((p * at * scale, q * at * scale) for at in (near, a, b))
    return cx, cy, 0, A, B


def skew(case):
    """Whether A and B, as floats have them from C, are not on one line with it."""
    cx, cy, _, (ax, ay), (bx, by) = case
    return (ax - cx) * (by - cy) != (ay - cy) * (bx - cx)


def spoke(drawn):
    """After the first corner one that is straight beyond it, or before it, as C sees it."""

    def added(draw):
        cx, cy, r, (first, *others) = drawn(draw)
        times = draw.integer(10, 900) / 100
        return cx, cy, r, (first, (cx + times * (first[0] - cx), cy + times * (first[1] - cy)), *others)

    return added


def clear(cx, cy, r, V, tolerance=0):
    """Whether the first edge is clear of the circle, by how far its middle is from C."""
    (ax, ay), (bx, by) = ((x - cx, y - cy) for x, y in V[:2])
    middle, half = sqrt((ax + bx) ** 2 + (ay + by) ** 2) / 2, sqrt((bx - ax) ** 2 + (by - ay) ** 2) / 2
    return middle > (r + half) * (1 + tolerance)


def askew(draw):
    """All corners are in one quarter of the plane, as C sees it, and outside the circle; one edge cuts it."""
    r, x, y = draw.integer(10, 30), draw.sign(), draw.sign()
    near = [(draw.integer(1, r // 5), r + draw.integer(1, r // 5)) for _ in "AB"]
    others = [(draw.integer(r, 4 * r), draw.integer(r, 4 * r)) for _ in range(draw.integer(2, 6))]
    corners, at = [near[0], near[1][::-1], *others], draw.integer(0, 3)
    return 0, 0, r, tuple((x * px, y * py) for px, py in corners[at:] + corners[:at])


def homewards(drawn):
    """The corners the other way round, the first one first: the edge that left it comes back to it."""

    def back(draw):
        *circle, V = drawn(draw)
        return *circle, (V[0], *V[:0:-1])

    return back


def backed(draw):
    """A corner right behind another one, as C sees them: 2e-9 to 9e-9 of how far away they are."""
    p, q, c = triple(draw, 65)
    far, behind = draw.integer(2**18, 2**20) * 2.0 ** -draw.choice((0, 20, 60)), 1 + draw.integer(20, 90) * draw.sign() / 10**10
    points = (p * far, q * far), (p * far * behind, q * far * behind), (draw.integer(-c, c) * far, draw.integer(-c, c) * far)
    side, at = draw.sign(), draw.integer(0, 2)
    V = tuple((x * side, y) for x, y in points)
    return 0, 0, c * far * draw.choice((0, draw.integer(1, 120) / 64)), V[at:] + V[:at]


def shallow(draw):
    """An edge leaves a corner on the circle at 1/256 to 1/2048 of the tangent's way, and ends inside or beyond."""
    (p, q, c), m, scale = triple(draw, 65), draw.integer(2**44, 2**45), 2.0 ** -draw.integer(30, 90)
    k = draw.integer(256, 2048) * draw.sign()
    n, away, at = m * draw.choice((1, 1, 4)) // (k * k + 1), draw.integer(2, 3), draw.integer(0, 2)
    points = (p * m, q * m), (p * m - (q * k + p) * n, q * m + (p * k - q) * n), (-away * p * m, -away * q * m)
    V = [(x * scale, y * scale) for x, y in points][:: draw.choice((1, -1))]
    return 0, 0, c * m * scale, (*V[at:], *V[:at])


def off(case):
    """Whether doubles put a corner on the circle outside of it."""
    _, _, r, V = case
    return any(0 < sqrt(x * x + y * y) - r < 1e-15 * r for x, y in V)


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", cornered(grid, (3, 5), 3), cases=120, skills="the small grid"),
    group("stars", "Corners inside and outside all around: most edges cross once.", either(polygons(*STARS, **PLAIN), polygons(*STARS, **AXIS)), skills="edge by edge"),
    group("twice-an-edge", "Corners outside, and edges that cut the circle: two crossings an edge, in the order of the way.", either(*3 * [polygons("across out", "across across", "out across out", **PLAIN)], askew), cases=80, skills="edge by edge"),
    group("corner-on", "Corners on the circle: the boundary passes through, or comes back on the same side.", either(*2 * [polygons(*ON, **PLAIN)], homewards(polygons("leave out", "leave in out", **PLAIN))), cases=75, skills="a corner is met once"),
    group("closing-edge", "The edge from the last corner to the first one crosses.", polygons("in in out", "in in in out", "out out in", **PLAIN), skills="close the loop"),
    group("touch", "An edge touches: one crossing.", polygons(*TOUCHES, **PLAIN), skills="collapse the tangent"),
    group("inside-around", "The whole polygon inside the circle, or around it: no crossing.", polygons("in in in", "in in in in", "box", **PLAIN), skills="no root of a negative number"),
    group("order", "Polygons that cross themselves, begin anywhere and run either way round: the crossings come along the boundary.", polygons_of("in", "out", "on", count=(4, 9), **PLAIN), skills="order along the boundary"),
    group("radius-zero", "r = 0: the circle is the point C, on an edge, at a corner, or beside the boundary.", polygons("dot out by out", "dot at out out", "dot out at out", "dot box", "dot out out by", **PLAIN), skills="r = 0"),
    group("repeated", "Neighbouring calls differ in one argument.", cornered(grid, (3, 4), 4), turns=True, skills="nothing kept between calls"),
]

PRODUCTION = [  # the same, where rounding bites
    group("turned", "A touch that squares cannot see.", polygons(*TOUCHES, **BIG), skills="a tangent has a width"),
    group("touch-full", "A touch that no formula in floats can see.", either(*4 * [telling(polygons(*TOUCHES, **FULL), *TELLING)], triangle(tried(pinpoint(), beside)), triangle(tried(mite, partial(beside, part=2e-4)))), cases=90, skills="a tangent has a width"),
    group("corner-full", "Corners on the circle, and rounding puts them beside.", either(*3 * [telling(either(polygons(*ON, **FULL), polygons("on level out", "level on out", "on level on", **FULL), polygons_of("on", "by", "leave", count=(30, 45), turns=True, **BIG), polygons("on level out", "level on out", **LEVEL), polygons_of("on", "pole", "level", count=(12, 20), turns=True, **LEVEL)), *TELLING)], telling(polygons("at on out", "at out on", "at on in", "in at on", "out at on", "on at out", **FULL), between, partial(between, tolerance=1e-10)), telling(spoke(polygons("on out", "on in out", **FULL)), clear, partial(clear, tolerance=1e-9))), cases=102, skills="a corner is met once"),
    group("short-edge", "A corner on the circle, and an edge of a ten millionth to an eighth of the figure, or one that hardly leaves it.", either(polygons("short out", "short in out", "short short", **FULL), *3 * [tried(shallow, off)], backed, polygons_of("stub", "in", count=(20, 42), turns=True, **FULL), polygons_of("skim", "in", "skim", "out", count=(7, 12), turns=True, **FULL)), cases=110, skills="a corner is met once"),
    group("off-centre", "Edges past the centre by 1e-8 to 1e-1 of the radius, and chords that bend by 2e-6 to 2e-4 of it.", triangle(lines("off-centre before after", "off-centre in after", "off-centre before in", "flat before after", "flat before in", **FULL)), cases=100, skills="full precision"),
    group("near-touch", "Nearly a touch: 1e-7 of the figure away.", polygons("tangent~ out", "tangent~ tangent~", "in tangent~", "brush~ out", **{**NEAR, "least": 7}), skills="nearly is not touching"),
    group("near-corner", "Corners just inside or just outside the circle.", polygons("on~ out on~ in", "on~ in on~ out", "on~ on on~", **{**NEAR, "least": 7}), skills="nearly is not on it"),
    group("tiny", "All of it tiny, down to 1e-29.", polygons("tangent out", "tangent~ out", "on out in", "on~ out in", **TINY), skills=("no absolute epsilon", "scale invariance")),
    group("offset", "A small figure far from the plane's origin.", polygons("in out in out", "tangent out", "on out in", "tangent in", "tangent~ out", "on~ out in", **OFFSET), skills="far from the origin"),
    group("far-corner", "A corner thousands or millions of radii away: its size is the figure's.", either(polygons("tangent far", "on far in", "far across", "tangent far out", **{**BIG, "size": 2**16}), polygons("remote across", "remote across out", "remote on across", "remote on in", **FAR)), cases=80, skills="the size of the whole"),
    group("speck", "A circle that is hardly more than a point beside the polygon, with a corner on it and an edge through it.", polygons("farthest on by", "on by farthest", "farthest on by out", **FAR), cases=16, skills="a corner is met once"),
    group("dot-turned", "r = 0, and edges at any angle: |f|² − (f·u)² is all rounding there.", either(*2 * (polygons("dot out by out", "dot out by in", "dot out out by", "dot out at by", "dot at out by", **BIG), polygons("dot out by out", "dot out out by", *3 * ("dot out at by", "dot at out by"), **FULL), polygons("dot slant in", "dot slant slant", **LEVEL)), triangle(tried(splinter, skew))), cases=106, skills="r = 0"),
    group("steep", "Edges almost along an axis.", either(*2 * [triangle(lines("cut before after", "cut in after", "cut before in", **ASKEW))], *4 * [polygons("tangent out", "across out", "on out in", "in out out", **STEEP)], *2 * [triangle(leaning(*LEANS[:4]))], triangle(merged), *3 * [triangle(slivers("through", "brink", "slant", "slant"))], *2 * [cornered(uneven, (3, 5))]), cases=235, skills="no slopes"),
    group("small-parts", "A coordinate, a product or the short side of a triangle is tiny beside the others, and still counts.", triangle(ratios()), skills="full precision"),
    group("zigzag", "Up to 64 corners, and nearly every edge crosses twice.", either(*[polygons_of("left", "right", count=count, turns=True, **PLAIN) for count in ((20, 64), (61, 64))]), cases=36, skills="edge by edge"),
    group("revisited", "The boundary comes to one place of the circle twice: each time is a crossing.", polygons("on out again in", "on in again out", "on out out again in in", **PLAIN), skills="order along the boundary"),
    group("random", "Any numbers, small and large.", either(*4 * [cornered(uniform, (3, 12), 20, 1e4, 1e9)], triangle(past)), cases=75, skills="full precision"),
    group("large", "Whole numbers up to 2**30, some of them touches.", either(cornered(whole, (3, 12), 30), polygons(*TOUCHES, *ON, **WHOLE), *2 * (polygons(*ON, **{**WHOLE, "size": 2**27, "turn": "axis", "move": 0}),)), cases=90, skills=("whole numbers that are large", "scale invariance")),
]
