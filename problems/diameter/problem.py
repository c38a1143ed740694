"""Whether a point is inside the circle with a given diameter, on it or outside, in whole numbers."""

from judge.geometry import whole
from judge.geometry.hooks import hooks
from judge.geometry.scenes import signs
from judge.problem.declare import group

HOOKS = hooks("diameter")
SKILL = "doubled, not halved"


def solve(A, B, P):
    return whole.sign(whole.dot(A, B, P))


GROUPS = [
    group("small", "Three points anywhere, their coordinates up to 4: the centre is whole or not.", signs.scattered("ppp", 4), cases=120, skills=SKILL),
    group("on-the-circle", "P is on the circle: A and B are seen from it at a right angle.", signs.right_angles((6, 100, 10**9), 0), cases=120, skills=SKILL),
    group("close", "P is beside the circle by as little as whole numbers allow.", signs.right_angles((100, 10**4, 10**6, 10**9, 10**9), 1, -1, 2, -2, 5, -5), cases=240, skills=SKILL),
    group("middling", "Coordinates of up to some 100,000, whose products leave 32 bits, or of up to 1,000,000,000.", signs.scattered("ppp", 24_000, 33_000, 50_000, 100_000, 10**9, 10**9), cases=240, skills=SKILL),
    group("repeated", "Neighbouring calls differ in one point.", signs.scattered("ppp", 4), turns=True, skills=SKILL),
]
