"""The foot of the perpendicular on a horizontal or vertical line: one coordinate of the point, one of the line."""

from judge.geometry import whole
from judge.geometry.hooks import hooks
from judge.geometry.scenes import either, signs, tried
from judge.problem.declare import group

HOOKS = hooks("foot on an axis")
SKILL = "foot on a simple line"


def solve(A, B, P):
    return whole.axis_foot(A, B, P)


def beyond(draw, size):
    """A and B, and P beyond one of them or just above it."""
    a, b = draw.integer(-size, size - 2), draw.integer(-size, size - 1)
    return (a, b, draw.integer(max(a, b), size)) if draw.boolean() else (-a, -b, -draw.integer(max(a, b), size))


def neighbours(draw, size):
    """A and B are next to each other, and P is near the end of the bounds."""
    a = draw.integer(-9, 9)
    return a, a + draw.sign(), (size - draw.integer(0, size // 20)) * draw.sign()


def beside(draw, size):
    """The foot is a few steps from A, and B a few steps or as far as can be."""
    side, least = draw.sign(), size - size // 20
    a = draw.choice((draw.integer(-9, 9), draw.integer(-9, 9), -side * draw.integer(least, size - 9)))
    b = draw.choice((a + draw.integer(1, 9) * draw.sign(), side * draw.integer(least, size)))
    return a, b, a + draw.integer(-2, 2)


def upright(draw):
    """P is a step from above A or from level with it, and as far away as can be; the line goes either way."""
    a, b = draw.integer(-9, 9), draw.integer(-9, 9)
    top, bottom, turn = draw.integer(9 * 10**8, 10**9), -draw.integer(6 * 10**8, 10**9), draw.choice((1, -1))
    A, P = (a, bottom), (a + draw.sign(), top)
    B = draw.choice(((b, bottom), (a, draw.choice((b, top))))) if a != b else draw.reject()
    return tuple(each[::turn] for each in (A, B, P))


def brim(draw, size):
    """A and B are the end of the bounds and its neighbour, and P is on the other side of 0."""
    side, more = draw.sign(), draw.integer(0, 1)
    return side * (size - more), side * (size - 1 + more), -side * draw.integer(size * 3 // 5, size)


def rounded(draw, size):
    """The foot is near 0, and doubles round f/D times D, the way to it from A."""
    a, b, p = draw.integer(-size, size), draw.integer(-size, size), draw.integer(-9, 9)
    if a == b or (p - a) / (b - a) * (b - a) == p - a:
        draw.reject()
    return a, b, p


GROUPS = [
    group("small", "All coordinates up to 4.", signs.level((4,)), cases=140, skills=SKILL),
    group("beyond", "The foot is not between A and B, or just at one of them.", signs.level((6, 100), beyond), cases=80, skills=SKILL),
    group("large", "Coordinates of up to 1,000,000,000.", either(*2 * [signs.level((100, 10**4, 10**9))], signs.level((10**9,), neighbours), *2 * [signs.level((10**6, 10**9, 10**9), beside)], upright, signs.level((10**9,), brim)), cases=175, skills=SKILL),
    group("rounded", "A part of the way to the foot is rounded in floats.", tried(signs.level((10**4, 10**9), rounded)), skills=SKILL),
    group("repeated", "Neighbouring calls differ in one point.", signs.level((3,)), turns=True, skills=SKILL),
]
