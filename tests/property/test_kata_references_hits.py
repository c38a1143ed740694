"""Katas of what happens where a circle is hit: exact answers against other formulas in 80 digits.

The points are found from the foot of the perpendicular: O − C across the ray, and half the chord along it.
"""

from __future__ import annotations

from decimal import Decimal, localcontext
from itertools import chain, islice
from pathlib import Path

import pytest

from judge.data import load_data
from judge.data.module import load_module
from judge.exact import Surd
from judge.problem.load import load_problem
from judge.values import Real

PROBLEMS = Path(__file__).parents[2] / "problems"
CASES = 1000
DIGITS = 80
SNAP = Decimal("1e-12")
CLOSE = Decimal("1e-60")  # of the unit: a root of a difference of 1e-18 keeps so many digits, and more


def vec(*numbers):
    return tuple(Decimal(x) for x in numbers)  # of an int or a double, without rounding


def plus(p, q, times=1):
    return p[0] + times * q[0], p[1] + times * q[1]


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1]


def norm(p):
    return dot(p, p).sqrt()


def first_hit(cx, cy, r, origin, direction):
    """(P − C, D as a unit, -1 entering, 0 touching or 1 leaving) of the first point, or None."""
    f, d, r = plus(vec(*origin), vec(cx, cy), -1), vec(*direction), Decimal(r)
    if r == 0 or d == (0, 0):
        return None
    e, u = max(r, abs(f[0]), abs(f[1])), (d[0] / norm(d), d[1] / norm(d))
    across = dot(f, (-u[1], u[0]))
    foot = (-across * u[1], across * u[0])
    if abs(abs(across) - r) <= SNAP * e:
        ways = [(Decimal(0), 0)]
    elif abs(across) > r:
        ways = []
    else:
        half = ((r - across) * (r + across)).sqrt()
        ways = [(-half, -1), (half, 1)]
    for way, how in ways:
        if way - dot(f, u) >= -SNAP * e:
            return plus(foot, u, way), u, how
    return None


def hit_normal(*case):
    """By the direction of P − C, whatever its length is."""
    hit = first_hit(*case)
    if hit is None:
        return None
    point, u, how = hit
    side = -1 if how > 0 else 1
    assert how == 0 or side * dot(point, u) < 0, "it faces the ray"
    return side * point[0] / norm(point), side * point[1] / norm(point)


def reflect(cx, cy, r, origin, direction):
    """By the mirror image of O − P, as far from the line through C and P as O is, on its other side."""
    hit = first_hit(cx, cy, r, origin, direction)
    if hit is None:
        return None
    point, _, how = hit
    d, at = vec(*direction), plus(point, vec(cx, cy))
    if how == 0:
        return at, d
    # The line through C and P holds the foot of −D; what is reflected is as far beyond it.
    foot = dot(point, d) / dot(point, point)
    beside = plus(d, point, -foot)
    return at, plus(beside, point, -foot)


def boundary_hits(cx, cy, r, corners):
    """By the distance of C along an edge: it crosses where that passes r, or dips below it in between."""
    seen = [plus(vec(*corner), vec(cx, cy), -1) for corner in corners]
    r, e = Decimal(r), max(Decimal(r), *(max(abs(x), abs(y)) for x, y in seen))
    slack, found = SNAP * e, []
    for number, start in enumerate(seen):
        way = plus(seen[number + 1 - len(seen)], start, -1)
        long = norm(way)
        u = way[0] / long, way[1] / long
        nearest = -dot(start, u)
        low = norm(plus(start, u, nearest))
        steps = [Decimal(0)] if abs(low - r) <= slack else []
        if low < r - slack:
            half = ((r - low) * (r + low)).sqrt()
            steps = [-half, half]
        found += [
            (number, plus(plus(start, u, nearest + step), vec(cx, cy)))
            for step in steps
            if -slack <= nearest + step and nearest + step < long - slack
        ]
    return found


ANSWERS = {"normal": hit_normal, "reflect": reflect, "polygon": boundary_hits}


def number(x):
    x = x if isinstance(x, Surd) else Surd.of(x)
    return (Decimal(x.p) + Decimal(x.q) * Decimal(x.d).sqrt()) / Decimal(x.s)


