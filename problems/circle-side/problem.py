"""Whether a point is inside a circle, on it or outside: two squares of whole numbers compared."""

from judge.geometry import whole
from judge.geometry.hooks import hooks
from judge.geometry.scenes import either, signs
from judge.problem.declare import group

HOOKS = hooks("point")
SKILL = "compare squares"


def solve(cx, cy, r, P):
    return whole.sign(whole.square((cx, cy), P) - r * r)


def inside_next(draw):
    """P is outside by nearly a whole unit: inside the circle of radius r + 1, by as little as whole numbers allow."""
    size = draw.choice((10, 100, 10**5, 10**9))
    x, y, r = signs.near_circle(draw, size // 2, -1)
    if r == 1:
        draw.reject()
    (cx, cy), P = signs.fitted(draw, size, [(0, 0), (x, y)])
    return cx, cy, r - 1, P


def level(draw):
    """P is level with C, or right above or below it, but for some units, and a unit at most from the circle."""
    r = draw.choice((10**9, draw.integer(10, 99) * 10 ** draw.choice((0, 2, 4, 6, 7, 7)) + draw.integer(-1, 1)))
    (cx, cy), P = signs.fitted(draw, 10**9, [(0, 0), (draw.integer(0, 9), r + draw.choice((0, 0, 1, -1, -1)))])
    return cx, cy, r, P


GROUPS = [
    group("small", "All numbers up to 5.", signs.scattered("nnrp", 5), cases=120, skills=SKILL),
    group("on-the-circle", "P is on the circle, of any size, straight beside the centre or in any direction.", signs.beside_circle((10, 100, 10**9), 0), cases=80, skills=SKILL),
    group("close", "P is beside the circle by as little as whole numbers allow, or by a unit and less.", either(*3 * [signs.beside_circle((100, 10**5, 10**9, 10**9), 1, -1)], level), cases=300, skills=SKILL),
    group("middling", "Numbers of up to some 100,000, whose squares leave 32 bits, or of up to 1,000,000,000.", either(*8 * [signs.scattered("nnrp", 24_000, 33_000, 50_000, 100_000, 10**9)], inside_next), cases=180, skills=SKILL),
    group("repeated", "Neighbouring calls differ in one argument.", signs.scattered("nnrp", 5), turns=True, skills=SKILL),
]
