"""How small a number other than 0 may be: said in problem.toml, held by the validator, shown to a person."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path

import pytest

from judge.data.module import load_module
from judge.data.validate import Validator, least_double
from judge.errors import ProblemError
from judge.problem.load import load_problem
from judge.report.problems import detail_lines

PROBLEMS = Path(__file__).parents[2] / "problems"
SMALLEST = Fraction(1, 10**30)


@pytest.fixture(scope="module", params=["count", "segment", "ray-nearest"])
def problem(request):
    return load_problem(PROBLEMS / request.param)


@pytest.fixture(scope="module")
def validator(problem):
    return Validator(problem, load_module(problem).solve)


def test_the_statement_names_it(problem):
    assert {parameter.smallest for parameter in problem.parameters} == {SMALLEST}
    assert "1e-30 in magnitude" in " ".join(problem.statement.split())


def test_a_smaller_number_is_out_of_bounds_whatever_its_place(problem, validator):
    tiny = math.nextafter(1e-30, 0)
    for sign in (1, -1):
        for place in range(7):
            if place == 2 and sign < 0:
                continue  # a radius
            flat = [1.0] * 7
            flat[place] = sign * tiny
            case = (*flat[:3], tuple(flat[3:5]), tuple(flat[5:]))
            assert "nearer to 0 than 1e-30 but not 0" in validator.bounds(case)
            flat[place] = sign * least_double(SMALLEST)
            case = (*flat[:3], tuple(flat[3:5]), tuple(flat[5:]))
            assert validator.bounds(case) is None


def test_zero_is_no_small_number(validator):
    assert validator.bounds((0, 0.0, 0, (0.0, 0), (0, 0.0))) is None
    assert validator.bounds((0, 0.0, 5e-324, (0.0, 0), (0, 0.0))) is not None


def test_the_double_of_a_bound_is_not_below_it():
    for bound in (SMALLEST, Fraction(1, 3), Fraction(2, 3), Fraction(1, 2)):
        least = least_double(bound)
        assert least >= bound > math.nextafter(least, 0)


def test_a_person_is_shown_it(problem):
    shown = "".join(span.text for each in detail_lines(problem, 100) for span in each)
    assert "0 or at least 1e-30 in magnitude" in shown


@pytest.mark.parametrize(
    ("smallest", "fault"),
    [("2", "other than 0 is 2"), ("-1", "other than 0 is -1"), ("1e-9", "holds no real")],
)
def test_what_is_no_such_bound_is_a_fault(tmp_path, smallest, fault):
    source = Path(__file__).parents[1] / "fixtures" / "problems" / "root-count"
    folder = tmp_path / "root-count"
    folder.mkdir()
    for name in ("problem.py", "statement.md"):
        (folder / name).write_text((source / name).read_text())
    text = (source / "problem.toml").read_text()
    (folder / "problem.toml").write_text(text.replace("low = -9\n", f"low = -9\nsmallest = {smallest}\n"))
    with pytest.raises(ProblemError, match=fault):
        load_problem(folder)
