"""Many circles in three columns and one line: how many points each has in common with it."""

from functools import partial
from math import ldexp

from judge.geometry import plain
from judge.geometry.hooks import hooks
from judge.geometry.rows import counts
from judge.geometry.scenes import BIG, DECIMALS, HUGE, NEAR, OFFSET, PLAIN, TINY, any_columns, columns, either, million, ratios, telling
from judge.problem.declare import group

HOOKS = hooks("rows")
ALL = "cut", "cut", "touch", "miss"
SCALES = columns("touch~", "touch", "cut", octaves=(8, 31), **{**NEAR, "shift": -40})
TELLING = plain.counts, partial(plain.counts, tolerance=1e-10)


def solve(cx, cy, r, A, B):
    return counts(cx, cy, r, A, B)


def upright(draw):
    """Touches at A by circles that are level with it but for a hundredth or less, or upright of it, and millions of times as far as B."""
    m, turn = 1 << draw.integer(8, 12), draw.choice((1, -1))
    radii = [ldexp(draw.integer(1 << 20, 1 << 28), -24) for _ in range(draw.integer(8, 24))]
    sides = [r * draw.sign() for r in radii]
    columns = [-2 * m * n for n in sides], [(m * m - 1) * n for n in sides]
    cx, cy = map(tuple, columns[::turn])
    return cx, cy, tuple([(m * m + 1) * r for r in radii]), (0, 0), (ldexp(m * m - 1, -24), ldexp(m, -23))[::turn]


def aside(draw):
    """A line hardly leaving an axis and circles on that axis, or a line along it and circles hardly beside that: far away, and small."""
    n, off = draw.integer(2**20, 2**27) * 2.0 ** draw.choice((0, -20, -60)), draw.integer(3, 9) * draw.sign() * 10.0 ** -draw.choice((7, 7, 7, 6, 5))
    leaning, turn, rows = draw.integer(0, 2) > 0, draw.choice((1, -1)), []
    for _ in range(draw.integer(8, 24)):
        y = n * draw.integer(8, 16) / 8
        x, r = (0.0 if leaning else y * off), abs(y * off) * draw.choice((0.0, 0.5, 1.5))
        rows.append((*(x, y)[::turn], r))
    A, B = (0.0, 0.0), (n * off if leaning else 0.0, n)[::turn]
    return *zip(*rows, strict=True), *((A, B) if draw.boolean() else (B, A))


