"""Replay ids: every case of every group comes back from its id, and what is no id is one clear line."""

from __future__ import annotations

import pytest
from msgspec.structs import replace

from judge.data.build import bound_builder, choices_of
from judge.data.load import load_data
from judge.data.module import load_module
from judge.diagnose.replay import decode, encode, problem_name
from judge.errors import ProblemError, UsageError
from judge.problem.find import find_problem

CASE = (0, 0, 1, (0, 1), (80, 0))


@pytest.fixture(scope="module", params=["count", "segment", "ray-nearest", "exact-count"])
def problem(request):
    return find_problem(request.param)


def test_every_group_comes_back_from_values_and_from_choices(problem):
    module = load_module(problem)
    for data in load_data(problem).groups:
        for number in (0, len(data.cases) - 1):
            case = data.cases[number]
            choices = None
            if data.group.builder != "examples":
                builder = bound_builder(problem, module, data.group)
                choices = choices_of(data.group, builder, number, case)
                assert (choices is None) == data.group.neighbours
            for replay in {encode(problem, data.group, case), encode(problem, data.group, case, choices)}:
                assert problem_name(replay) == problem.id
                group, again, answer = decode(replay, problem, module)
                assert (group, repr(again)) == (data.group, repr(case))
                assert answer == module.solve(*case).answer


def test_a_bad_id_is_a_short_line_however_long_it_is():
    """The others are in golden/transcripts: refused/replay-ids.txt."""
    problem = find_problem("count")
    with pytest.raises(UsageError, match="no replay id") as caught:
        decode("count:grid:v" + "9" * 20_000 + ":123456", problem, load_module(problem))
    assert len(str(caught.value)) < 200


@pytest.mark.parametrize("fault", [KeyError("x"), TypeError, ProblemError("it breaks its word")])
def test_choices_that_break_a_builder_are_no_id_of_it(fault):
    def broken(draw, **_parameters):
        draw.integer(0, 9)
        raise fault

    problem = find_problem("count")
    module = load_module(problem)
    module = replace(module, builders=dict.fromkeys(module.builders, broken))
    with pytest.raises(UsageError, match="check digits"):
        decode("count:tangent:c1:000000", problem, module)


def test_the_shorter_form_is_taken():
    problem = find_problem("count")
    group = problem.group("grid")
    assert encode(problem, group, CASE).startswith("count:grid:v0,0,1,0,1,80,0:")
    assert encode(problem, group, CASE, [1, -40]).startswith("count:grid:c1.-14:")
