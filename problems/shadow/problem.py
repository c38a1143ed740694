"""Whether a light reaches the first hit of a ray: exactly, and nothing is nearly a tie."""

from contextlib import suppress
from math import copysign, hypot, sqrt

from judge.geometry.hooks import hooks
from judge.geometry.scenes import ASKEW, AXIS, BIG, NEAR, OFFSET, PLAIN, TILTED, TINY, anywhere, either, home, lights, shaded, topped, tried, sloping
from judge.geometry.scenes.many import TRIPLES, any_circle
from judge.geometry.shadow import Shade, shade
from judge.problem.declare import InvalidCase, group

HOOKS = hooks("light")
ANSWERS = {Shade.NOTHING: None, Shade.LIT: "lit"}
ABOUT = {"others": (0, 2)}
FINE = {**BIG, "size": 2**26, "move": 0, "shift": (0, -20, -40)}
SMALL = {"turn": "any", "shift": (-40, -60, -75)}


def solve(circles, O, D, L):
    return ANSWERS.get(shade(circles, O, D, L), "dark")


def twins(draw):
    """The circle between is as large as the one that is hit, and right above or beside it."""
    r, far, up = draw.integer(20, 99), draw.integer(100, 300), draw.integer(0, 3) > 0
    high = draw.integer(2 * r + 1, 3 * r)
    left, top = draw.sign(), draw.sign()
    points = (0, 0), (0, high), (-far, draw.integer(1, r - 1)), (draw.integer(1, 9), 0), (-draw.integer(r // 4, r), high + draw.integer(r, 3 * r))
    C, other, O, D, L = ((left * x, top * y) if up else (top * y, left * x) for x, y in points)
    rows = (*C, r), (*other, r)
    return rows[:: draw.sign()], O, D, L


def alone(circles, O, D, L):
    """The circles without the first one that alone is in the way, and that one; None if there is none such."""
    for at, circle in enumerate(circles):
        rest = circles[:at] + circles[at + 1 :]
        with suppress(InvalidCase):
            if shade(rest, O, D, L) is Shade.LIT:
                return rest, circle
    return None


def last(draw):
    """Thirty-two circles, of which the last one alone is in the way; most are far off."""
    circles, *rest = lights("blocked", **PLAIN)(draw)
    far = 3 * int(max(map(abs, (*circles[0], *circles[1], *rest[0], *rest[2]))))
    (hit,), other = alone(circles, *rest) or draw.reject()
    others = [any_circle(draw, far, (far // 99 + 1, far // 9 + 1)) for _ in range(30)]
    x, y = 3 * far * draw.sign(), 3 * far * draw.sign()
    return (hit, *((x + u, y + v, r) for u, v, r in others), other), *rest


def above(draw):
    """L is little more than 1e-6 of the figure above the tangent at P, and both O and L are as far away as the figure is wide."""
    (p, q, c), far = draw.choice(TRIPLES), draw.integer(2**26, 2**28)
    k, m, i = far * draw.integer(1, 1000) // 1000 // c, far // c, draw.integer(0, 3)
    u, v = draw.choice(((-q, p), (q, -p)))
    D = -(u * i + p * (10 - i)), -(v * i + q * (10 - i))
    O = k * p - D[0] * (m // 10), k * q - D[1] * (m // 10)
    x, y = k * p + u * m, k * q + v * m
    n = max(k * c, *map(abs, O), abs(x - O[0]), abs(y - O[1])) * draw.integer(101, 120) // 10**8 // c + 1
    return ((0, 0, c * k),), O, D, (x + p * n, y + q * n)


def own_root(circles, O, D, L):
    """How far from P a plain program meets the circle about (0, 0) once more, as a part of the figure."""
    r, (dx, dy), way = circles[0][2], D, (0, 0)
    size = max(r, *map(abs, O), abs(L[0] - O[0]), abs(L[1] - O[1]))
    fx, fy, root = -O[0], -O[1], 0.0
    for sign in (-1, 1):  # from O to P, then from P on
        length = sqrt(dx * dx + dy * dy)
        ux, uy = dx / length, dy / length
        along, d = fx * ux + fy * uy, abs(fx * uy - fy * ux)
        root = along + sign * sqrt((r - d) * (r + d)) if d < r else 0.0
        way = root * ux, root * uy
        fx, fy, dx, dy = fx - way[0], fy - way[1], L[0] - O[0] - way[0], L[1] - O[1] - way[1]
    return root / size


def sliver(draw):
    """A small circle far away, hardly beside an axis through the ray's origin, and a light behind or there."""
    far, turn, side = draw.integer(2**18, 2**20), draw.choice((1, -1)), draw.sign()
    high = far * draw.integer(140, 205) * 2.0**-21 * draw.sign()
    radius = abs(high) * draw.integer(120, 300) / 100
    C, L = (side * far, high)[::turn], (-side * far * draw.choice((0, 0, draw.integer(1, 64) / 64)), 0)[::turn]
    return ((*C, radius),), (0, 0), (side, 0)[::turn], L


def torch(draw):
    """The light is where the ray begins or on its way, and that is beside an axis through the centre by 1e-7 to 1e-4 of how far."""
    far, turn, scale = draw.integer(2**22, 2**24), draw.choice((1, -1)), 2.0 ** -draw.choice((0, 20, 60))
    hair = far * draw.integer(2, 9) * draw.sign() * 10.0 ** -draw.integer(5, 7)
    r, times = far * draw.integer(20, 170) / 100, draw.choice((0, 0, draw.integer(1, 9) / 16))
    x, y = draw.choice((far, -far)), far * draw.integer(-99, 99) / 100
    way = -x + draw.integer(-90, 90) * r / 100, -hair + draw.integer(-90, 90) * r / 100
    if max(map(abs, way)) * 4 < r or y == 0:
        draw.reject()
    C, O, D, L = ((u * scale, v * scale)[::turn] for u, v in ((0, 0), (x, hair), way, (x + way[0] * times, hair + way[1] * times)))
    return ((*C, r * scale),), O, D, L


def doorstep(draw):
    """The ray begins 2e-6 to 1e-3 of the radius off the circle and looks along an axis, from the light or away from it."""
    x, y = (draw.integer(400, 999) * draw.sign() for _ in "xy")
    r = sqrt(x * x + y * y) * (1 - draw.integer(2, 99) * 10.0 ** -draw.integer(5, 6))
    scale, D = 2.0 ** -draw.choice((0, 20, 60)), draw.choice(((copysign(1, x), 0), (0, copysign(1, y))))
    L = tuple([a * scale * draw.choice((0, 0, draw.integer(1, 99))) for a in D])
    return ((x * scale, y * scale, r * scale),), (0, 0), D, tuple([-a for a in L])


def lamppost(draw):
    """The ray meets the circle along an axis, and the light is above that place, off the tangent by 2e-6 to 1e-4 of how far."""
    r, turn, side, up = draw.integer(1, 99), draw.choice((1, -1)), draw.sign(), draw.sign()
    far = r * 10 ** draw.integer(0, 5)
    x, lean = draw.integer(1, 4) * r, draw.integer(2, 9) * draw.choice((1, 1, -1)) * 10.0 ** -draw.integer(5, 6)
    rows = ((side * (x + r), 0)[::turn], r)
    return ((*rows[0], r),), (0, 0), (side, 0)[::turn], (side * (x - lean * far), up * far)[::turn]


def ridge(draw):
    """The point is beside the top of its circle by 2e-5 to 1e-4 of the radius, and the light is low above it."""
    r, turn, side, up = draw.integer(10, 999), draw.choice((1, -1)), draw.sign(), draw.sign()
    hair, lean, far = r * draw.integer(2, 10) * 1e-5, 10.0 ** -draw.integer(2, 3) * draw.integer(2, 9), r * draw.integer(1, 3)
    points = (hair, -r), (draw.integer(-99, 99), draw.integer(20, 99)), (draw.sign() * far, far * lean)
    C, way, L = ((side * u, up * v)[::turn] for u, v in points)
    return ((*C, r),), tuple([a * r / 64 for a in way]), tuple([-a for a in way]), L


def behind(draw):
    """The ray meets a small circle, and 1e-7 to 2e-7 of the figure behind it a larger one, or the other way round."""
    turn, side, scale = draw.choice((1, -1)), draw.sign(), 2.0 ** -draw.choice((0, 20, 60))
    x, r = draw.integer(2**20, 2**22), draw.integer(2**18, 2**20)
    R = r * draw.integer(11, 40) / 10
    gap = (x + 2 * R) * draw.integer(105, 195) / 10**9
    rows = (x + r, 0, r), (x + gap + R, 0, R)
    if draw.integer(0, 3) == 0:
        rows = (x + gap + r, 0, r), (x + R, 0, R)
    L = x * draw.integer(-9, 9) / 10, x * draw.integer(20, 99) / 100 * draw.sign()
    circles = tuple((*[side * a * scale + 0 for a in C][::turn], r * scale) for *C, r in rows)
    return circles[:: draw.sign()], (0, 0), (side * draw.integer(1, 9), 0)[::turn], tuple([side * a * scale for a in L][::turn])


def lantern(draw):
    """A circle near the point is between, and up to thirty others are nearer to the light, in the way or beside it."""
    r, high, turn, side = draw.integer(20, 60), draw.integer(800, 999), draw.choice((1, -1)), draw.sign()
    x = draw.integer(100, 400)
    at = draw.integer(15, 40) / 100  # of the way from P to L
    rows = [(x + r, 0, r), (x * (1 - at) + draw.integer(-5, 5), high * at, draw.integer(10, 25))]
    for _ in range(draw.integer(8, 30)):
        far, away = draw.integer(80, 200), draw.integer(-100, 100) / 100
        rows.append((far * away, high + far * sqrt(1 - away * away) * draw.choice((1, 1, 0.5)), draw.integer(5, 40)))
    first = draw.integer(0, len(rows) - 1)
    rows = rows[first:] + rows[:first]
    return tuple((*[side * a for a in C][::turn], r) for *C, r in rows), (0, 0), (side, 0)[::turn], (0, side * high)[::turn]


def lampside(draw):
    """The way to the light is nearly along an axis, and the light is 1e-7 to 1e-6 of the figure off another circle: just before it, or just behind."""
    cx, cy, r, L, P = sloping(end="first")(draw)
    way = hypot(P[0] - L[0], P[1] - L[1])
    u, v = (P[0] - L[0]) / way, (P[1] - L[1]) / way
    R, far, lean, tilt = r * draw.integer(20, 150) / 100, way * draw.integer(5, 60) / 100, *(draw.integer(-60, 60) / 100 for _ in "12")
    n, m = hypot(1, lean), hypot(1, tilt)
    C = P[0] + R * (u - lean * v) / n, P[1] + R * (v + lean * u) / n
    O = P[0] - far * (u - tilt * v) / m, P[1] - far * (v + tilt * u) / m
    return ((cx, cy, r), (*C, R))[:: draw.sign()], O, (P[0] - O[0], P[1] - O[1]), L


INTERVIEW = [
    group("grid", "Few circles in small whole numbers.", anywhere(12, (1, 3), (1, 8), light=True), cases=120, skills="the small grid"),
    group("open", "The light shines freely on the point, or nothing is hit; other circles stand about.", either(lights("open", "open", "open", "miss", **ABOUT, **PLAIN), lights("torch", **AXIS)), cases=80, skills=("a second ray", "off the surface, a little")),
    group("far-side", "The light is on the side of the circle that the ray does not see.", lights("back", "back", "open", **ABOUT, **PLAIN), skills="which side is seen"),
    group("blocked", "A circle is between the point and the light.", either(*4 * [lights("blocked", "around-light", "around-point", **PLAIN)], shaded(twins, "blocked"), tried(lantern, lambda case: alone(*case))), cases=96, skills="a second ray"),
    group("beyond", "A circle is on the line, but beyond the light or behind the point.", lights("beyond", "beyond", "behind", **PLAIN), skills="a ray that ends"),
    group("inside", "The ray begins inside a circle and hits its wall from there; the light is in the same room or not.", either(lights("room", "room", "wall", "wall", "outdoors", others=(0, 1), **PLAIN), lights("straight", **AXIS)), skills=("origin inside", "which side is seen")),
    group("many", "Up to thirty-two circles anywhere.", either(*3 * [shaded(anywhere(1000, (8, 32), (16, 125), light=True), "lit", "lit", "blocked", "back")], tried(last)), cases=45, skills="full precision"),
    group("repeated", "Neighbouring calls differ in one argument.", anywhere(12, (1, 3), (1, 8), light=True), cases=90, turns=True, skills="nothing kept between calls"),
]

PRODUCTION = [  # the same, where rounding bites
    group("gap", "A tiny circle is between, close to the point.", lights("gap", **{**PLAIN, "size": 3000}), skills=("a ray that ends", "off the surface, a little")),
    group("close", "The way to the light nearly touches a circle.", lights("close", "close-early", "close-large", **FINE), skills="nearly is not touching"),
    group("first-close", "The ray itself nearly touches a circle, or begins just before it.", lights("first-close", "brink", **FINE), cases=90, skills="nearly is not touching"),
    group("own-wall", "From inside, nearly along the wall: the way to the light leaves the room right beside the point.", lights("level-wall", **{**BIG, "size": 20_000}), skills="off the surface, a little"),
    group("skin", "The point is just inside another circle, or the ray meets another one right behind it: a wall is right behind the start, or right before it.", either(*4 * [lights("skin", **FINE)], *2 * [behind]), cases=170, skills="off the surface, a little"),
    group("at-the-light", "A wall a thousandth or a ten-millionth of the way before the light, or just beyond it.", lights("lamp", "lamp-thin", **{**BIG, "size": 10**7}), cases=72, skills="a ray that ends"),
    group("ledge", "The point is just outside of another circle, beside the ray: whoever starts far off the surface starts in it.", lights("ledge", **FINE), skills="off the surface, a little"),
    group("sill", "Another circle begins right before the point, on the way to the light.", either(lights("sill", **FINE), *[lights("sill", **{**FINE, "turn": "axis"})] * 2), cases=110, skills="off the surface, a little"),
    group("home", "The ray begins at the centre, or level with it or upright, and so does the way to the light; or where the light is.", either(either(home(20), home(2**28)), lights("candle", "candle", "candle", "straight", **{**TILTED, "size": 256, "tilt": (23, 27)})), cases=160, skills="off the surface, a little"),
    group("rooms", "Circles one in another, often about one centre: a wall around everything blocks nothing, one around the point does.", either(*3 * [lights("court", "court", "pillar", "moat", **PLAIN), lights("court", "pillar", "moat", **AXIS)], tried(lights("around-point", others=(7, 12), **PLAIN), lambda case: alone(*case))), cases=70, skills=("a second ray", "a ray that ends")),
    group("level", "The light is just above or below the surface: no distance off the surface tells.", either(*5 * [lights("level-open", "level-back", "level-far", "level-far", **{**BIG, "size": 20_000})], tried(above, lambda case: own_root(*case) > 1.4e-10)), cases=108, skills="which side is seen"),
    group("direction-length", "Directions up to 1e24 times longer or shorter than the figure.", either(lights("open", "back", "blocked", "blocked", "room", "wall", **{**PLAIN, "shift": -17, "stretch": (-40, -20, 0, 20, 30, 30)}), lights("open", "blocked", "room", "wall", **{**NEAR, "shift": -60, "stretch": (0, 40, 70, 82)})), cases=90, skills="t is not a distance"),
    group("top", "The point is the top of its circle, or the bottom, or to the left or right of the centre.", either(*3 * [shaded(either(topped(20), topped(2**28)), "lit", "lit", "own", "back")], ridge), cases=76, skills="off the surface, a little"),
    group("steep", "Directions almost along an axis.", either(lights("open", "blocked", "wall", **ASKEW), *2 * [lights("open", "blocked", "room", "wall", "straight", "straight", **{**TILTED, "tilt": (20, 75)})], *2 * [lights("open", "room", **{**TILTED, "tilt": (27, 29)})], sliver, *2 * [torch], lamppost, doorstep), cases=225, skills="no slopes"),
    group("sloping", "Ways to the light off an axis by 1e-4 to 1e-1, and a wall 1e-7 to 1e-6 of the figure before the light or beyond it.", lampside, cases=40, skills="no slopes"),
    group("tiny", "Figures of 1e-10 to 1e-20.", either(lights("blocked", "wall", "around-light", "around-point", "outdoors", "back", size=200, **SMALL), lights("level-open", "level-back", "close", **{**TINY, "size": 2**22})), cases=90, skills=("no absolute epsilon", "scale invariance")),
    group("offset", "A small figure far from the plane's origin.", either(lights("open", "blocked", "blocked", "room", **ABOUT, **OFFSET), lights("level-open", "level-back", "room", "wall", **OFFSET)), cases=110, skills="far from the origin"),
    group("large", "Whole numbers up to 2**30.", lights("open", "back", "blocked", "beyond", "room", "wall", **{**BIG, "size": 2**17, "shift": 0, "numbers": "int"}), skills=("whole numbers that are large", "scale invariance")),
]
