"""How the time grows, drawn: for the terminal, as SVG and in the report; and loops that grow too fast."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from msgspec.structs import replace
from past_runs import StoppedClock, past_result

from judge.data import load_data
from judge.errors import UsageError
from judge.kata.history import History
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.problem.load import load_problem
from judge.report.page.growth import growth_plot
from judge.run.execute import run_submission
from judge.run.reference import check_needs
from judge.run.result import Growth, GrowthPoint, Timing

POINTS = (
    GrowthPoint("n-500", 500, 0.02, 0.01),
    GrowthPoint("n-2000", 2_000, 0.32, 0.04),
    GrowthPoint("n-8000", 8_000, 4.0, 0.16, ended=False),
)
GROWTH = Growth(2.0, 1.0, 0.4, ("n-500", "n-2000"), 2, points=POINTS)


@pytest.fixture
def runs(tmp_path):
    with History.open(tmp_path / "history.sqlite3", clock=StoppedClock()) as history:
        result = past_result("count", "n-2000")
        history.add(replace(result, time=Timing(4.3, 4.5, growth=GROWTH)), b"", "/x/mine.py")
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


# -- the katas of many circles: the rule is told with each group in transcripts/why/growth.txt ----------

ROOT = Path(__file__).parents[2]
GROWS = re.compile(r"it grows like n\^(\d\.\d), the reference like n\^(\d\.\d)")
SIZES = {"n-500", "n-2000"}


@pytest.fixture(scope="module")
def judged(tmp_path_factory):
    """Judges a program by nothing but its growth, on cases of the two small sizes."""
    folder = tmp_path_factory.mktemp("growth")

    def judge(name, source):
        problem = folder / "problems" / name
        if not problem.exists():
            shutil.copytree(ROOT / "problems" / name, problem)
            shutil.copytree(ROOT / "solutions" / name, folder / "solutions" / name)
            (problem / "hashes.json").unlink()
            text = (problem / "problem.toml").read_text(encoding="utf-8")
            text = re.sub(r"\[groups\.time\]\nlimit = \d+\n", "[groups.time]\nlimit = 10000\n", text)
            text = re.sub(
                r"cpu_seconds = \d+(\nwall_seconds = \d+)?", "cpu_seconds = 60\nwall_seconds = 600", text
            )
            text = re.sub(r"(seed = 7[12]10\ncount =) \d+", r"\1 20", text)  # to count on a quick machine too
            text = text[: text.index('[[groups]]\nname = "n-8000"')].replace(', "n-8000", "n-32000"', "")
            left = 100 - sum(map(int, re.findall(r"^points = (\d+)", text, re.MULTILINE)))
            text = text.replace("points = 0\n", f"points = {left}\n", 1)
            (problem / "problem.toml").write_text(text, encoding="utf-8")
        loaded = load_problem(problem)
        data = load_data(loaded, cache=False)
        return run_submission(loaded, data, source, "naive.py", groups=SIZES)

    return judge


def check_too_steep(result):
    assert result.verdict is Verdict.TLE
    growth = result.time.growth
    assert set(growth.groups) == SIZES
    assert growth.exponent > growth.reference + growth.slope
    assert GROWS.search(result.failure.message)
    assert "its exponent may exceed that by 0.4" in result.failure.message  # and no other limit struck


@pytest.mark.nightly
@pytest.mark.parametrize("name", ["nearest", "beams"])
def test_the_naive_loop_is_too_slow_by_how_it_grows(name, judged):
    check_too_steep(judged(name, (ROOT / "solutions" / name / "slow" / "quadratic.py").read_bytes()))
