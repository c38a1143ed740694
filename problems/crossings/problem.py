"""How many points a circle and a line have in common, in small whole numbers: the sign of one difference."""

from judge.geometry import whole
from judge.geometry.hooks import hooks
from judge.geometry.scenes import signs, tried
from judge.problem.declare import group

HOOKS = hooks("line")
SKILL = "count by a sign"


def solve(cx, cy, r, A, B):
    whole.distinct(A, B)
    return whole.count_line(cx, cy, r, A, B)


GROUPS = [
    group("small", "All numbers up to 5: every direction comes up.", signs.scattered("nnrpp", 5), cases=150, skills=SKILL),
    group("touching", "The line touches the circle, upright, level or in any direction.", signs.cuts(20, close=False), cases=80, skills=SKILL),
    group("close", "The line cuts or misses the circle by as little as numbers up to 20 allow.", tried(signs.cuts(20, close=True)), cases=200, skills=SKILL),
    group("anywhere", "All numbers up to 20, and the line anywhere: products leave 16 bits.", signs.scattered("nnrpp", 20), cases=120, skills=SKILL),
    group("repeated", "Neighbouring calls differ in one argument.", signs.scattered("nnrpp", 6), turns=True, skills=SKILL),
]
