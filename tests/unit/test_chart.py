"""The one chart: how the time grows."""

from __future__ import annotations

import pytest
from msgspec.structs import replace

from judge.drawing.braille import COLUMNS
from judge.drawing.chart import Axis, Chart, Series, chart_braille
from judge.drawing.shapes import Role
from judge.report.picture import growth_chart
from judge.run.result import Growth, GrowthPoint

POINTS = (
    GrowthPoint("n-500", 500, 0.02, 0.01),
    GrowthPoint("n-2000", 2_000, 0.32, 0.04),
    GrowthPoint("n-8000", 8_000, 4.0, 0.16, ended=False),
)
GROWTH = Growth(2.0, 1.0, 0.4, ("n-500", "n-2000"), 2, points=POINTS)


def text_of(chart, *rows):
    return ["".join(piece.text for piece in row) for row in chart_braille(chart, *rows)]


@pytest.mark.parametrize("rows", [1, 9, 12, 40])
def test_growth_on_a_terminal(rows):
    shown = text_of(growth_chart(GROWTH), rows)
    assert len(shown) == min(max(rows, 9), 16)
    assert max(map(len, shown)) <= COLUMNS
    assert shown[-1] == "o reference  x yours  CPU time over n"
    drawn = "".join(shown[:-2])
    assert drawn.count("x") + drawn.count("*") == 3
    assert [row.split()[0:2] for row in shown if row.startswith("100 ms")] == [["100", "ms"]]
    assert shown[-2].split() == ["500", "1,000", "2,000", "5,000"]


def test_one_size_is_no_growth():
    assert growth_chart(replace(GROWTH, points=POINTS[:1])) is None


@pytest.mark.parametrize(
    ("log", "values"),
    [(False, (0.0, 0.0)), (False, (0.0, 3.0)), (False, (0.0, 97.0)), (True, (0.0, 1e9)), (True, (7.0, 7.0))],
)
def test_any_values_have_their_place_and_a_few_labels(log, values):
    series = Series("</style><x>\x1b", ((1.0, values[0]), (1000.0, values[1])), Role.LINE)
    chart = Chart((series,), Axis("n", log=True), Axis("y", log=log))
    rows = text_of(chart)
    assert 0 < sum(row[:1] not in ("", " ") for row in rows[:-2]) <= 8
    assert max(map(len, rows)) <= COLUMNS