def same(answer, other):
    """Whether two answers are alike: each number within a hair of its own unit."""
    if isinstance(answer, Real):
        return abs(number(answer.x) - other) <= CLOSE * number(answer.unit)
    if isinstance(answer, list | tuple):
        return (
            isinstance(other, list | tuple)
            and len(answer) == len(other)
            and all(same(*both) for both in zip(answer, other, strict=True))
        )
    return answer == other


@pytest.mark.parametrize("name", ANSWERS)
def test_the_exact_answer_is_that_of_another_formula(name):
    problem = load_problem(PROBLEMS / name)
    solve = load_module(problem).solve
    data = (load_data(problem, seed=seed, cache=False) for seed in (None, 1, 2))
    cases = list(islice(chain.from_iterable(g.cases for each in data for g in each.groups), CASES))
    assert len(cases) == CASES
    answered = set()
    for case in cases:
        solved = solve(*case)
        assert solved.broken is None
        with localcontext(prec=2 * DIGITS):  # so that differences keep eighty
            assert same(solved.answer, ANSWERS[name](*case)), case
        answered.add(type(solved.answer))
    assert len(answered) == 2 or name == "polygon", "an answer and None"


@pytest.mark.parametrize("name", ANSWERS)
def test_a_mirror_image_has_the_mirror_image_for_its_answer(name):
    """Vectors are mirrored as points are: the images that stress judges have the answers of `solve`."""
    problem = load_problem(PROBLEMS / name)
    module = load_module(problem)
    seen = 0
    for group in load_data(problem).groups:
        for case, target in islice(zip(group.cases, group.targets, strict=True), 8):
            for image, changed in module.topic.images(problem, case, target, First(), 7):
                solved = module.solve(*image)
                assert solved.broken is None
                assert alike(problem.answer.target(solved.answer, group.group.tolerance), changed)
                seen += 1
    assert seen > 300


def alike(given, wanted):
    """Whether two targets accept the same numbers; of the errors in ulps the last bits may differ."""
    if not isinstance(wanted, tuple | list):
        return given == wanted
    if len(wanted) == 5 and all(type(each) is float for each in wanted):
        off, residual = given[3], wanted[3]
        return (*given[:3], given[4]) == (*wanted[:3], wanted[4]) and abs(off - residual) < 1e-9
    return len(given) == len(wanted) and all(map(alike, given, wanted))


class First:
    """A source of chance that draws the least number."""

    def integer(self, low, _high):
        return low


def test_a_tiny_circle_is_against_the_promise():
    problem = load_problem(PROBLEMS / "normal")
    solve = load_module(problem).solve
    x, y = solve(0, 0, 5, (-10, 3), (1, 0)).answer
    assert (x.x, y.x) == (Surd(-4, 0, 0, 5), Surd(3, 0, 0, 5))
    assert solve(0, 0, 1e-5, (1, 0), (-1, 0)).broken is not None


def test_what_a_polygon_promises_is_held_against_every_edge():
    solve = load_module(load_problem(PROBLEMS / "polygon")).solve
    assert solve(0, 0, 1, ((0, 0), (1e-5, 0), (3, 3))).broken == "an edge is too short a part of the extent"
    assert solve(0, 0, 1, ((0, 0), (0, 0), (3, 3))).broken == "an edge is too short a part of the extent"
    nearly = solve(0.0, 0.0, 1.0, ((1.00000001, 0.0), (2.0, 0.5), (2.0, -0.5)))
    assert "forbidden band" in nearly.broken
    # The first edge runs along the circle, and touches it a little beyond the corner that the other meets.
    grazing = ((1.0, -(2.0**-20)), (1.0, 3.0), (-4.0, 3.0))
    assert solve(0.0, 0.0, 1.0, grazing).broken is not None


def test_a_corner_is_met_once_whichever_edges_find_it():
    solve = load_module(load_problem(PROBLEMS / "polygon")).solve
    for corners, edges in (
        (((3, 4), (9, 4), (9, 9)), [0]),
        (((9, 9), (3, 4), (9, 4)), [1]),
        (((9, 4), (9, 9), (3, 4)), [2]),
        (((0, 0), (3, 4), (6, 8), (9, 0)), [1, 3]),
        (((3, 4), (-3, 4), (0, 9)), [0, 1]),
    ):
        assert [edge for edge, _ in solve(0, 0, 5, corners).answer] == edges
