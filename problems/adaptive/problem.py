"""The sign of Δ = r²·a − k² for doubles just as they are: no tolerance, no promise."""

from fractions import Fraction
from math import nextafter, sqrt

from judge.geometry import whole
from judge.geometry.hooks import hooks
from judge.geometry.pose import triple
from judge.geometry.scenes import BIG, FAR, HUGE, OFFSET, PLAIN, SPLIT, TINY, doubles, either, grid, hairlines, lines, tried
from judge.problem.declare import group

HOOKS = hooks("seven")
TOUCH = ("touch before after", "touch foot by", "touch ?by ?by")
LEAST = either(*2 * [lines(*TOUCH, **{**HUGE, "shift": ("least",)})], lines("touch foot by", **{**HUGE, "move": 0, "shift": ("least",)}))
seven = doubles.seven


def solve(cx, cy, r, ax, ay, bx, by):
    return whole.discriminant(*whole.held(cx, cy, r, ax, ay, bx, by)).sign


def one_way(draw):
    """k is tiny beside dx·fy and dy·fx, whose six roundings all make it too small, and Δ is just below 0."""
    step, one = 1 << draw.integer(24, 26), 1 << 52
    beyond = round((draw.integer(100, 1 << draw.integer(8, 18)) + 0.98) * one / step) - step
    for _ in range(50):
        y = draw.integer(1 << 32, 1 << 33)
        x = y + beyond
        if 0.46 < x * y % one / one < 0.5:
            break
    else:
        draw.reject()
    dx, fy, dy, fx = ((one + part) / one for part in (x, y, x + step, y - step))
    off = -draw.integer(9900, 9999) / 10000 / 2**53
    wide, high = Fraction(dx) - Fraction(off), Fraction(dy) + Fraction(off)
    k = wide * (Fraction(fy) - Fraction(off)) - high * (Fraction(fx) + Fraction(off))
    square = wide * wide + high * high
    r = float(k) / sqrt(square)
    while Fraction(r) ** 2 * square > k * k:
        r = nextafter(r, 0)
    scale = 2.0 ** draw.choice((0, -40, 20))
    return tuple(scale * part for part in (-fx, -fy, r, off, -off, dx, dy))


def slim(draw):
    """A line along an axis or hardly leaning from it, and a circle that it touches but for a unit or less: a few units decide."""
    n, p, j = draw.integer(1, 99) * 2 ** draw.choice((12, 30, 45, 60, 60)), draw.choice((0, 1, -1, 2)), draw.integer(-2, 2)
    side = draw.integer(1, 9) * draw.sign() * 2 ** draw.choice((0, draw.integer(10, 40), draw.integer(44, 49)))
    cx, start, times = draw.integer(-9, 9), draw.integer(-3, 3) * n, draw.integer(1, 2)
    ax, r = cx - j * p - side, max(0, abs(side) + draw.choice((0, 0, 1, -1)))
    turn, scale = draw.choice((1, -1)), draw.choice((1, 2.0**-40))
    C, A, B = (point[::turn] for point in ((cx, start + j * n), (ax, start), (ax + times * p, start + times * n)))
    return tuple(scale * part for part in (*C, r, *((*A, *B) if draw.boolean() else (*B, *A))))


def beyond(draw):
    """A touch of a small circle, or r is one off: A and B are so far away that whole numbers have gaps, and their differences to C are no doubles."""
    p, q, c = triple(draw, 65)
    gap, way = 1 << draw.integer(7, 12), draw.integer(1 << 52, 1 << 53) * draw.sign()
    ax, ay = (-q * way) // gap * gap, (p * way) // gap * gap
    k, on = draw.integer(1, 1 << 20), draw.integer(1, 1 << 40) * draw.sign()
    cx, cy, r = ax + q * way - p * k, ay - p * way - q * k, c * k + draw.choice((0, 0, 1, -1))
    A, B = (ax, ay), (ax - q * on * gap, ay + p * on * gap)
    return tuple(map(float, (cx, cy, r, *((*A, *B) if draw.boolean() else (*B, *A)))))


def wide(draw):
    """A level or upright touch, or a unit off one: A or B is about 1e29 away, all else is about 1e-30 or more, and differences leave no digit out."""
    r, near, far, beside = (draw.integer(2**52, 2**53) * 2.0**power * draw.sign() for power in (-draw.choice((150, 150, 145)), -151, draw.integer(43, 46), -draw.choice((150, 151))))
    cx, cy = draw.choice((0.0, 0.0, beside)), 0.0
    high = r if draw.integer(0, 2) else nextafter(r, draw.choice((0.0, 1.0)))
    turn = draw.choice((1, -1))
    C, A, B = (point[::turn] for point in ((cx, cy), (far, high), (near, high)))
    return *C, abs(r), *((*A, *B) if draw.boolean() else (*B, *A))


