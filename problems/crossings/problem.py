"""How many points a circle and a line have in common, in small whole numbers: the sign of one difference."""

from functools import partial

from judge.geometry import whole
from judge.geometry.hooks import hooks
from judge.geometry.scenes import either, signs, tried
from judge.problem.declare import group

HOOKS = hooks("line")
SKILL = "count by a sign"


def solve(cx, cy, r, A, B):
    whole.distinct(A, B)
    return whole.count_line(cx, cy, r, A, B)


def ended(draw, reach, sizes):
    """A or B is on a circle, and the line anywhere: it cuts the circle, or touches it there."""
    *circle, on = signs.beside_circle(sizes, 0)(draw)
    other = draw.integer(-reach, reach), draw.integer(-reach, reach)
    return (*circle, on, other) if draw.boolean() else (*circle, other, on)


def carried(draw):
    """A number is 20, or it is -20 and the one before it is one more: a key packed too tightly has one place for both, which differ."""
    base, at = draw.integer(0, 1), draw.choice((0, 3, 4, 5))
    numbers = [base, 0, 5 + base, -5, 3, 5, 3 - base]
    both = []
    for more, last in ((0, 20), (1, -20)):
        cx, cy, r, *ends = (*numbers[:at], numbers[at] + more, last, *numbers[at + 2 :])
        both.append((cx, cy, r, tuple(ends[:2]), tuple(ends[2:])))
    if solve(*both[0]) == solve(*both[1]):
        draw.reject()
    return draw.choice(both)


GROUPS = [
    group("small", "All numbers up to 5: every direction comes up.", either(*5 * [signs.scattered("nnrpp", 5)], partial(ended, reach=5, sizes=(2, 5))), cases=180, skills=SKILL),
    group("touching", "The line touches the circle, upright, level or in any direction.", signs.cuts(20, close=False), cases=80, skills=SKILL),
    group("close", "The line cuts or misses the circle by as little as numbers up to 20 allow.", tried(signs.cuts(20, close=True)), cases=200, skills=SKILL),
    group("anywhere", "All numbers up to 20, and the line anywhere: products leave 16 bits.", either(*9 * [signs.scattered("nnrpp", 20)], partial(ended, reach=20, sizes=(20,)), *3 * [carried]), cases=168, skills=SKILL),
    group("repeated", "Neighbouring calls differ in one argument.", signs.scattered("nnrpp", 6), turns=True, skills=SKILL),
]
