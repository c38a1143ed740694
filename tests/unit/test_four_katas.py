"""The four main katas as they ship: their data, what they promise, and the published cases as examples."""

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
ANSWERS = {  # of every kind so many at least
    "count": ({None, 0, 1, 2}, 60),
    "exact-count": ({None, 0, 1, 2}, 60),
    "segment": ({0, 1, 2}, 150),
    "ray-nearest": ({None, "0", "more"}, 150),
}


@pytest.fixture(scope="module", params=ANSWERS)
def data(request, built):
    with pytest.MonkeyPatch.context() as patched:
        patched.setenv("JUDGE_CACHE", str(built))
        return load_data(load_problem(PROBLEMS / request.param))


def solved(data):
    return [(case, data.exact(case, group.group)[0]) for group in data.groups for case in group.cases]


def kind(answer):
    """What an exact answer is, told apart as coarsely as a person would."""
    if isinstance(answer, list):
        return len(answer)
    return answer if not hasattr(answer, "x") else "more" if answer.x.sign() else "0"


def exact_count(case):
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


def test_there_are_enough_cases_of_every_answer_and_of_all_sizes(data):
    kinds, least = ANSWERS[data.problem.id]
    pairs = solved(data)
    counts = Counter(kind(answer) for _, answer in pairs)
    assert len(pairs) >= 1200
    assert set(counts) == kinds
    assert min(counts.values()) >= least
    numbers = [x for case, _ in pairs for v in case for x in (v if isinstance(v, tuple) else (v,))]
    sizes = [abs(number) for number in numbers if number]
    if data.problem.id == "exact-count":
        assert max(sizes) > 10**100
        assert {type(number) for number in numbers} == {int}
    else:
        assert max(sizes) > 5e8
        assert min(sizes) < 1e-8
        assert {type(number) for number in numbers} == {int, float}


def test_the_reference_is_the_exact_count_but_for_banded_tangents(data):
    if data.problem.id in ("count", "exact-count"):
        banded = [answer for case, answer in solved(data) if answer != exact_count(case)]
        assert set(banded) <= {1}
        assert len(banded) > 100 if data.problem.id == "count" else not banded


PUBLISHED = {
    "count": [
        *((0, 0, 1, (0, y), (1, y)) for y in (10, 1, 0, -1, -10)),
        *((2, 1, 1, (0, 1), (4, 1)), (2, 1, 1, (3, 0), (3, 3)), (6, 12, 5, (4, 1), (5, 4))),
        (1150, 1000, 250, (1250, 1050), (250, 900)),
        (530.02631651848, 1380, 610, (92, 770), (93, 770)),
        (0.5, 1, 1.3, (1, 2), (4, 1.5)),
    ],
    "segment": [
        *((2, 1, 1, (0, 1), (4, 1)), (2, 1, 1, (3, 0), (3, 3)), (6, 12, 5, (4, 1), (9, 16))),
        (1150, 1000, 250, (1250, 1050), (250, 900)),
        (0.5, 1, 1.3, (1, 2), (4, 1.5)),
    ],
    "ray-nearest": [
        *((6, 12, 5, (4, 1), (1, 3)), (2, 1, 1, (0, 1), (4, 0))),
        (530.02631651848, 1380, 610, (92, 770), (1, 0)),
    ],
}
PUBLISHED["exact-count"] = PUBLISHED["count"][:-2]


def test_the_published_cases_are_worked_examples(data):
    assert set(PUBLISHED[data.problem.id]) <= {example.case for example in data.problem.examples}


@pytest.mark.parametrize(
    ("name", "case", "broken"),
    [
        ("count", (0, 0, 1, (0, 1 + 1e-9), (1, 1 + 1e-9)), "the line's distance"),
        ("count", (0, 0, 1, (0, 1 + 5e-13), (1, 1 + 5e-13)), None),
        ("count", (0, 0, 1, (0, 1 + 2e-7), (1, 1 + 2e-7)), None),
        ("count", (0, 0, 1, (0, 1), (0, 1)), None),
        ("segment", (0, 0, 1, (-1, 1 + 1e-9), (1, 1 + 1e-9)), "the line's distance"),
        ("segment", (0, 0, 1, (0, 0), (1 + 1e-9, 0)), "the segment's end"),
        ("segment", (0, 0, 1, (-1 - 1e-9, 0), (0.5, 0)), "the segment's start"),
        ("segment", (0, 0, 1, (1 + 1e-9, 0), (1 + 1e-9, 0)), "the point's distance"),
        ("segment", (0, 0, 1, (-1, 0), (1, 0)), None),
        ("ray-nearest", (0, 0, 1, (1 + 1e-9, 0), (1, 0)), "the ray's origin"),
        ("ray-nearest", (0, 0, 1, (1 + 1e-9, 0), (0, 0)), None),
    ],
)
def test_the_promise_names_what_is_between_the_bands(name, case, broken):
    found = load_module(load_problem(PROBLEMS / name)).solve(*case).broken
    assert found is None if broken is None else broken in found


def test_points_come_in_order_along_the_segment_and_the_first_of_a_ray():
    segment, ray = (load_module(load_problem(PROBLEMS / name)).solve for name in ("segment", "ray-nearest"))
    answer = segment(0, 0, 5, (0, 9), (0, -9)).answer
    assert [(float(x.x), float(y.x)) for x, y in answer] == [(0, 5), (0, -5)]
    assert {float(real.unit) for point in answer for real in point} == {9}
    assert [[x.x, y.x] for x, y in segment(0, 0, 5, (3, 4), (3, 4)).answer] == [[3, 4]]
    assert [[x.x, y.x] for x, y in segment(0, 0, 0, (0, 0), (0, 0)).answer] == [[0, 0]]
    assert ray(0, 0, 1, (1, 0), (0, 0)).answer is None
    assert ray(0, 0, 5, (3, 4), (0, 1)).answer.x == 0
    assert ray(0, 0, 1, (-3, 0), (2, 0)).answer.x == 1
