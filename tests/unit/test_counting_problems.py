"""The two counting problems as they ship: their data, their statements, their solutions."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from pathlib import Path

import pytest

from judge.data import load_data
from judge.data.module import load_module
from judge.problem.load import load_problem

pytestmark = pytest.mark.slow

PROBLEMS = Path(__file__).parents[2] / "problems"
IDS = ["count", "exact-count"]


@pytest.fixture(scope="module", params=IDS)
def problem(request):
    return load_problem(PROBLEMS / request.param)


@pytest.fixture(scope="module")
def data(problem):
    return load_data(problem, cache=False)


def exact_answer(case):
    """By b'² − a·c in fractions, without any band."""
    cx, cy, r, (ax, ay), (bx, by) = case
    fx, fy = Fraction(ax) - Fraction(cx), Fraction(ay) - Fraction(cy)
    dx, dy = Fraction(bx) - Fraction(ax), Fraction(by) - Fraction(ay)
    a = dx * dx + dy * dy
    if not a:
        return None
    b, c = fx * dx + fy * dy, fx * fx + fy * fy - Fraction(r) ** 2
    delta = b * b - a * c
    return 1 + (delta > 0) - (delta < 0)


def test_there_are_enough_cases_of_every_answer(data):
    cases = [case for group in data.groups for case in group.cases]
    assert len(cases) >= 1200
    answers = Counter(data.exact(case, group.group)[0] for group in data.groups for case in group.cases)
    assert set(answers) == {None, 0, 1, 2}
    assert min(answers.values()) >= 60


def test_the_reference_is_the_exact_count_but_for_banded_tangents(problem, data):
    banded = 0
    for group in data.groups:
        for case in group.cases:
            answer = data.exact(case, group.group)[0]
            if answer != exact_answer(case):
                assert answer == 1
                banded += 1
    assert banded == 0 if problem.id == "exact-count" else banded > 100


def test_the_data_go_to_the_ends_of_what_is_promised(problem, data):
    cases = [case for group in data.groups for case in group.cases]
    largest = max(abs(value) for cx, cy, r, a, b in cases for value in (cx, cy, r, *a, *b))
    if problem.id == "exact-count":
        assert largest > 10**100
        assert {type(v) for cx, cy, r, a, b in cases for v in (cx, cy, r, *a, *b)} == {int}
    else:
        extents = [
            max(r, *(abs(p[i] - c) for p in (a, b) for i, c in ((0, cx), (1, cy))))
            for cx, cy, r, a, b in cases
        ]
        assert largest > 5e8
        assert min(extent for extent in extents if extent) < 1e-12


def test_the_published_cases_are_worked_examples(problem):
    calls = {(example.case, example.wanted) for example in problem.examples}
    published = [
        ((0, 0, 1, (0, y), (1, y)), wanted) for y, wanted in ((10, 0), (1, 1), (0, 2), (-1, 1), (-10, 0))
    ]
    published += [((2, 1, 1, (0, 1), (4, 1)), 2), ((2, 1, 1, (3, 0), (3, 3)), 1)]
    published += [((1150, 1000, 250, (1250, 1050), (250, 900)), 2), ((6, 12, 5, (4, 1), (5, 4)), 2)]
    if problem.id == "count":
        published += [((530.02631651848, 1380, 610, (92, 770), (93, 770)), 1)]
        published += [((0.5, 1, 1.3, (1, 2), (4, 1.5)), 2)]
    assert set(published) <= calls


def test_the_promise_names_a_line_between_the_bands():
    module = load_module(load_problem(PROBLEMS / "count"))
    assert module.solve(0, 0, 1, (0, 1 + 1e-9), (1, 1 + 1e-9)).broken is not None
    assert module.solve(0, 0, 1, (0, 1 + 5e-13), (1, 1 + 5e-13)).broken is None
    assert module.solve(0, 0, 1, (0, 1 + 2e-7), (1, 1 + 2e-7)).broken is None
    assert module.solve(0, 0, 1, (0, 1), (0, 1)).broken is None