def thousands(draw):
    """A thousand circles or more, of very different sizes, some of them alike."""
    *rows, A, B = SCALES(draw)
    count = draw.integer(1000, 2000)
    return *((column * (count // len(column) + 1))[:count] for column in rows), A, B


def ended(draw):
    """A million circles, of which the last one, and the last of each 2**16, are around A: the line meets them."""
    *centres, r, A, B = million(1_000_000, 2000, 200, 26)(draw)
    centres = [list(column) for column in centres]
    for column, at in zip(centres, A, strict=True):
        column[65_535::65_536], column[-1] = [at] * 15, at
    return *map(tuple, centres), r, A, B


def parts(draw):
    """One circle that the line nearly touches."""
    cx, cy, r, A, B = ratios(near=True)(draw)
    return (cx,), (cy,), (r,), A, B


def corners(draw):
    """A and B are ints in opposite corners, or off these by a few units, and circles of any size are between them."""
    off = draw.choice((0, 0, 0, 9))
    A = [(2**30 - draw.integer(0, off)) * draw.sign() for _ in "xy"]
    B = [(draw.integer(0, off) - 2**30) * (1 if each > 0 else -1) for each in A]
    rows = []
    for _ in range(draw.integer(8, 24)):
        r = draw.integer(2**10, 2**28) >> draw.integer(0, 10)
        rows.append([float(n) for n in (draw.integer(-(2**28), 2**28), draw.integer(-(2**28), 2**28), r)])
    return *map(tuple, zip(*rows, strict=True)), tuple(A), tuple(B)


def lengths(draw):
    """2,000 to 30,000 circles, of which the last ones, some 1 to 15, are around A: the line meets them. Or one more than 1,024, 2,048 and so on."""
    least = 2000 << draw.integer(0, 3)
    count = draw.integer(least // 16, least * 15 // 8 // 16) * 16 + draw.integer(1, 15)
    if draw.boolean():
        count = (1024 << draw.integer(1, 4)) + 1
    *centres, r, A, B = million(count, 2000, 200, 26)(draw)
    last = draw.integer(1, count % 16)
    centres = [column[:-last] + (float(at),) * last for column, at in zip(centres, A, strict=True)]
    return *centres, r, A, B


INTERVIEW = [
    group("few", "Up to forty circles that cut the line, touch it or miss it.", columns(*ALL, count=(1, 40), **PLAIN), skills="distance against radius"),
    group("one", "A single circle: an array of one number.", columns(*ALL, count=(1, 1), **PLAIN), cases=30, skills="nothing at all"),
    group("empty", "No circle at all: an empty array.", columns("cut", count=(0, 0), **PLAIN), cases=5, skills="nothing at all"),
    group("touch", "Circles that the line touches, among others.", columns("touch", "touch", "cut", "miss", count=(1, 12), **PLAIN), skills="collapse the tangent"),
    group("points", "Circles of radius 0, on the line and beside it.", columns("dot", "dot-miss", "cut", count=(1, 12), **PLAIN), skills="r = 0"),
    group("repeated", "Neighbouring calls differ in one argument.", any_columns(4, 6), turns=True, skills="nothing kept between calls"),
]

PRODUCTION = [  # the same, where rounding bites
    group("decimals", "Touches in short decimals, which == does not see.", telling(columns("touch", "touch", "cut", count=(10, 30), **DECIMALS), *TELLING), skills="collapse the tangent"),
    group("touch-full", "Touches that no formula in floats can see, also by circles beside which A and B are close together.", either(columns("touch", "cut", count=(8, 24), **{**HUGE, "size": 2**36}), columns("touch", "cut", count=(8, 24), octaves=(20, 31), **{**HUGE, "size": 2**36, "move": 0}), upright), cases=75, skills="a tangent has a width"),
    group("near", "Circles that miss or cut the line by 1e-7 of their size, or by more where the line or the circle hardly leaves an axis.", either(columns("touch~", "touch~", "touch", "dot~", **NEAR), aside), cases=80, skills="nearly is not touching"),
    group("small-parts", "A coordinate, a product or the short side of a triangle is tiny beside the others, and decides.", parts, skills="distance against radius"),
    group("mixed-scale", "Circles of very different sizes in one array: each has a size of its own.", either(*2 * [SCALES], thousands), cases=42, skills="each by its own size"),
    group("far-end", "A and B are thousands of sizes apart, or millions: that is the size of the circles.", either(columns("touch", "cut", "touch~", along=5000, **{**NEAR, "size": 2**5}), columns("touch", along=10**8, **{**NEAR, "size": 2**5, "shift": (-20, -40)})), cases=45, skills="each by its own size"),
    group("tiny", "All of it tiny, down to 1e-29.", columns("touch", "touch~", "cut", **TINY), cases=30, skills=("no absolute epsilon", "scale invariance")),
    group("offset", "Small circles far from the plane's origin.", columns("touch", "touch~", "cut", "miss", **OFFSET), cases=30, skills="far from the origin"),
    group("integers", "Whole numbers as doubles: products of four do not fit into 64 bits.", columns("touch", "cut", "miss", **{**BIG, "size": 2**12, "move": 20, "shift": 0}), cases=30, skills="whole numbers that are large"),
    group("corners", "A and B in opposite corners of all that there is, in ints: products of their differences have 64 bits.", corners, cases=10, skills="whole numbers that are large"),
    group("lengths", "Two thousand to thirty thousand circles, and no number of them that sixteen divides: the last ones count.", lengths, cases=16, skills="arrays, not objects"),
    group("million", "A million circles, a few of which touch the line or nearly do: arithmetic on whole arrays, or too slow.", ended, cases=2, size=1_000_000, time_limit=4, skills="arrays, not objects"),
]
