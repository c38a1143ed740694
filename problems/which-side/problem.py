"""The side of a line that a point is on: the sign of a cross product of whole numbers."""

from math import gcd

from judge.geometry import whole
from judge.geometry.hooks import hooks
from judge.geometry.scenes import either, signs
from judge.problem.declare import group

HOOKS = hooks("side")
SKILL = "which side of a line"


def solve(A, B, P):
    return whole.sign(whole.cross(A, B, P))


def across(draw):
    """A and B are near opposite corners of all the room that there is, and P is beside the line by as little as can be."""
    size = draw.choice((9 * 10**7, 10**8, 10**9))
    way = 2 * size - draw.integer(0, size // 5), 2 * size - draw.integer(0, size // 5)
    if gcd(*way) != 1:
        draw.reject()
    A, B, P = signs.fitted(draw, size, [(0, 0), way, signs.across(way, draw.sign(), 0)])
    return (A, B, P) if draw.boolean() else (B, A, P)


def aside(draw):
    """Two of the points are next to each other, and the third one is far away and hardly aside from an axis: a step decides."""
    near = draw.choice((0, 0, 0, 0, 1, -1)), draw.choice((1, 1, 2)) * draw.sign()
    points = signs.fitted(draw, 10**9, [(0, 0), signs.hardly(draw, 10**9), near])
    turn = draw.integer(0, 2)
    return tuple(points[turn:] + points[:turn])


def golden(draw):
    """Neighbouring Fibonacci numbers: of all slopes these take Euclid longest, and P is beside the line by 1."""
    ways = [(1, 1)]
    for _ in range(draw.integer(42, 44)):
        ways.append((sum(ways[-1]), ways[-1][0]))
    (p, q), (u, v) = ways[-1], ways[-2]
    turn, side = draw.choice((1, -1)), draw.sign()
    A, B, P = signs.fitted(draw, 10**9, [(0, 0), (p * side, q), (u * side, v)])
    A, B, P = (point[::turn] for point in (A, B, P))
    return (A, B, P) if draw.boolean() else (A, P, B)


def carried(draw):
    """A number is the largest, or it is the least and the one before it is one more: a key packed too tightly has one place for both."""
    numbers, at, end = [0, 0, 5, -2, 7, 5], draw.integer(0, 4), draw.boolean()
    numbers[at : at + 2] = (numbers[at], 10**9) if end else (numbers[at] + 1, -(10**9))
    return tuple(numbers[:2]), tuple(numbers[2:4]), tuple(numbers[4:])


def lost(A, B, P):
    """Whether a sum of the six products in doubles is off by more than 300, and gives the other side."""
    found, exact = 0.0, whole.cross(A, B, P)
    for (x, y), (u, v) in ((A, B), (B, P), (P, A)):
        found = found + float(x) * v - float(y) * u
    return abs(found) > 300 and found * exact <= 0


def bordering(draw):
    """Three points along a border of all the room that there is: their products are the largest, and what they add up to is 0, 1 or -1."""
    for _ in range(50):
        parts = draw.integer(2, 12)
        way = draw.integer(0, 10**8) // parts, (2 * 10**9 - draw.integer(0, 10**8)) // parts
        if gcd(*way) == 1:
            P = signs.across(way, draw.choice((0, 1, -1)), draw.integer(1, parts - 1))
            x, y = draw.integer(0, 10**8) - 10**9, draw.integer(-(10**9), 10**9 - parts * way[1])
            points = [(x + u, y + v) for u, v in ((0, 0), (parts * way[0], parts * way[1]), P)]
            turn = draw.integer(0, 2)
            points = points[turn:] + points[:turn]
            if lost(*points):
                side, back = draw.sign(), draw.choice((1, -1))
                return tuple((x * side, y)[::back] for x, y in points)
    return draw.reject()


GROUPS = [
    group("small", "Three points anywhere, their coordinates up to 4: every direction comes up.", signs.scattered("ppp", 4), cases=120, skills=SKILL),
    group("on-the-line", "P is on the line: between A and B, at one of them, or beyond.", signs.beside_line((6, 100, 10**9), 0), cases=80, skills=SKILL),
    group("close", "P is beside the line by as little as whole numbers allow.", either(*8 * [signs.beside_line((100, 10**4, 10**6, 10**9, 10**9), 1, -1, 2, -2, 5, -5)], *3 * [across], *2 * [aside], bordering, golden), cases=480, skills=SKILL),
    group("middling", "Coordinates of up to some 100,000, whose products leave 32 bits, or of up to 1,000,000,000.", either(*7 * [signs.scattered("ppp", 33_000, 50_000, 100_000, 10**9)], carried), cases=232, skills=SKILL),
    group("repeated", "Neighbouring calls differ in one point.", signs.scattered("ppp", 4), turns=True, skills=SKILL),
]
