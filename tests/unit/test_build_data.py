"""Building, proving and pinning data; and broken problems, each refused in one line with place and remedy."""

from __future__ import annotations

import json
import re
import shutil
from fractions import Fraction
from math import nextafter
from pathlib import Path
from types import SimpleNamespace

import pytest
from broken_problems import FAULTS, broken
from msgspec.structs import replace

from judge.data import reseeded
from judge.data.build import bounds_fault, draw_cases, validate
from judge.data.load import load_data
from judge.data.pins import PINS, differences, hash_of, pins_of, read_pins, write_rows
from judge.errors import ExitCode, ProblemError
from judge.problem import Parameter
from judge.problem.declare import InvalidCase
from judge.problem.load import load_problem
from judge.problem.module import Module, load_module
from judge.values.grammar import parse

SOUND = Path(__file__).parent.parent / "fixtures" / "problems" / "root-count"


@pytest.fixture
def copy(tmp_path):
    folder = tmp_path / "problems" / "root-count"
    shutil.copytree(SOUND, folder)
    return folder


def test_cases_and_targets_of_every_group():
    problem, steps = load_problem(SOUND), []
    data = load_data(problem, store=None, progress=lambda done, total: steps.append((done, total)))
    assert steps == [(2, 14), (14, 14)]
    assert differences(read_pins(problem), pins_of(data.groups, {"small": {"sign-forgotten"}})) == []
    examples, small = data.groups
    assert examples.cases == [(4,), (-1,)]
    assert examples.targets == [2, 0]
    assert len(set(small.cases)) == 12
    assert small.targets == [(c > 0) - (c < 0) + 1 for (c,) in small.cases]
    assert data.notes == ()
    answer, tolerance = data.exact((9,), small.group)
    assert (answer, tolerance) == (2, small.group.tolerance)


def test_a_seed_of_ones_own_gives_other_cases_but_the_same_examples():
    problem = load_problem(SOUND)
    drawn = set()
    for seed in (None, 0, 1, 2):
        data = load_data(problem, seed=seed, store=None)
        assert data.groups[0].cases == [(4,), (-1,)]
        drawn.add(tuple(data.groups[1].cases))
    assert len(drawn) == 4
    groups = [reseeded(each, 3) for each in problem.groups]
    assert groups[0] == problem.groups[0]
    assert groups[1].seed not in (3, problem.groups[1].seed)


def test_pins_notice_drift_new_groups_and_old_ones(copy):
    problem = load_problem(copy)
    groups = load_data(problem, store=None).groups
    found = pins_of(groups, {})
    write_rows(problem, PINS, found)
    assert json.loads((copy / "pins.json").read_text())["small"]["hash"] == hash_of(groups[1])
    pins = read_pins(problem)
    assert differences(pins, found) == []
    (copy / "pins.json").unlink()
    assert read_pins(problem) == {}
    pins["small"]["hash"] = "0" * 64
    pins["large"] = pins.pop("examples")
    assert differences(pins, found) == [
        "group 'examples' has no pinned hash",
        "the data of group 'small' differ from their pinned hash",
        "the pinned hash of 'large' belongs to no group",
    ]


@pytest.mark.parametrize("text", ["", "[]"])
def test_a_broken_file_of_pins_is_a_fault(copy, text):
    (copy / "pins.json").write_text(text)
    with pytest.raises(ProblemError, match=r"^root-count/pins.json: .*judge verify root-count --pin"):
        read_pins(load_problem(copy))


def parameters(*types):
    return tuple(
        Parameter(f"p{at}", parse(text), "", Fraction(-5), Fraction(11, 2), Fraction(0))
        for at, text in enumerate(types)
    )


class Problem:
    parameters = parameters("number", "integer", "point", "integer-point")


def test_a_valid_case_has_no_fault():
    assert validate(Problem, Module(lambda *case: 7), (5.5, -5, (0, -0.0), (1, 2))) == 7


@pytest.mark.parametrize(
    ("low", "high", "value", "valid"),
    [
        ("0.0001", "0.4999", 0.4999, True),  # the double is above 4999/10000
        ("0.0001", "0.4999", nextafter(0.4999, 1), False),
        ("0.1", "0.3", 0.3, True),  # below
        ("0.1", "0.3", nextafter(0.3, 1), False),
        ("0.3", "0.9", 0.3, True),
        ("0.3", "0.9", nextafter(0.3, 0), False),
        (2**53 + 1, 10**400, 2.0**53, True),
        (2**53 + 1, 10**400, 2**53, False),  # an int is no rounded number
        (-(10**400), 5, 6.0, False),
    ],
)
def test_the_double_nearest_to_a_bound_is_within(low, high, value, valid):
    parameter = replace(parameters("number")[0], low=Fraction(low), high=Fraction(high))
    fault = bounds_fault(SimpleNamespace(parameters=(parameter,)), (value,))
    assert (fault is None) == valid


