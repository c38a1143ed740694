"""The segment and the ray problem as they ship: their data, their statements, their solutions."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from judge.data import load_data
from judge.data.module import load_module
from judge.problem.load import load_problem

pytestmark = pytest.mark.slow

PROBLEMS = Path(__file__).parents[2] / "problems"


@pytest.fixture(scope="module", params=["segment", "ray-nearest"])
def problem(request):
    return load_problem(PROBLEMS / request.param)


@pytest.fixture(scope="module")
def data(problem):
    return load_data(problem, cache=False)


def cases_of(data):
    return [case for group in data.groups for case in group.cases]


def kind(answer):
    """What an exact answer is, told apart as coarsely as a person would."""
    if isinstance(answer, list):
        return len(answer)
    return "none" if answer is None else answer.x.sign()


def test_there_are_enough_cases_of_every_answer(problem, data):
    assert len(cases_of(data)) >= 1200
    kinds = Counter(kind(data.exact(case, group.group)[0]) for group in data.groups for case in group.cases)
    assert set(kinds) == ({0, 1, 2} if problem.id == "segment" else {"none", 0, 1})
    assert min(kinds.values()) >= 150


def test_the_inputs_are_of_all_sizes_and_of_both_types(data):
    numbers = [x for case in cases_of(data) for v in case for x in (v if isinstance(v, tuple) else (v,))]
    assert {type(number) for number in numbers} == {int, float}
    sizes = [abs(number) for number in numbers if number]
    assert max(sizes) > 5e8
    assert min(sizes) < 1e-8


def test_the_points_are_in_order_along_the_segment():
    module = load_module(load_problem(PROBLEMS / "segment"))
    answer = module.solve(0, 0, 5, (0, 9), (0, -9)).answer
    assert [(float(x.x), float(y.x)) for x, y in answer] == [(0, 5), (0, -5)]
    assert {float(real.unit) for point in answer for real in point} == {9}
    assert [[x.x, y.x] for x, y in module.solve(0, 0, 5, (3, 4), (3, 4)).answer] == [[3, 4]]
    assert [[x.x, y.x] for x, y in module.solve(0, 0, 0, (0, 0), (0, 0)).answer] == [[0, 0]]


def test_the_promise_of_a_segment():
    module = load_module(load_problem(PROBLEMS / "segment"))

    def promise(*case):
        return module.solve(*case).broken

    assert "the line's distance" in promise(0, 0, 1, (-1, 1 + 1e-9), (1, 1 + 1e-9))
    assert "the segment's end" in promise(0, 0, 1, (0, 0), (1 + 1e-9, 0))
    assert "the segment's start" in promise(0, 0, 1, (-1 - 1e-9, 0), (0.5, 0))
    assert "the point's distance" in promise(0, 0, 1, (1 + 1e-9, 0), (1 + 1e-9, 0))
    assert promise(0, 0, 1, (-1, 0), (1, 0)) is None


def test_the_promise_and_the_null_direction_of_a_ray():
    module = load_module(load_problem(PROBLEMS / "ray-nearest"))
    assert "the ray's origin" in module.solve(0, 0, 1, (1 + 1e-9, 0), (1, 0)).broken
    assert module.solve(0, 0, 1, (1 + 1e-9, 0), (0, 0)).broken is None
    assert module.solve(0, 0, 1, (1, 0), (0, 0)).answer is None
    assert module.solve(0, 0, 5, (3, 4), (0, 1)).answer.x == 0
    assert module.solve(0, 0, 1, (-3, 0), (2, 0)).answer.x == 1


def test_the_published_cases_are_worked_examples(problem):
    calls = {example.case for example in problem.examples}
    if problem.id == "segment":
        published = [
            (2, 1, 1, (0, 1), (4, 1)),
            (2, 1, 1, (3, 0), (3, 3)),
            (1150, 1000, 250, (1250, 1050), (250, 900)),
            (0.5, 1, 1.3, (1, 2), (4, 1.5)),
            (6, 12, 5, (4, 1), (9, 16)),
        ]
    else:
        published = [
            (6, 12, 5, (4, 1), (1, 3)),
            (530.02631651848, 1380, 610, (92, 770), (1, 0)),
            (2, 1, 1, (0, 1), (4, 0)),
        ]
    assert set(published) <= calls
