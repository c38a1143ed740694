"""The distance of two points, squared: whole numbers of any sign, no root."""

from math import isqrt

from judge.geometry import whole
from judge.geometry.hooks import hooks
from judge.geometry.scenes import either, signs
from judge.problem.declare import group

HOOKS = hooks("two points")
SKILL = "distance squared"


def solve(P, Q):
    return whole.square(P, Q)


def level(draw):
    A, B, _ = signs.level((4, 100))(draw)
    return A, (B if draw.integer(0, 4) else A)


def aligned(draw):
    """Side by side, one above the other, or on a diagonal, some 10,000,000 to 2,000,000,000 apart."""
    size, way = draw.choice((10**7, 10**8, 10**9, 10**9)), draw.choice(((1, 0), (1, 1), (1, -1)))
    long = draw.integer(size, 2 * size)
    return tuple(signs.fitted(draw, size, [(0, 0), (way[0] * long, way[1] * long)]))


def aside(draw):
    """Far apart, and one or two steps aside from an axis or a diagonal."""
    off, far = signs.hardly(draw, 10**9)
    P, Q = signs.fitted(draw, 10**9, [(0, 0), draw.choice(((off, far), (far + off, far)))])
    return (P, Q) if draw.boolean() else (Q, P)


def brink(draw):
    """The square is odd and 1 to 4 times 2**53, mostly just above that, and the points mostly lie diagonally."""
    long = draw.integer(94_906_270, draw.choice((95_900_000, 95_900_000, 10**8, 19 * 10**7)))
    x = long * draw.integer(*draw.choice(((702, 712), (702, 712), (0, 999)))) // 1000 | 1
    y = isqrt(long * long - x * x) + 2 & ~1
    x, y = x * draw.sign(), y * draw.sign()
    apart = (x, y)[:: draw.choice((1, -1))]
    middle = draw.choice((99, 10**6, 10**8))
    P = tuple(draw.integer(-middle, middle) - each // 2 for each in apart)
    return P, tuple(at + each for at, each in zip(P, apart, strict=True))


GROUPS = [
    group("small", "Two points anywhere, their coordinates up to 9.", signs.scattered("pp", 9), cases=120, skills=SKILL),
    group("level", "Two points side by side, one above the other, or one and the same.", level, skills=SKILL),
    group("middling", "Coordinates of up to some 100,000: their squares leave 32 bits, and doubles hold them.", signs.scattered("pp", 24_000, 33_000, 50_000, 100_000), cases=120, skills=SKILL),
    group("brink", "Squares whose sum is just more than doubles hold, up to a few times that, and odd.", brink, cases=45, skills=SKILL),
    group("large", "Coordinates of up to 1,000,000,000, whose squares doubles do not hold.", either(*4 * [signs.scattered("pp", 10**6, 10**8, 10**8, 10**9)], *2 * [aligned], *2 * [aside]), cases=230, skills=SKILL),
    group("repeated", "Neighbouring calls differ in one point.", signs.scattered("pp", 9), turns=True, skills=SKILL),
]
