from __future__ import annotations

import pytest
from hypothesis import find, settings

from judge.data.build import bound_builder, choices_of
from judge.data.draw import RecordedDraw, Rejected, ReplayedDraw, SeededDraw
from judge.data.module import load_module
from judge.data.strategy import strategy
from judge.errors import ProblemError
from judge.problem.find import find_problem


def some(draw):
    return (
        draw.integer(-5, 10**20),
        draw.choice("abcdef"),
        draw.sign(),
        draw.boolean(),
        draw.integer(3, 3),
        draw.choice([7]),
    )


def test_recorded_choices_change_nothing_and_replay():
    for seed in range(50):
        plain = some(SeededDraw(str(seed)))
        recorded = RecordedDraw(SeededDraw(str(seed)))
        assert some(recorded) == plain
        assert some(ReplayedDraw(recorded.choices)) == plain


@pytest.mark.parametrize("choices", [[], [1, 2], [-6, 0, 0, 0, 3, 0], [0, 6, 0, 0, 3, 0]])
def test_choices_of_something_else_are_rejected(choices):
    with pytest.raises(Rejected):
        some(ReplayedDraw(choices))


def test_nothing_to_choose_from():
    with pytest.raises(ValueError, match="no integer from 2 to 1"):
        ReplayedDraw([0]).integer(2, 1)
    with pytest.raises(ValueError, match="nothing to choose from"):
        ReplayedDraw([0]).choice([])


@pytest.mark.parametrize("fault", [ZeroDivisionError, KeyError, Rejected, ProblemError("no such figure")])
def test_choices_that_a_builder_cannot_use_are_passed_over_in_a_search(fault):
    def builder(draw):
        if draw.integer(0, 9) < 4:
            raise fault
        return (draw.integer(0, 3),)

    found = find(strategy(builder), lambda built: built.case[0] > 1, settings=settings(database=None))
    assert (found.case, found.choices) == ((2,), (4, 2))


@pytest.mark.parametrize("name", ["count", "segment", "ray-nearest", "exact-count"])
def test_every_builder_gives_its_case_back_from_its_choices(name):
    problem = find_problem(name)
    module = load_module(problem)
    for group in problem.groups:
        if group.builder == "examples" or group.neighbours:  # these follow from the case before them too
            continue
        builder = bound_builder(problem, module, group)
        built = next(case for case in (drawn(builder, group, n) for n in range(99)) if case)
        choices = choices_of(group, builder, built[0], built[1])
        assert choices is not None
        assert repr(builder(ReplayedDraw(choices))) == repr(built[1])


def drawn(builder, group, number):
    try:
        return number, builder(SeededDraw(f"{group.seed}/{group.name}/{number}/0"))
    except Rejected:
        return None
