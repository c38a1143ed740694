"""How small a number other than 0 may be: said in problem.toml, held by the validator, shown to a person."""

from __future__ import annotations

import math
import shutil
from fractions import Fraction
from pathlib import Path

import pytest

from judge.data.module import load_module
from judge.data.validate import Validator, least_double
from judge.errors import ProblemError
from judge.problem.load import load_problem

PROBLEMS = Path(__file__).parents[2] / "problems"
SMALLEST = Fraction(1, 10**30)


@pytest.fixture(scope="module", params=["segment"])
def problem(request):
    return load_problem(PROBLEMS / request.param)


def test_a_smaller_number_is_out_of_bounds_whatever_its_place_and_0_is_not(problem):
    validator = Validator(problem, load_module(problem).solve)

    def bounds(flat):
        return validator.bounds((*flat[:3], tuple(flat[3:5]), tuple(flat[5:])))

    for place in range(7):
        for sign in (1, -1) if place != 2 else (1,):  # a radius
            flat = [1.0] * 7
            flat[place] = sign * math.nextafter(1e-30, 0)
            assert "nearer to 0 than 1e-30 but not 0" in bounds(flat)
            flat[place] = sign * least_double(SMALLEST)
            assert bounds(flat) is None
    assert bounds([0, 0.0, 0, 0.0, 0, 0, 0.0]) is None
    assert bounds([0, 0.0, 5e-324, 0.0, 0, 0, 0.0]) is not None


def test_the_double_of_a_bound_is_not_below_it():
    for bound in (SMALLEST, Fraction(1, 3), Fraction(2, 3), Fraction(1, 2)):
        least = least_double(bound)
        assert least >= bound > math.nextafter(least, 0)


@pytest.mark.parametrize(
    ("smallest", "fault"),
    [("2", "other than 0 is 2"), ("-1", "other than 0 is -1"), ("1e-9", "holds no real")],
)
def test_what_is_no_such_bound_is_a_fault(tmp_path, smallest, fault):
    source = Path(__file__).parents[1] / "fixtures" / "problems" / "root-count"
    folder = shutil.copytree(source, tmp_path / "root-count")
    text = (source / "problem.toml").read_text()
    (folder / "problem.toml").write_text(text.replace("low = -9\n", f"low = -9\nsmallest = {smallest}\n"))
    with pytest.raises(ProblemError, match=fault):
        load_problem(folder)
