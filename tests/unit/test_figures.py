"""The figure of each statement that has one is what its geometry draws today."""

from __future__ import annotations

from pathlib import Path

import pytest

from judge.problem.find import find_problem
from judge.report.picture import FIGURE, figure

FOLDER = Path(__file__).parents[2] / "problems"
DRAWN = sorted(
    path.parent.name for path in FOLDER.glob("*/statement.md") if FIGURE in path.read_text("utf-8")
)


def test_some_statements_have_figures():
    assert "count" in DRAWN
    assert {path.parent.name for path in FOLDER.glob(f"*/{FIGURE}")} == set(DRAWN)


@pytest.mark.parametrize("kata", DRAWN)
def test_a_figure_is_drawn_by_the_geometry(kata):
    problem = find_problem(kata)
    drawn = figure(problem)
    assert drawn == (problem.folder / FIGURE).read_text(encoding="utf-8"), "judge verify KATA --figures"
    assert len(drawn) < 10_000
