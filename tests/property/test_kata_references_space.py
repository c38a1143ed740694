"""Katas in space and over frames: exact answers against other formulas in 80 digits, on 1,000 cases each.

Lengths and angles are found by other ways than `solve` goes.
"""

from __future__ import annotations

from decimal import Decimal, localcontext
from fractions import Fraction
from itertools import chain, islice
from pathlib import Path

import pytest

from judge.data import load_data
from judge.data.module import load_module
from judge.exact import Surd
from judge.problem.load import load_problem

PROBLEMS = Path(__file__).parents[2] / "problems"
CASES = 1000
DIGITS = 80
SNAP = Decimal("1e-12")
CLOSE = Decimal("1e-55")  # of the unit: a root of a difference of 1e-12 keeps so many digits, and more


def exact(point):
    return tuple(Decimal(x) for x in point)  # of ints or doubles, without rounding


def dot(u, v):
    return sum(x * y for x, y in zip(u, v, strict=True))


def norm(v):
    return dot(v, v).sqrt()


def along(p, share, d):
    return tuple(x + share * y for x, y in zip(p, d, strict=True))


def ray_sphere(centre, radius, origin, way):
    """By the foot itself and the angle of the point about the centre; the side by the sign of N·D."""
    c, o, d, r = exact(centre), exact(origin), exact(way), Decimal(radius)
    if not any(d) or not r:
        return None
    f = along(o, -1, c)
    e, u = max(r, *map(abs, f)), along((0, 0, 0), 1 / norm(d), d)
    foot = along(f, -dot(f, u), u)
    if abs(norm(foot) - r) <= SNAP * e:
        points = [foot]
    elif norm(foot) > r:
        return None
    else:
        cosine = norm(foot) / r
        sine = (1 - cosine * cosine).sqrt()
        points = [along(foot, side * r * sine, u) for side in (-1, 1)]
    for point in points:
        t = dot(along(point, -1, f), d) / dot(d, d)
        snapped = abs(t) * max(map(abs, d)) <= SNAP * e
        if t < 0 and not snapped:
            continue
        outward = along((0, 0, 0), 1 / norm(point), point)
        leaves = len(points) == 2 and dot(outward, d) > 0
        return (Decimal(0) if snapped else t), (along((0, 0, 0), -1, outward) if leaves else outward)
    return None


def steady_hits(circles, origin, way, share):
    """By the foot on the line; what was shown last is looked for backwards from each frame."""
    o, d, h = exact(origin), exact(way), Decimal(share)
    said = []
    for x, y, radius in circles:
        f, r = along(o, -1, exact((x, y))), Decimal(radius)
        distance, room = norm(along(f, -dot(f, d) / dot(d, d), d)), SNAP * max(r, *map(abs, f))
        if not said:
            said.append(int(distance < r))
        else:
            below, above = distance < r * (1 - h) - room, distance > r * (1 + h) + room
            said.append(1 if below else 0 if above else None)
    return [next(word for word in said[at::-1] if word is not None) for at in range(len(said))]


ANSWERS = {"silhouette": (steady_hits, 300), "sphere": (ray_sphere, 300)}


def number(x):
    surd = Surd.of(x) if isinstance(x, int | Fraction) else x
    return (Decimal(surd.p) + Decimal(surd.q) * Decimal(surd.d).sqrt()) / Decimal(surd.s)


def same(answer, other):
    """Whether two answers are alike: each number within a hair of its own unit."""
    if isinstance(answer, list | tuple):
        return (
            isinstance(other, list | tuple)
            and len(answer) == len(other)
            and all(same(*pair) for pair in zip(answer, other, strict=True))
        )
    if answer is None or isinstance(answer, int):
        return answer == other
    return abs(number(answer.x) - other) <= CLOSE * number(answer.unit)


@pytest.mark.parametrize("name", ANSWERS)
def test_the_exact_answer_is_that_of_another_formula(name):
    formula, kinds = ANSWERS[name]
    problem = load_problem(PROBLEMS / name)
    solve = load_module(problem).solve
    data = (load_data(problem, seed=seed, cache=False) for seed in (None, 1, 2))
    cases = list(islice(chain.from_iterable(g.cases for each in data for g in each.groups), CASES))
    assert len(cases) == CASES
    answered = set()
    with localcontext(prec=DIGITS):
        for case in cases:
            solved = solve(*case)
            assert solved.broken is None
            assert same(solved.answer, formula(*case)), case
            answered.add(str(solved.answer))
    assert len(answered) >= kinds