INTERVIEW = [
    group("plain", "Anything anywhere within a hundred units.", doubles.plain, cases=100, skills="trust a double, or do not"),
    group("touches", "Small touches, cuts and misses.", seven(lines(*TOUCH, "cut ?by ?by", "miss ?by ?by", **PLAIN)), skills="collapse the tangent"),
    group("same-point", "A and B are one point: Δ is 0.", seven(either(lines("cut before =", "touch foot =", "miss by =", **PLAIN), grid("nnrpp", 0))), skills="degenerate line"),
    group("repeated", "Neighbouring calls differ in one argument.", seven(grid("nnrpp", 5)), turns=True, skills="nothing kept between calls"),
]

PRODUCTION = [  # the same, where rounding bites
    group("touch", "Exact touches whose r²·a and k² are no doubles.", either(seven(lines(*TOUCH, **HUGE)), seven(lines(*TOUCH, **BIG)), seven(hairlines.hairlines(10**9, 10**13))), cases=90, skills="collapse the tangent"),
    group("ulp", "Touches with one number off by one unit in its last place.", either(doubles.ulps(seven(lines(*TOUCH, **BIG)), 1), doubles.ulps(seven(lines(*TOUCH, **HUGE)), 1)), cases=90, skills="trust a double, or do not"),
    group("ulps", "Touches with one number off by 3 to 30,000 units in its last place.", doubles.ulps(seven(lines(*TOUCH, **BIG)), 3, 30, 300, 3_000, 30_000), cases=120, skills="full precision"),
    group("hairline", "k is r·|D| ± 1, or Δ is ± 1, where r²·a has 24 digits and more.", either(seven(hairlines.hairlines(10**9, 10**13, 10**15, off=(1, -1))), seven(hairlines.least(10**9, 10**13, 10**15))), skills="integers of any size"),
    group("turned", "Touches turned by angles that no double holds: Δ is what rounding made of 0.", doubles.turned(seven(lines(*TOUCH, **BIG))), skills="trust a double, or do not"),
    group("through", "Lines through C but for rounding, r being 0 or nearly so.", doubles.small_radius(either(seven(lines("dot before after", "dot foot after", **SPLIT)), doubles.turned(seven(lines("dot before after", **BIG))))), cases=120, skills="the sharp discriminant"),
    group("far", "Far from the origin, or A and B far along the line.", either(seven(lines(*TOUCH, "cut by ?by", **OFFSET)), seven(lines("touch far by", "touch remote by", "cut far -far", **FAR)), seven(lines("touch far by", **{**BIG, "shift": (0, -60)})), *3 * [slim], *2 * [beyond]), cases=230, skills="the sharp discriminant"),
    group("nearly", "The line passes the circle by 1e-13 to 0.9 of the radius, in every direction.", doubles.rounded(tried(hairlines.nearly(10**20, 10**25))), cases=200, skills="full precision"),
    group("huge", "Ints and doubles up to 2**64 to 2**97: what no int of 64 bits holds.", doubles.huge, skills="integers of any size"),
    group("tiny", "Touches in numbers of about 1e-20 or 1e-29, some of them a unit in their last place off.", either(doubles.ulps(seven(lines(*TOUCH, **TINY)), 1), seven(LEAST), doubles.ulps(seven(LEAST), 1)), cases=90, skills="no absolute epsilon"),
    group("one-place", "Touches at the same place of the same circle, the other end a unit off or not.", doubles.one_place, skills="nothing kept between calls"),
    group("spread", "Numbers of 1e28 and of 1e-28 in one case: Δ is 1 where r²·a has 120 digits.", doubles.spread, skills="full precision"),
    group("wide", "Level and upright touches in numbers of 1e30 and of 1e-30: exact products have more than 300 digits.", wide, cases=36, skills="full precision"),
    group("vanishing", "Doubles make k nothing at all, and it is nearly the most that three roundings can lose; or the other way round; or k is larger, and loses as much.", either(*5 * [tried(doubles.vanishing)], tried(one_way)), cases=72, skills="the sharp discriminant"),
    group("easy", "Twenty thousand lines that doubles decide: to be exact from the start costs too much.", doubles.easy, cases=20_000, points=24, time_limit=2.5, limits={"cpu_seconds": 10}, skills="trust a double, or do not"),
]
