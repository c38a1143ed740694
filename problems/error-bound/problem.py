"""An enclosure of Δ = r²·a − k² for doubles as they are, no wider than careful doubles make it."""

from math import isqrt, sqrt

from judge.geometry import whole
from judge.geometry.hooks import hooks
from judge.geometry.scenes import BIG, FAR, HUGE, OFFSET, PLAIN, SPLIT, STEEP, TINY, doubles, either, grid, hairlines, lines, tried
from judge.problem.declare import group

HOOKS = hooks("seven")
TOUCH = ("touch before after", "touch foot by", "touch ?by ?by")
seven = doubles.seven


def solve(cx, cy, r, ax, ay, bx, by):
    found = whole.discriminant(*whole.held(cx, cy, r, ax, ay, bx, by))
    return whole.enclosure(found.value, found.width)


def one_sided(draw):
    """D and f along the axes, each a little above 1 and rounded down, as their product is."""
    for _ in range(40):
        x, y = draw.integer(1 << 24, 1 << 27), draw.integer(1 << 24, 1 << 27)
        if 0.45 < x * y % 2**52 / 2**52 < 0.5:
            dx, fy = (float(2**52 + part) / 2**52 for part in (x, y))
            off = draw.integer(9900, 9999) / 10000 / 2**53
            r, scale = draw.choice((0.0, 2.0**-40)), 2.0 ** draw.choice((0, -40, 20))
            return tuple(scale * part for part in (0.0, -fy, r, -off, off, dx, off))
    return draw.reject()


ONE = 1 << 52


