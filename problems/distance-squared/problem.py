"""The distance of two points, squared: whole numbers of any sign, no root."""

from judge.geometry import whole
from judge.geometry.hooks import hooks
from judge.geometry.scenes import signs
from judge.problem.declare import group

HOOKS = hooks("two points")
SKILL = "distance squared"


def solve(P, Q):
    return whole.square(P, Q)


def level(draw):
    A, B, _ = signs.level((4, 100))(draw)
    return A, (B if draw.integer(0, 4) else A)


GROUPS = [
    group("small", "Two points anywhere, their coordinates up to 9.", signs.scattered("pp", 9), cases=120, skills=SKILL),
    group("level", "Two points side by side, one above the other, or one and the same.", level, skills=SKILL),
    group("middling", "Coordinates of up to some 100,000: their squares leave 32 bits, and doubles hold them.", signs.scattered("pp", 24_000, 33_000, 50_000, 100_000), cases=120, skills=SKILL),
    group("large", "Coordinates of up to 1,000,000,000, whose squares doubles do not hold.", signs.scattered("pp", 10**6, 10**8, 10**8, 10**9), cases=160, skills=SKILL),
    group("repeated", "Neighbouring calls differ in one point.", signs.scattered("pp", 9), turns=True, skills=SKILL),
]
