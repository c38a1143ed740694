"""Katas of two circles, and of a circle and a point: exact answers against other formulas in 80 digits.

The points are found by other ways than `solve` goes, and ordered by the sign of a cross product.
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
CLOSE = Decimal("1e-60")  # of the extent: a root of a difference of 1e-18 keeps so many digits, and more


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def cross(u, v):
    return u[0] * v[1] - u[1] * v[0]


def norm(v):
    return (v[0] * v[0] + v[1] * v[1]).sqrt()


def reach(v):
    return max(abs(v[0]), abs(v[1]))


def exact(*numbers):
    return tuple(Decimal(x) for x in numbers)  # of an int or a double, without rounding


def left_first(points, start, end):
    """Two points, the one left of start→end before the other."""
    way = minus(end, start)
    return sorted(points, key=lambda point: -cross(way, minus(point, start)))


def tangent_points(cx, cy, r, point):
    """By the half-angle at C: the tangent of it is the root of (d − r)/(d + r)."""
    c, p, (r,) = exact(cx, cy), exact(*point), exact(r)
    f = minus(p, c)
    d, e = norm(f), max(r, reach(f))
    if r == 0:
        return [c]
    if abs(d - r) <= SNAP * e:
        return [p]
    if d < r:
        return []
    half = ((d - r) / (d + r)).sqrt()
    cosine, sine = (1 - half * half) / (1 + half * half), 2 * half / (1 + half * half)
    u = f[0] / d * r, f[1] / d * r
    points = [(c[0] + cosine * u[0] - s * u[1], c[1] + s * u[0] + cosine * u[1]) for s in (sine, -sine)]
    return left_first(points, p, c)


def circle_circle(cx1, cy1, r1, cx2, cy2, r2):
    """By Heron: the triangle's height over C1C2 from its area, and Pythagoras for how far along it is."""
    c, other, (p, q) = exact(cx1, cy1), exact(cx2, cy2), exact(r1, r2)
    v = minus(other, c)
    d, e = norm(v), max(p, q, reach(v))
    if d <= SNAP * e:
        if p == q == 0:
            return [c]
        return None if abs(p - q) <= SNAP * e else []
    if abs(d - p - q) <= SNAP * e or abs(d - abs(p - q)) <= SNAP * e:
        side = p if abs(d - p - q) <= SNAP * e or p > q else -p
        return [(c[0] + side * v[0] / d, c[1] + side * v[1] / d)]
    half = (d + p + q) / 2
    square = half * (half - d) * (half - p) * (half - q)  # of the area
    if square < 0:
        return []
    height = 2 * square.sqrt() / d
    along = ((p - height) * (p + height)).sqrt() * (1 if d * d + p * p >= q * q else -1)
    u = v[0] / d, v[1] / d
    points = [(c[0] + along * u[0] - s * u[1], c[1] + along * u[1] + s * u[0]) for s in (height, -height)]
    return left_first(points, c, other)


def common_tangents(cx1, cy1, r1, cx2, cy2, r2):
    """By the point where two tangents meet: the middle of their chord is its inverse."""
    c, other, (p, q) = exact(cx1, cy1), exact(cx2, cy2), exact(r1, r2)
    v = minus(other, c)
    d, e = norm(v), max(p, q, reach(v))
    found = []
    for signed in (-q, q):
        total = p + signed
        if abs(d - abs(total)) <= SNAP * e:
            side = p if total > 0 else -p
            found.append((c[0] + side * v[0] / d, c[1] + side * v[1] / d))
        elif d > abs(total):
            meeting = (p / total * v[0], p / total * v[1]) if total else None
            share = p * p / (norm(meeting) ** 2) if meeting else 0
            foot = (share * meeting[0], share * meeting[1]) if meeting else (Decimal(0), Decimal(0))
            half = (p * p - foot[0] * foot[0] - foot[1] * foot[1]).sqrt()
            ends = [(c[0] + foot[0] - s * v[1] / d, c[1] + foot[1] + s * v[0] / d) for s in (half, -half)]
            found += left_first(ends, c, other)
    return found


ANSWERS = {
    "tangents": tangent_points,
    "circle-circle": circle_circle,
    "common-tangents": common_tangents,
}


LARGEST = {"tangents": (False, 2), "circle-circle": (True, 2), "common-tangents": (False, 4)}


def number(real):
    x = Surd.of(real.x) if isinstance(real.x, int | Fraction) else real.x
    return (Decimal(x.p) + Decimal(x.q) * Decimal(x.d).sqrt()) / Decimal(x.s)


def unit(real):
    x = Surd.of(real.unit)
    return (Decimal(x.p) + Decimal(x.q) * Decimal(x.d).sqrt()) / Decimal(x.s)


def same(answer, other):
    """Whether two answers are alike: each coordinate within a hair of the extent."""
    if answer is None or other is None:
        return answer is other
    return len(answer) == len(other) and all(
        abs(number(real) - x) <= CLOSE * unit(real)
        for point, others in zip(answer, other, strict=True)
        for real, x in zip(point, others, strict=True)
    )


def cases_of(problem):
    data = (load_data(problem, seed=seed, cache=False) for seed in (None, 1, 2))
    return list(islice(chain.from_iterable(g.cases for each in data for g in each.groups), CASES))


@pytest.mark.parametrize("name", ANSWERS)
def test_the_exact_answer_is_that_of_another_formula(name):
    problem = load_problem(PROBLEMS / name)
    solve = load_module(problem).solve
    cases = cases_of(problem)
    assert len(cases) == CASES
    lengths = set()
    for case in cases:
        solved = solve(*case)
        assert solved.broken is None
        with localcontext(prec=2 * DIGITS):  # so that differences keep eighty
            assert same(solved.answer, ANSWERS[name](*case)), case
        lengths.add(None if solved.answer is None else len(solved.answer))
    assert {0, 1, 2} <= lengths
    assert (None in lengths, max(lengths - {None})) == LARGEST[name]


@pytest.mark.parametrize("name", ANSWERS)
def test_a_quarter_turn_of_a_case_is_a_case_and_a_mirror_image_is_none(name):
    """What is left stays left: the images that stress judges have the answers that `solve` gives them."""
    problem = load_problem(PROBLEMS / name)
    module = load_module(problem)
    seen = 0
    for group in load_data(problem).groups:
        for case, target in islice(zip(group.cases, group.targets, strict=True), 12):
            images = module.topic.images(problem, case, target, None, 7)
            assert len(images) <= 3
            for image, changed in images:
                solved = module.solve(*image)
                assert solved.broken is None
                assert problem.answer.target(solved.answer, group.group.tolerance) == changed
                seen += 1
    assert seen > 100