def halves(draw, most):
    """(x, m): x² is m and nearly a half times 2**52."""
    m = draw.integer(1, most)
    return isqrt((m * 1000 + draw.integer(485, 495)) * ONE // 1000), m


def all_lost(draw):
    """dx, fy, their product, k and k² each lose nearly half a unit of the last place, all to one side; r is 0 or nothing beside k."""
    for _ in range(50):
        x, m = draw.integer(1 << 22, 1 << 26), draw.integer(0, 40)
        y = (m * 1000 + draw.integer(485, 495)) * ONE // 1000 // x
        if 0.45 < (x + y + m) ** 2 % ONE / ONE < 0.5:
            dx, fy = (float(ONE + part) / ONE for part in (x, y))
            off, high = draw.integer(9900, 9999) / 10000 / 2**53, draw.integer(2**20, 2**24) / 2**48
            back = draw.integer(970, 990) / 1000 / 2**53 / high
            r, scale = draw.choice((0.0, 2.0**-40)), 2.0 ** draw.choice((0, -40, 20))
            return tuple(scale * part for part in (back, -fy, r, -off, off, dx, high))
    return draw.reject()


def heavy(draw):
    """The line runs through C or nearly so, and dx, dx², a, r² and r²·a each lose nearly half a unit of the last place, all to one side."""
    for _ in range(50):
        (x, m), (y, n) = halves(draw, 999), halves(draw, 999)
        if 0.43 < (2 * x + m) * (2 * y + n) % ONE / ONE < 0.5:
            dx, r = (float(ONE + part) / ONE for part in (x, y))
            off, dy = draw.integer(9900, 9999) / 10000 / 2**53, sqrt(draw.integer(960, 985) / 1000 / 2**53)
            cy, scale = draw.choice((0.0, 2.0**-45)), 2.0 ** draw.choice((0, -40, 20))
            return tuple(scale * part for part in (-off, cy, r, -off, 0.0, dx, dy))
    return draw.reject()


def partly(draw):
    """Some of the seven numbers are 2**-26 to 2**-42 of the others, and count."""
    parts = [draw.integer(2**52, 2**53 - 1) * draw.sign() * 2.0 ** -(draw.integer(26, 42) * draw.integer(0, 1)) for _ in range(7)]
    scale = 2.0 ** draw.choice((-40, -60))
    cx, cy, r, *ends = (part * scale for part in parts)
    return cx, cy, abs(r), *ends


def along(draw):
    """An upright or level line: far away along it, and a few steps beside the centre across it."""
    cx, ax, far = draw.integer(-9, 9), draw.integer(-9, 9), [draw.integer(2**52, 2**53 - 1) * draw.sign() * 2.0 ** draw.choice((-30, 0, 16, 20, 20)) for _ in "CAB"]
    r = draw.choice((0, draw.integer(1, 9)))
    if not draw.integer(0, 2):
        cx, r = ax, r or 1
    turn = draw.choice((1, -1))
    C, A, B = ((x, y)[::turn] for x, y in zip((cx, ax, ax), far, strict=True))
    return *C, r, *A, *B


INTERVIEW = [
    group("plain", "Anything anywhere within a hundred units.", doubles.plain, cases=100, skills="bound every rounding"),
    group("touch", "Exact touches: Δ is 0, and what doubles make of it is not.", either(seven(lines(*TOUCH, **BIG)), seven(hairlines.hairlines(10**9, 10**13))), cases=80, skills="bound every rounding"),
    group("exact-zero", "Δ is 0: A and B are one point, or the line touches, or r is 0 and the line runs through C.", seven(lines("cut before =", "touch foot =", "touch ?by ?by", "dot ?by ?by", **PLAIN)), skills="degenerate line"),
    group("repeated", "Neighbouring calls differ in one argument.", seven(grid("nnrpp", 9)), turns=True, skills="nothing kept between calls"),
]

PRODUCTION = [  # the same, where rounding bites
    group("ulp", "Touches with one number off by one unit in its last place.", either(doubles.ulps(seven(lines(*TOUCH, **BIG)), 1), doubles.ulps(seven(lines(*TOUCH, **HUGE)), 1)), skills="bound every rounding"),
    group("ulps", "Touches with one number off by 3 to 30,000 units in its last place.", doubles.ulps(seven(lines(*TOUCH, **BIG)), 3, 30, 300, 3_000, 30_000), cases=120, skills="full precision"),
    group("hairline", "k is r·|D| ± 1, or Δ is ± 1, where r²·a has 24 digits and more.", either(seven(hairlines.hairlines(10**9, 10**13, 10**15, off=(1, -1))), seven(hairlines.least(10**9, 10**13, 10**15))), skills="full precision"),
    group("worst", "Of a hundred lines the one that doubles get most wrong.", doubles.worst(either(doubles.easy, doubles.small_radius(doubles.easy), doubles.turned(seven(lines(*TOUCH, **BIG)))), 100), skills="bound every rounding"),
    group("through", "Lines through C but for rounding, r being 0 or nearly so.", doubles.small_radius(either(seven(lines("dot before after", "dot foot after", **SPLIT)), doubles.turned(seven(lines("dot before after", "dot far after", "dot far after", **BIG))))), cases=120, skills="the sharp discriminant"),
    group("far", "Far from the origin, or A and B far along the line.", either(seven(lines(*TOUCH, "cut by ?by", **OFFSET)), seven(lines("touch far by", "touch remote by", "cut far -far", **FAR))), skills="the sharp discriminant"),
    group("nearly", "The line passes the circle by 1e-13 to 0.9 of the radius, in every direction.", doubles.rounded(tried(hairlines.nearly(10**20, 10**25))), cases=160, skills="full precision"),
    group("huge", "Ints and doubles up to 2**64 to 2**97: what no int of 64 bits holds.", doubles.huge, skills="integers of any size"),
    group("uneven", "Each number has a size of its own: of thirty lines the one that doubles get most wrong. Or some are far smaller and count.", either(*2 * [doubles.worst(either(doubles.uneven, doubles.small_radius(doubles.uneven)), 30)], partly, along), cases=120, skills="bound every rounding"),
    group("tiny", "Numbers of about 1e-20, some of them a unit in their last place off.", doubles.ulps(seven(lines(*TOUCH, **TINY)), 1), skills="no absolute epsilon"),
    group("centre", "The line runs through C or nearly so, and along an axis or nearly so: Δ is r²·a, and no other term widens it.", either(seven(lines("through ?by ?by", "off-centre ?by ?by", **{**BIG, "turn": "axis"})), seven(lines("through ?by ?by", **STEEP)), tried(heavy)), cases=75, skills="bound every rounding"),
    group("all-lost", "dx and fy lose nearly half a unit of their last place to one side, and their product another: r is 0 or nothing beside k.", either(*2 * [tried(one_sided)], tried(all_lost)), cases=75, skills="bound every rounding"),
    group("vanishing", "Doubles make k nothing at all, and it is nearly the most that three roundings can lose; or the other way round.", tried(doubles.vanishing), cases=90, skills="the sharp discriminant"),
]
