"""Simpler cases are cases of the same kata, and the plainest of them is as plain as it can be."""

from __future__ import annotations

import pytest

from judge.problem.find import find_problem
from judge.problem.module import load_module
from judge.values import parameters

CASES = {
    "count": (0.37, -1.25, 2.5, (7.125, 0.5), (-3.0, 9.75)),
    "segment": (100, 200, 5, (93, 201), (101, 207)),
    "ray-nearest": (0.37, -1.25, 2.5, (7.125, 0.5), (-3.0, 9.75)),
    "adaptive": (0.37, -1.25, 2.5, 7.125, 0.5, -3.0, 9.75),
    "on-circle": (1.5, 2.5, 3.25, (4.75, 2.5)),
    "diameter": ((3, 4), (9, -2), (5, 5)),
    "foot": ((0.5, 1.25), (3.5, -2.0), (7.0, 7.5)),
    "circle-circle": (0.5, 1.25, 3.5, 2.0, 7.0, 1.5),
    "enter-exit": (((3.5, 1.0, 1.25), (9.0, -1.0, 2.5)), (0.5, 0.25), (2.0, 0.5)),
    "csg": (((3.5, 1.0, 1.25), (9.0, -1.0, 2.5)), (0.5, 0.25), (2.0, 0.5), (0, 1, -1)),
    "shadow": (((3.5, 1.0, 1.25), (9.0, -1.0, 2.5)), (0.5, 0.25), (2.0, 0.5), (-4.0, 8.5)),
    "silhouette": (((3.5, 1.0, 1.25), (9.0, -1.0, 2.5)), (0.5, 0.25), (2.0, 0.5), 0.25),
    "polygon": (1.5, 2.5, 3.25, ((4.75, 2.5), (-3.0, 9.5), (0.5, -8.0), (2.0, -9.0))),
    "swept-balls": ((0.5, 1.25), (3.5, -2.0), 1.5, (7.0, 7.5), (8.0, 6.5), 0.25),
    "swept-wall": ((0.5, 1.25), (3.5, -2.0), 1.5, (7.0, 7.5), (8.0, 6.5)),
    "sphere": ((1.5, 2.5, 3.25), 2.0, (-4.0, 0.5, 1.25), (1.0, 0.5, 0.75)),
}


def candidates(kata):
    problem = find_problem(kata)
    return problem, list(load_module(problem).hooks.simpler(problem, CASES[kata]))


@pytest.mark.parametrize("kata", CASES)
def test_simpler_cases_are_cases(kata):
    problem, found = candidates(kata)
    assert 10 < len(found) < 1_500
    for case in found:
        for parameter, value in zip(problem.parameters, case, strict=True):
            assert parameters.fault(parameter.type, parameter.name, value) is None
    assert min(len(repr(case)) for case in found) < len(repr(CASES[kata]))


@pytest.mark.parametrize(
    ("kata", "plain"),
    [
        ("segment", (0, 0, 5, (-5, 5), (5, 5))),
        ("circle-circle", (0, 0, 4, 6, 0, 2)),
        ("on-circle", (0, 0, 3, (3, 0))),
    ],
)
def test_the_figure_is_laid_level_about_the_origin(kata, plain):
    assert any(case == plain for case in candidates(kata)[1])
