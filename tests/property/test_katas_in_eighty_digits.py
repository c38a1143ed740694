"""Exact answers of katas against other formulas in 80 digits, on the shipped cases and on fresh ones."""

from __future__ import annotations

from decimal import Decimal, localcontext
from fractions import Fraction
from itertools import chain, islice
from pathlib import Path

import pytest

from judge.data import load_data
from judge.data.module import load_module
from judge.problem.load import load_problem
from judge.values import Real

PROBLEMS = Path(__file__).parents[2] / "problems"
CASES = 1000
CLOSE = Decimal("1e-75")  # of the extent; the arithmetic has digits to spare
SNAP = Decimal("1e-12")


def exactly(x):
    return Decimal(x)  # of an int or a double, without rounding


def vec(point):
    return tuple(map(exactly, point))


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1]


def norm(p):
    return dot(p, p).sqrt()


def reach(*vectors):
    return max(abs(x) for vector in vectors for x in vector)


def distance(a, b, p):
    """By the foot, which costs digits that there are."""
    if vec(a) == vec(b):
        return None
    _, nearest = foot(a, b, p)
    return norm(minus(vec(p), nearest))


def foot(a, b, c):
    """By Cramer's rule: where A + t·D meets the perpendicular through C."""
    (ax, ay), (bx, by), (cx, cy) = vec(a), vec(b), vec(c)
    dx, dy = bx - ax, by - ay
    if not dx and not dy:
        return None
    # dy·x − dx·y = dy·Ax − dx·Ay and dx·x + dy·y = dx·Cx + dy·Cy
    line, across = dy * ax - dx * ay, dx * cx + dy * cy
    bottom = dx * dx + dy * dy
    x, y = (line * dy + across * dx) / bottom, (dy * across - dx * line) / bottom
    t = (x - ax) / dx if abs(dx) > abs(dy) else (y - ay) / dy
    return t, (x, y)


def normal_form(a, b):
    """By the unit vector of B − A turned to the left; c by the point B."""
    d = minus(vec(b), vec(a))
    if d == (0, 0):
        return None
    turned = -d[1] / norm(d), d[0] / norm(d)
    return *turned, -dot(turned, vec(b))


def on_circle(cx, cy, r, p):
    """By the length itself."""
    f, r = minus(vec(p), vec((cx, cy))), exactly(r)
    gap = norm(f) - r
    if abs(gap) <= SNAP * max(r, reach(f)):
        return 0
    return 1 if gap > 0 else -1


ANSWERS = {
    "distance": distance,
    "foot": foot,
    "normal-form": normal_form,
    "on-circle": on_circle,
}


def number(real):
    x = real.x
    if isinstance(x, int | Fraction):
        return Decimal(x.numerator) / Decimal(x.denominator)
    return (Decimal(x.p) + Decimal(x.q) * Decimal(x.d).sqrt()) / Decimal(x.s)


def same(exact, other):
    """Whether two answers are alike: each number within a hair of its own unit."""
    if isinstance(exact, Real):
        unit = number(Real(exact.unit))
        return unit > 0 and abs(number(exact) - other) <= CLOSE * unit
    if isinstance(exact, list | tuple):
        return (
            isinstance(other, list | tuple)
            and len(exact) == len(other)
            and all(same(*pair) for pair in zip(exact, other, strict=True))
        )
    return exact == other


@pytest.mark.parametrize("name", ANSWERS)
def test_the_exact_answer_is_that_of_another_formula(name):
    problem = load_problem(PROBLEMS / name)
    solve = load_module(problem).solve
    data = (load_data(problem, seed=seed, cache=False) for seed in (None, 1, 2))
    cases = list(islice(chain.from_iterable(g.cases for each in data for g in each.groups), CASES))
    assert len(cases) == CASES
    answered = set()
    with localcontext(prec=400):
        for case in cases:
            exact, broken = solve(*case).answer, solve(*case).broken
            assert broken is None
            assert same(exact, ANSWERS[name](*case)), case
            answered.add(type(exact))
    assert len(answered) == 2 or name == "on-circle", "an answer and None, at least"
