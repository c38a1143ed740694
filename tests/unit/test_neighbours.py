"""Groups of neighbours: each case differs from the one before in one parameter, in its turn."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from sampling import daily

from judge.data.build import build_cases
from judge.data.fresh import Fresh
from judge.data.module import load_module
from judge.errors import ProblemError
from judge.problem.load import load_problem

PROBLEMS = Path(__file__).parents[2] / "problems"
FIXTURE = Path(__file__).parents[1] / "fixtures" / "problems" / "root-count"


@pytest.fixture(params=daily(["count", "exact-count", "segment", "ray-nearest"], ["segment"]))
def problem(request):
    return load_problem(PROBLEMS / request.param)


def changed(one, other):
    return [place for place, (a, b) in enumerate(zip(one, other, strict=True)) if a != b]


def assert_neighbours(cases, answers):
    turns = dict.fromkeys(range(5), 0)
    others = 0
    for number in range(1, len(cases)):
        if number % 11 == 0:
            continue  # it stands for itself
        assert changed(cases[number - 1], cases[number]) == [(number % 11 - 1) % 5]
        turns[(number % 11 - 1) % 5] += 1
        others += answers[number] != answers[number - 1]
    assert min(turns.values()) >= 5
    return others


def test_fresh_neighbours_are_such_too_with_nothing_between_them(problem):
    fresh = Fresh(problem, load_module(problem), [problem.group("neighbours")], 7)
    module = load_module(problem)
    series = next(fresh.series())
    cases = series.data.cases
    assert series.starts == list(range(len(cases)))
    assert_neighbours(cases, [module.solve(*case).answer for case in cases])
    assert fresh.choices_of(series, 3) is None


@pytest.mark.parametrize("after", ['builder = "examples"', "parameters = { reach = 9 }"])
def test_examples_are_no_neighbours_and_others_are_even_where_nothing_changes_the_answer(tmp_path, after):
    folder = tmp_path / "root-count"
    shutil.copytree(FIXTURE, folder)
    text = (folder / "problem.toml").read_text()
    (folder / "problem.toml").write_text(text.replace(after, f"{after}\nneighbours = true"))
    if "examples" in after:
        with pytest.raises(ProblemError, match="are no neighbours of one another"):
            load_problem(folder)
    else:
        problem = load_problem(folder)
        (group,) = (each for each in problem.groups if each.neighbours)
        assert len(build_cases(problem, load_module(problem), group)) == group.count
