"""How the time grows, drawn: for the terminal, as SVG and in the report; and loops that grow too fast."""

from __future__ import annotations

import pytest
from msgspec.structs import replace
from past_runs import keep, past_result

from judge.drawing.braille import to_braille
from judge.drawing.svg import to_svg
from judge.errors import UsageError
from judge.kata.history import History
from judge.problem.find import find_problem
from judge.report.growth import growth_picture
from judge.report.page.growth import growth_plot
from judge.run.reference import check_needs
from judge.run.result import Growth, GrowthPoint, Timing

POINTS = (
    GrowthPoint("n-500", 500, 0.02, 0.01),
    GrowthPoint("n-2000", 2_000, 0.32, 0.04),
    GrowthPoint("n-8000", 8_000, 4.0, 0.16, ended=False),
)
GROWTH = Growth(2.0, 1.0, 0.4, ("n-500", "n-2000"), 2, points=POINTS)


def test_a_law_is_drawn_beside_the_reference():
    picture = growth_picture(GROWTH, "Nearest of many")
    assert "it grows like n^2.0, the reference like n^1.0" in picture.description
    rows = ["".join(piece.text for piece in row) for row in to_braille(picture)]
    assert (sum(row.count("x") for row in rows[1:-1]), sum(row.count("o") for row in rows[1:-1])) == (3, 3)
    assert rows[-1] == "o reference  x yours  * both"
    assert "stopped after 4.00 s" in to_svg(picture)
    assert growth_picture(replace(GROWTH, points=POINTS[:1]), "") is None


@pytest.fixture
def runs(tmp_path):
    with History.open(tmp_path / "history.sqlite3") as history:
        result = past_result("count", "n-2000")
        keep(history, replace(result, time=Timing(4.3, 4.5, growth=GROWTH)), b"", "/x/mine.py")
        return list(history.runs())


def test_the_report_has_the_figures_that_a_run_has_kept(runs):
    plot = growth_plot("p", runs)
    assert plot.text == ("it grows like n^2.0, the reference like n^1.0; n^0.4 more than that is allowed")
    reference, own = plot.lines
    assert [dot.open for dot in own.dots] == [False, False, True]
    assert not any(dot.open for dot in reference.dots)
    assert [label for _, label in plot.columns] == ["500", "2,000", "8,000"]
    assert own.dots[-1].y < reference.dots[-1].y  # pixels from the top
    assert own.dots[1].title == "n = 2,000: 320 ms"
    assert growth_plot("p", []) is None


def test_what_the_reference_needs_is_told_where_it_is_missing():
    problem = find_problem("vector")
    assert problem.time.needs == ("numpy",)
    check_needs(problem)
    missing = replace(problem, time=replace(problem.time, needs=("no_such_module",)))
    with pytest.raises(UsageError, match=r"imports no_such_module, which is not installed; .*pip install"):
        check_needs(missing)