@pytest.mark.parametrize(
    ("case", "fault"),
    [
        ([1, 1, (1, 1), (1, 1)], "a case must be a tuple of 4 arguments"),
        ((1, 1, (1, 1)), "a case must be a tuple of 4 arguments"),
        ((True, 1, (1, 1), (1, 1)), "p0 has True, a bool, where a number is expected"),
        ((Fraction(1), 1, (1, 1), (1, 1)), "p0 has Fraction(1, 1), a Fraction, where a number is expected"),
        ((float("nan"), 1, (1, 1), (1, 1)), "p0 has nan, which is not finite"),
        ((1, 1.0, (1, 1), (1, 1)), "p1 has 1.0, a float, where an int is expected"),
        ((1, 1, [1, 1], (1, 1)), "p2 has [1, 1] where a tuple is expected"),
        ((1, 1, (1, 1, 1), (1, 1)), "p2 has 3 coordinates where (x, y) is expected"),
        ((1, 1, (1, float("inf")), (1, 1)), "p2 has inf, which is not finite"),
        ((1, 1, (1, 1), (1, 1.5)), "p3 has 1.5, a float, where an int is expected"),
        ((5.500000000000001, 1, (1, 1), (1, 1)), "p0 has 5.500000000000001, outside -5 to 11/2"),
        ((1, 1, (1, -6), (1, 1)), "p2 has -6, outside -5 to 11/2"),
        ((1, 3, (1, 1), (1, 1)), "There are three"),
    ],
)
def test_an_invalid_case_is_named(case, fault):
    def solve(*case):
        assert case[1] == 3  # it never sees what is out of bounds
        raise InvalidCase("There are three")

    with pytest.raises(InvalidCase) as refused:
        validate(Problem, Module(solve), case)
    assert str(refused.value) == fault


def drawing(*options, count):
    """A problem of one number, a group whose cases are drawn from these, and what problem.py would define."""
    problem = load_problem(SOUND)
    (c,) = problem.parameters
    group = replace(problem.groups[1], count=count)
    problem = replace(problem, parameters=(replace(c, type=parse("number")),), groups=(group,))
    return problem, Module(lambda c: 7, {group.name: lambda draw: (draw.choice(options),)}), group


def test_an_int_and_the_float_that_equals_it_are_one_case_of_a_group():
    problem, module, group = drawing(1, 1.0, 2, count=2)
    (one, *_), (two, *_) = draw_cases(problem, module, group)
    assert {*one, *two} == {1, 2}
    with pytest.raises(ProblemError, match="1000 attempts, 1000 of them already in the group"):
        draw_cases(problem, module, replace(group, count=3))


@pytest.mark.parametrize(
    ("value", "told"),
    [
        (10, "draws a case out of bounds: c has 10, outside -9 to 9"),
        ("1", "its draw gives no case: c has '1'"),
    ],
)
def test_solve_never_sees_what_is_no_case(value, told):
    problem, module, group = drawing(value, count=1)
    unsolved = Module(lambda c: pytest.fail("it was asked"), module.draws)
    with pytest.raises(ProblemError, match=told):
        draw_cases(problem, unsolved, group)


def test_two_problems_of_one_name_keep_their_own_code(copy):
    text = (copy / "problem.py").read_text()
    (copy / "problem.py").write_text(text.replace("return (c > 0) - (c < 0) + 1", "return 1"))
    other, own = load_module(load_problem(copy)), load_module(load_problem(SOUND))
    assert other.solve(4) == 1
    assert own.solve(4) == 2
    assert not (copy / "__pycache__").exists()


def refused(folder, place, what, remedy):
    with pytest.raises(ProblemError) as caught:
        load_data(load_problem(folder), store=None)
    error = caught.value
    assert error.where == f"{folder.name}/{place}"
    assert what in error.what
    assert remedy in (error.remedy or "")
    assert re.fullmatch(r"[^\n]{20,300}", str(error))
    assert error.exit_code is ExitCode.FAULT


@pytest.mark.parametrize("name", sorted(FAULTS))
def test_a_broken_problem_is_refused_in_one_line(name, tmp_path):
    fault = FAULTS[name]
    refused(broken(name, tmp_path), fault["place"], fault["what"], fault["remedy"])


def test_a_file_that_is_not_utf8_is_refused(copy):
    toml = copy / "problem.toml"
    toml.write_bytes(toml.read_bytes().replace(b"Square", b"Sq\xe4are"))
    refused(copy, "problem.toml", "byte 11 is not UTF-8", "save the file as UTF-8")
