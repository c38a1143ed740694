"""What a kata draws: the figure of its statement is what its geometry draws today, and a failing case."""

from __future__ import annotations

from pathlib import Path

import pytest
from msgspec.structs import replace

from judge.problem.find import find_problem
from judge.problem.module import load_module
from judge.report.picture import case_picture, figure
from judge.run.result import Failure

FOLDER = Path(__file__).parents[2] / "problems"
DRAWN = sorted(
    path.parent.name for path in FOLDER.glob("*/statement.md") if "figure.svg" in path.read_text("utf-8")
)


def test_some_statements_have_figures():
    assert "count" in DRAWN
    assert {path.parent.name for path in FOLDER.glob(f"*/{'figure.svg'}")} == set(DRAWN)


@pytest.mark.parametrize("kata", DRAWN)
def test_a_figure_is_drawn_by_the_geometry(kata):
    problem = find_problem(kata)
    drawn = figure(problem)
    assert drawn == (problem.folder / "figure.svg").read_text(encoding="utf-8"), "judge verify KATA --figures"
    assert len(drawn) < 10_000


def test_a_case_is_drawn_while_it_is_one_of_its_kata():
    problem = find_problem("count")
    module = load_module(problem)
    values = {"cx": 0, "cy": 0, "r": 1, "A": [-1, 1], "B": [0, 1]}  # as JSON has kept it
    case = Failure("", input=values, expected="1", got="2")
    drawn = case_picture(problem, module, case, "examples")
    assert drawn is not None
    assert "Expected 1, got 2" in drawn.description
    for other in ({**values, "r": -1}, {**values, "r": "x"}, {"cx": 0}, {}):
        assert case_picture(problem, module, replace(case, input=other), "examples") is None
    assert case_picture(problem, module, case, "gone") is None
    assert case_picture(problem, module, case, None) is None
