"""Katas of motions: exact moments against other formulas in 80 digits, shipped cases and fresh ones."""

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
CLOSE = Decimal("1e-60")  # a moment; the arithmetic has digits to spare


def vec(point):
    return tuple(map(Decimal, point))  # of ints or doubles, without rounding


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1]


def norm(p):
    return dot(p, p).sqrt()


def reach(*vectors):
    return max(abs(x) for vector in vectors for x in vector)


def in_time(t, way, slack):
    """The moment, if it is in the time; what is within the slack of an end, along the way, is there."""
    if abs(t) * reach(way) <= slack:
        return Decimal(0)
    late = (t - 1) * reach(way)
    return None if t < 0 or late > slack else t


def balls_meet(p0, p1, r, q0, q1, s):
    """By the squared distance, as the product of both roots over the other one."""
    p0, p1, q0, q1 = map(vec, (p0, p1, q0, q1))
    f, total = minus(p0, q0), Decimal(r) + Decimal(s)
    way = minus(minus(p1, q1), f)
    slack = SNAP * max(total, reach(minus(p1, p0), f, minus(q1, p0)))
    if norm(f) - total <= slack:
        return Decimal(0)
    if not any(way):
        return None
    a, b, c = dot(way, way), dot(way, f), dot(f, f) - total * total
    nearest = minus(f, (b / a * way[0], b / a * way[1]))
    if abs(norm(nearest) - total) <= slack:
        return in_time(-b / a, way, slack)
    if norm(nearest) > total or b > 0:
        return None
    return in_time(c / (-b + (b * b - a * c).sqrt()), way, slack)


def apart(p, a, b):
    """The squared distance of a point from a segment."""
    wall, f = minus(b, a), minus(p, a)
    square, along = dot(wall, wall), dot(f, wall)
    if along <= 0 or along >= square:
        return min(dot(f, f), dot(minus(p, b), minus(p, b)))
    return (wall[0] * f[1] - wall[1] * f[0]) ** 2 / square


def lowest(p0, way, a, b):
    """When the distance from the segment is least on the whole line; of several moments the first."""
    feet = [-dot(minus(p0, end), way) / dot(way, way) for end in (a, b)]
    wall = minus(b, a)
    turn = way[0] * wall[1] - way[1] * wall[0]
    if turn:
        f = minus(a, p0)
        feet.append((f[0] * wall[1] - f[1] * wall[0]) / turn)
    place = {t: apart((p0[0] + t * way[0], p0[1] + t * way[1]), a, b) for t in feet}
    least = min(place.values())
    return min(t for t in feet if place[t] - least <= CLOSE * least), least.sqrt()


def time_of_impact(p0, p1, r, a, b):
    """By halving: the distance from the segment is convex in time, and falls until it is least."""
    p0, p1, a, b, r = vec(p0), vec(p1), vec(a), vec(b), Decimal(r)
    way = minus(p1, p0)
    slack = SNAP * max(r, reach(*(minus(end, place) for end in (a, b) for place in (p0, p1))))
    if apart(p0, a, b).sqrt() - r <= slack:
        return Decimal(0)
    if not any(way):
        return None
    end, least = lowest(p0, way, a, b)
    if abs(least - r) <= slack:
        grazed = [
            -dot(minus(p0, each), way) / dot(way, way)
            for each in (a, b)
            if abs(norm_across(minus(p0, each), way) - r) <= slack
        ]
        return in_time(min(grazed), way, slack)
    if least > r or end < 0:
        return None
    start = Decimal(0)
    for _ in range(220):
        middle = (start + end) / 2
        near = apart((p0[0] + middle * way[0], p0[1] + middle * way[1]), a, b) <= r * r
        start, end = (start, middle) if near else (middle, end)
    return in_time(end, way, slack)


def norm_across(f, way):
    """How far the line through f along the way passes the origin."""
    return abs(way[0] * f[1] - way[1] * f[0]) / norm(way)


ANSWERS = {"swept-balls": balls_meet, "swept-wall": time_of_impact}


def number(x):
    x = Surd.of(x) if isinstance(x, int | Fraction) else x
    return (Decimal(x.p) + Decimal(x.q) * Decimal(x.d).sqrt()) / Decimal(x.s)


def cases_of(problem):
    """Cases of all groups, shipped ones and fresh ones."""
    data = (load_data(problem, seed=seed, cache=False) for seed in (None, 1))
    return list(islice(chain.from_iterable(g.cases for each in data for g in each.groups), None, None, 3))[
        :CASES
    ]


@pytest.mark.parametrize("name", ANSWERS)
def test_the_exact_moment_is_that_of_another_formula(name):
    problem = load_problem(PROBLEMS / name)
    solve = load_module(problem).solve
    cases = cases_of(problem)
    assert len(cases) == CASES
    kinds = {"none": 0, "start": 0, "moment": 0}
    for case in cases:
        solved = solve(*case)
        assert solved.broken is None
        with localcontext(prec=2 * DIGITS):  # so that differences keep eighty
            wanted = ANSWERS[name](*case)
            assert (solved.answer is None) is (wanted is None), case
            if wanted is not None:
                assert abs(number(solved.answer.x) - wanted) <= CLOSE, case
        kinds["none" if wanted is None else "moment" if wanted else "start"] += 1
    assert min(kinds.values()) > CASES // 20


@pytest.mark.parametrize("name", ANSWERS)
def test_a_mirror_image_of_a_case_is_met_at_the_same_moment(name):
    problem = load_problem(PROBLEMS / name)
    module = load_module(problem)
    seen = 0

    class Chance:
        def integer(self, low, high):
            return low

    for group in load_data(problem).groups:
        for case, target in islice(zip(group.cases, group.targets, strict=True), 12):
            for image, changed in module.topic.images(problem, case, target, Chance(), 7):
                solved = module.solve(*image)
                assert solved.broken is None
                assert problem.answer.target(solved.answer, group.group.tolerance) == changed
                seen += 1
    assert seen > 500
