"""Whether a point is inside the circle with a given diameter, on it or outside, in whole numbers."""

from math import gcd, isqrt, sqrt

from judge.geometry import whole
from judge.geometry.hooks import hooks
from judge.geometry.scenes import either, signs, tried
from judge.problem.declare import group

HOOKS = hooks("diameter")
SKILL = "doubled, not halved"


def solve(A, B, P):
    return whole.sign(whole.dot(A, B, P))


def oblong(draw):
    """On the circle, and one of A and B is farther away from P than the other."""
    root = isqrt(draw.choice((100, 10**9)))
    (x, y), a, b = signs.direction(draw, root), draw.integer(root // 9, root), draw.integer(root // 9, root)
    if a == b:
        draw.reject()
    return tuple(signs.fitted(draw, root * root, [(a * x, a * y), (b * y, -b * x), (0, 0)]))


def uneven(A, B, P):
    """Whether the squares of the three distances, each rounded to a double, miss Pythagoras by several units in the last place."""
    a, b, c = (sqrt(whole.square(*ends)) for ends in ((A, P), (B, P), (A, B)))
    return abs(a * a + b * b - c * c) > 4e-16 * c * c


def wide(draw):
    """Beside the circle by as little as can be, and all three as far apart as there is room: A and B seen from P alike or not."""
    size, unlike = draw.choice(((10**8, False), (10**9, True)))
    a = draw.integer(900, 1800)
    b = draw.integer(1, a // 5) if unlike else a - draw.integer(1, a // 50)
    if gcd(a, b) != 1:
        draw.reject()
    times, side = 2 * size // (a + b), draw.sign()
    times -= draw.integer(2, times // 200)
    (px, py), (qx, qy) = signs.across((a, b), side, times), signs.across((a, b), side, times - 1)
    A, B, P = signs.fitted(draw, size, [(px, py), (qy, -qx), (0, 0)])
    return (A, B, P) if draw.boolean() else (B, A, P)


def aside(draw):
    """One of A and B is hardly aside from P along an axis and far away, and the other one is P, or next to it: a step decides."""
    near = draw.choice((0, 1, 1, 2)) * draw.sign(), draw.choice((0, 0, 0, 0, 1, -1))
    points = signs.fitted(draw, 10**9, [signs.hardly(draw, 10**9), near, (0, 0)])
    x, y = draw.choice(((0, 0), *points))  # the new origin, if there is room
    homed = [(u - x, v - y) for u, v in points]
    A, B, P = homed if max(abs(n) for point in homed for n in point) <= 10**9 else points
    return (A, B, P) if draw.boolean() else (B, A, P)


def eighth(draw):
    """A and B are level or on a diagonal, and P is seen from their middle in half a right angle to that, off the circle by 1e-9 to 1e-3 of it."""
    h, level, off = draw.integer(10**6, 3 * 10**8), draw.boolean(), draw.integer(1, 9) * draw.sign() / 10 ** draw.integer(4, 9)
    reach, step = round(h * (1 + off) * (sqrt(0.5) if level else sqrt(2))), draw.integer(0, 1)
    x, y = (draw.integer(-5 * 10**8, 5 * 10**8) for _ in "xy")
    end, over = (h, 0 if level else h), (reach, reach + step if level else step)
    turn, A, B, P = draw.choice((1, -1)), (x + end[0], y + end[1]), (x - end[0], y - end[1]), (x + over[0], y + over[1])
    return tuple(point[::turn] for point in ((A, B, P) if draw.boolean() else (B, A, P)))


def corners(draw):
    """Three points in corners of all that there is: twice a distance, squared, leaves 64 bits."""
    sides = [(draw.sign(), draw.sign()) for _ in range(3)]
    return tuple([tuple(side * (10**9 - draw.integer(0, 10 ** draw.integer(0, 8))) for side in each) for each in sides])


def upright(draw):
    """A and B are far from the origin along an axis, and in their middle hardly beside it: what that tells decides."""
    A, B, P = points = signs.right_angles((100, 10**4, 10**6), 0, 1, -1, 2, -2)(draw)
    most = 10**9 - max(abs(n) for point in points for n in point)
    way, over = (draw.integer(5 * 10**8 + 10**7, most) * draw.sign(), draw.choice((1, 1, -1)))
    aside = draw.integer(-1, 1) - (A[0] + B[0]) // 2
    return tuple([((x + aside, y + way)[::over]) for x, y in (A, B, P)])


GROUPS = [
    group("small", "Three points anywhere, their coordinates up to 4: the centre is whole or not.", signs.scattered("ppp", 4), cases=120, skills=SKILL),
    group("on-the-circle", "P is on the circle: A and B are seen from it at a right angle.", either(*4 * [signs.right_angles((6, 100, 10**9), 0)], tried(oblong, lambda case: uneven(*case))), cases=150, skills=SKILL),
    group("close", "P is beside the circle by as little as whole numbers allow.", either(*7 * [signs.right_angles((100, 10**4, 10**6, 10**9, 10**9), 1, -1, 2, -2, 5, -5)], *4 * [wide], *3 * [aside], *2 * [upright], *2 * [eighth]), cases=600, skills=SKILL),
    group("middling", "Coordinates of up to some 100,000, whose products leave 32 bits, or of up to 1,000,000,000.", either(*7 * [signs.scattered("ppp", 24_000, 33_000, 50_000, 100_000, 10**9, 10**9)], corners), cases=272, skills=SKILL),
    group("repeated", "Neighbouring calls differ in one point.", signs.scattered("ppp", 4), turns=True, skills=SKILL),
]
