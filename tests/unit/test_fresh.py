"""Fresh cases: what a seed stands for, whose they are, and that a mirror image is a case like any other."""

from __future__ import annotations

import math
from itertools import chain, islice
from pathlib import Path

import pytest

from judge.data.draw import ReplayedDraw
from judge.data.fresh import BUILT, IMAGES_EACH, Fresh
from judge.data.module import load_module
from judge.data.validate import Validator
from judge.diagnose.simplicity import numbers_of
from judge.errors import ProblemError, UsageError
from judge.problem.find import find_problem
from judge.problem.load import load_problem
from judge.problem.statement import EXAMPLES
from judge.topics.circles.images import SYMMETRIES, images_under

FIXTURES = Path(__file__).parent.parent / "fixtures"
PROBLEMS = ("count", "segment", "ray-nearest", "exact-count")


def fresh(name, seed=1, groups=None):
    problem = find_problem(name)
    chosen = problem.groups if groups is None else [problem.group(each) for each in groups]
    return Fresh(problem, load_module(problem), chosen, seed)


def cases(source, series):
    return [(each.round, each.data.group.name, each.data.cases) for each in islice(source.series(), series)]


def assert_same(answer, one, other):
    """The same target, but that (x − nearest)/ulp(x) is known to some digits only."""
    if answer.depth:
        assert len(one) == len(other)
        for first, second in zip(chain(*one), chain(*other), strict=True):
            assert abs(first[3] - second[3]) < 1e-5  # nearly upright lines have coordinates of few digits
            assert (first[:3], first[4]) == (second[:3], second[4])
    else:
        assert one == other


def test_a_seed_stands_for_its_cases():
    assert cases(fresh("count", 5), 20) == cases(fresh("count", 5), 20)
    assert cases(fresh("count", 5), 1) != cases(fresh("count", 6), 1)


def test_the_groups_take_turns_and_every_round_is_new():
    names = [each.name for each in find_problem("count").groups if each.builder != EXAMPLES]
    found = cases(fresh("count"), 2 * len(names))
    assert [(number, name) for number, name, _ in found] == [(n, name) for n in (1, 2) for name in names]
    assert found[1][2] != found[1 + len(names)][2]


def test_a_groups_cases_do_not_depend_on_which_groups_are_wanted():
    alone = cases(fresh("count", groups=["tangent"]), 1)
    assert alone[0] in cases(fresh("count"), 19)


def test_the_examples_have_no_fresh_ones():
    with pytest.raises(UsageError, match="name one of grid"):
        fresh("count", groups=["examples"])


@pytest.mark.slow
@pytest.mark.parametrize("name", PROBLEMS)
def test_each_image_is_proved_and_solved_like_a_case_of_its_own(name):
    source = fresh(name)
    problem, module = find_problem(name), load_module(find_problem(name))
    validator = Validator(problem, module.solve)
    for series in islice(source.series(), len(source.groups)):
        group, pairs = series.data.group, list(zip(series.data.cases, series.data.targets, strict=True))
        assert len(series.starts) == BUILT
        assert len(pairs) == BUILT if group.neighbours else BUILT < len(pairs) <= BUILT * (1 + IMAGES_EACH)
        for case, target in pairs:
            proof = validator.proof(case)
            assert proof.fault is None
            again = problem.answer.target(proof.answer, group.tolerance)
            assert_same(problem.answer, again, target)
            assert all(math.copysign(1, number) > 0 for number in numbers_of(case) if number == 0)


def test_the_seven_images_of_a_case_differ_and_keep_its_types():
    case = (1, 2.5, 3, (4, -5.5), (0.0, 7))
    images = [image for image, _ in images_under(find_problem("count"), case, None, SYMMETRIES)]
    assert len({case, *images}) == 8
    assert (5.5, 0.0) not in images
    assert (-1, 2.5, 3, (-4, -5.5), (0.0, 7)) in images
    assert (2.5, 1, 3, (-5.5, 4), (7, 0.0)) in images
    assert all([type(each) for each in numbers_of(image)].count(int) == 4 for image in images)


def test_an_image_that_is_the_case_itself_is_none():
    assert images_under(find_problem("count"), (0, 0, 1, (0, 0), (0, 0)), None, SYMMETRIES) == []


@pytest.mark.parametrize(
    ("name", "group"), [("segment", "short"), ("exact-count", "just-hit"), ("count", "near-hit")]
)
def test_the_choices_of_a_case_make_it_again_also_where_attempts_were_rejected(name, group):
    source = fresh(name, groups=[group])
    _, series = islice(source.series(), 2)
    module, problem = load_module(find_problem(name)), find_problem(name)
    parameters = dict(problem.group(group).parameters)
    builder = module.builders[problem.group(group).builder]
    for start in series.starts[:3] + series.starts[-1:]:
        choices = source.choices_of(series, start)
        assert repr(builder(ReplayedDraw(choices), **parameters)) == repr(series.data.cases[start])
    image = next(place for place in range(len(series.data.cases)) if place not in series.starts)
    assert source.choices_of(series, image) == source.choices_of(series, image - 1)


def test_a_problem_without_images_has_built_cases_only():
    problem = load_problem(FIXTURES / "pack" / "problems" / "middle")
    source = Fresh(problem, load_module(problem), problem.groups, 1)
    series = next(source.series())
    assert len(series.data.cases) == BUILT
    assert series.starts == list(range(BUILT))


def test_a_builder_that_never_gives_a_case_is_blamed(tmp_path):
    problem = load_problem(FIXTURES / "pack" / "problems" / "middle")
    module = load_module(problem)

    def never(draw, odd):
        draw.reject()

    stubborn = type(module)(module.solve, {"pairs": never})
    source = Fresh(problem, stubborn, problem.groups, 1)
    with pytest.raises(ProblemError, match="'whole': the builder 'pairs' gives no case 1"):
        next(source.series())
