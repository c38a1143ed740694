"""Katas without bands: their exact answers against other formulas in 80 digits and more, on 1,000 cases each.

Where a case has so many digits that 80 do not tell, the digits grow until they do.
"""

from __future__ import annotations

from collections import Counter
from decimal import Decimal, localcontext
from fractions import Fraction
from itertools import chain, islice
from pathlib import Path

import pytest

from judge.data import load_data
from judge.data.module import load_module
from judge.problem.load import load_problem

PROBLEMS = Path(__file__).parents[2] / "problems"
CASES = 1000


def exact_segment(cx, cy, r, a, b):
    """The roots in t themselves, in four times the digits of the largest number, and 80 more."""
    digits = max(len(str(abs(x))) for x in (cx, cy, r, *a, *b))
    with localcontext(prec=8 * digits + 80):
        hair = Decimal(10) ** -(4 * digits + 40)
        dx, dy, fx, fy = map(Decimal, (b[0] - a[0], b[1] - a[1], a[0] - cx, a[1] - cy))
        square = dx * dx + dy * dy
        if not square:
            return int(abs((fx * fx + fy * fy).sqrt() - r) < hair)
        foot = -(fx * dx + fy * dy) / square
        x, y = fx + foot * dx, fy + foot * dy
        half = (Decimal(r) ** 2 - x * x - y * y) / square
        if half < -hair:
            return 0
        if half <= hair:
            return int(-hair <= foot <= 1 + hair)
        return sum(-hair <= t <= 1 + hair for t in (foot - half.sqrt(), foot + half.sqrt()))


def quadratic_roots(a, b, c):
    """By completing the square; in as many digits as doubles of 2**±600 and their products have, and more."""
    with localcontext(prec=1000):
        a, b, c = Decimal(a), Decimal(b), Decimal(c)
        if not a:
            return (None if not c else []) if not b else [-c / b / 2]
        middle, square = -b / a, (b / a) ** 2 - c / a
        if abs(square) <= Decimal("1e-500") * (b / a) ** 2:
            return [middle]
        return [] if square < 0 else [middle - square.sqrt(), middle + square.sqrt()]


def discriminant(cx, cy, r, ax, ay, bx, by):
    """b² − a·c and the width that the statement allows, in as many digits as doubles of 1e-30 have."""
    with localcontext(prec=1000):
        cx, cy, r, ax, ay, bx, by = map(Decimal, (cx, cy, r, ax, ay, bx, by))
        dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
        a, b, c = dx * dx + dy * dy, fx * dx + fy * dy, fx * fx + fy * fy - r * r
        k, whole = abs(dx * fy - dy * fx), abs(dx * fy) + abs(dy * fx)
        return b * b - a * c, (r * r * a + whole * k) / 2**46 + whole * whole / 2**98


def sign(*case):
    """Of b² − a·c."""
    delta, _ = discriminant(*case)
    return (delta > 0) - (delta < 0)


def equal_enclosure(exact, other):
    return tuple(map(Fraction, other)) == (exact.x, exact.width)


def equal(exact, other):
    return exact == other


def equal_roots(exact, other):
    """Alike to 80 digits, each root by itself."""
    if exact is None or other is None:
        return exact is other
    with localcontext(prec=1000):
        surds = [each.x for each in exact]
        found = [(Decimal(x.p) + Decimal(x.q) * Decimal(x.d).sqrt()) / Decimal(x.s) for x in surds]
        hairs = [Decimal("1e-80") * (abs(x) or max(map(abs, other))) for x in found]
        pairs = zip(found, other, hairs, strict=True)
        return all(abs(x - y) <= hair for x, y, hair in pairs) and found == sorted(found)


KATAS = {  # the other formula, whether an exact answer is alike, and how many different kinds of answers
    "exact-segment": (exact_segment, equal, 3),
    "adaptive": (sign, equal, 3),
    "error-bound": (discriminant, equal_enclosure, 100),
    "stable-roots": (quadratic_roots, equal_roots, 100),
}


@pytest.mark.parametrize("name", KATAS)
def test_the_exact_answer_is_that_of_another_formula(name):
    formula, alike, kinds = KATAS[name]
    problem = load_problem(PROBLEMS / name)
    solve = load_module(problem).solve
    seeds = (None, 1, 2)
    data = (load_data(problem, seed=seed, cache=False) for seed in seeds)
    cases = list(islice(chain.from_iterable(g.cases[:300] for each in data for g in each.groups), CASES))
    assert len(cases) == CASES
    answered = Counter()
    for case in cases:
        solved = solve(*case)
        assert solved.broken is None
        assert alike(solved.answer, formula(*case)), case
        answered[str(solved.answer)] += 1
    assert len(answered) >= kinds
