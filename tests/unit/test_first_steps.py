"""First steps: gentle, exact, and each of a kind with its picture."""

from __future__ import annotations

from fractions import Fraction

import pytest
from sampling import daily

from judge.data import load_data
from judge.data.module import load_module
from judge.kata.sets import find_set
from judge.problem.find import find_problem

STEPS = ["distance-squared", "which-side", "circle-side", "diameter", "axis-foot", "crossings"]


def sign(x):
    return (x > 0) - (x < 0)


def square(p, q):
    return sum((a - b) ** 2 for a, b in zip(p, q, strict=True))


def foot(a, b, p):
    """The foot on any line, as fractions."""
    d = [y - x for x, y in zip(a, b, strict=True)]
    t = Fraction(sum((y - x) * z for x, y, z in zip(a, p, d, strict=True)), square(a, b))
    return tuple(x + t * z for x, z in zip(a, d, strict=True))


def side(a, b, p):
    """Which side P is on, by the height of the line above P's x."""
    if a[0] == b[0]:
        return sign(a[0] - p[0]) * sign(b[1] - a[1])
    height = a[1] + Fraction(b[1] - a[1], b[0] - a[0]) * (p[0] - a[0])
    return sign(p[1] - height) * sign(b[0] - a[0])


def in_circle(centre, radius_squared, p):
    return sign(square(centre, p) - radius_squared)


def middle(a, b):
    return tuple(Fraction(x + y, 2) for x, y in zip(a, b, strict=True))


# Each by another way than the problem's own `solve`.
ANSWERS = {
    "distance-squared": lambda p, q: square(p, (0, 0)) + square(q, (0, 0)) - 2 * (p[0] * q[0] + p[1] * q[1]),
    "which-side": side,
    "circle-side": lambda cx, cy, r, p: in_circle((cx, cy), r * r, p),
    "diameter": lambda a, b, p: in_circle(middle(a, b), Fraction(square(a, b), 4), p),
    "axis-foot": foot,
    "crossings": lambda cx, cy, r, a, b: 1 - in_circle((cx, cy), r * r, foot(a, b, (cx, cy))),
}


@pytest.fixture(autouse=True)
def _own_pack_and_cache(monkeypatch, built):
    monkeypatch.delenv("JUDGE_PROBLEMS", raising=False)
    monkeypatch.setenv("JUDGE_CACHE", str(built))


def test_they_are_the_first_of_the_path_in_order_and_small():
    assert [each.id for each in find_set("first-steps").problems] == STEPS
    assert [each.id for each in find_set("path").problems[: len(STEPS)]] == STEPS
    for problem in map(find_problem, STEPS):
        assert len(problem.groups) <= 5
        assert not problem.answer.measured
        assert {each.type.text for each in problem.parameters} <= {"integer", "integer-point"}


@pytest.mark.slow
@pytest.mark.parametrize("name", daily(STEPS, ["which-side", "crossings"]))
def test_the_answers_are_those_of_another_way(name):
    problem = find_problem(name)
    data = load_data(problem)
    cases = [case for group in data.groups for case in group.cases]
    assert len(cases) > 200
    assert all(load_module(problem).solve(*case).answer == ANSWERS[problem.id](*case) for case in cases)
