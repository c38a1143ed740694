"""What a person is told of a submission's own threshold: the line on screen, and the plot in the report."""

from __future__ import annotations

import pytest
from msgspec.structs import replace
from page_support import check_html, html_of, kept, outcome, page_of
from sampling import nightly

import judge
from judge.data import load_data
from judge.judging import diagnosis
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.report.thresholds import threshold_text, worth_telling
from judge.run.result import GroupResult, Mode, Result, Timing
from judge.run.thresholds import Flip, Law, Threshold

SIZES = [(1.0, 0.6), (2e-7, 1e-7), (1e6, 6e5), (1.0, 1e-3)]  # extent and radius


def threshold(powers, factor, mistake=None, *, constant=0.0, within=1e-12, beyond=1e-7, decision="a touch"):
    """What is measured of a submission whose threshold follows that law."""
    law = Law(powers, factor, constant)
    figures = []
    for extent, radius in SIZES:
        sizes = {"extent": extent, "radius": radius}
        gap = law.of(sizes)
        figures.append(Flip(sizes, 0.9 * gap, 1.1 * gap if gap else 1e-16 * extent))
    return Threshold(decision, within, beyond, tuple(figures), law, mistake)


ABSOLUTE = threshold({}, 1e-9, "absolute-epsilon")
RIGHT = threshold({"extent": 1}, 1e-10)
SENTENCES = {
    "for a touch: 1e-9 at size 1, 5e-3 of it at size 2e-7; it does not grow with the figure": ABSOLUTE,
    "for a touch: 1e-10 of the extent; that is between 1e-12 and 1e-7, as it should be": RIGHT,
    "for a touch: 1e-5 of the extent; it must be 1e-7 at most": threshold(
        {"extent": 1}, 1e-5, "loose-epsilon"
    ),
    "for a touch: 2e-14 of the extent; it must be 1e-12 at least": threshold(
        {"extent": 1}, 2e-14, "tight-epsilon"
    ),
    "for a touch: 1e-9 of the radius; it must follow the extent": threshold(
        {"radius": 1}, 1e-9, "radius-epsilon"
    ),
    "for a touch: 1e-8 + 1e-5 of the radius; its first part does not grow with the figure": threshold(
        {"radius": 1}, 1e-5, "absolute-epsilon", constant=1e-8
    ),
    "for a touch: 8e-10 at size 1; it does not grow as the figure does": threshold(
        {"radius": -1}, 5e-16 / 1e-6, "absolute-epsilon"
    ),
    "for a touch: none, or none that rounding leaves; 1e-12 of the extent is no gap yet": threshold(
        {}, 0.0, "no-epsilon"
    ),
    "for a touch: 1e-9 at size 1, 5e-3 of it at size 2e-7; there should be none": threshold(
        {}, 1e-9, "absolute-epsilon", within=0, beyond=0
    ),
    "for a touch: 1e-9 of the extent; there should be none": threshold(
        {"extent": 1}, 1e-9, "loose-epsilon", within=0, beyond=0
    ),
}


@pytest.mark.parametrize("sentence", SENTENCES)
def test_a_threshold_in_words(sentence):
    assert threshold_text(SENTENCES[sentence]) == sentence


def test_after_a_wrong_answer_only_what_is_wrong_is_told():
    other = threshold({}, 1e-6, "absolute-epsilon", decision="an end")
    none = threshold({}, 0.0, within=0, beyond=0)
    assert worth_telling((RIGHT, other, ABSOLUTE), accepted=False) == other
    assert worth_telling((RIGHT, other, ABSOLUTE), accepted=True) == other
    assert worth_telling((none, RIGHT), accepted=True) == RIGHT
    assert worth_telling((none, RIGHT), accepted=False) is None


# -- the report ----------------------------------------------------------------------------------------------


def plot_of(tmp_path, *thresholds, verdict=Verdict.WA):
    """The plot of the page of a run with each of these."""
    runs = kept(
        tmp_path / "h.db", [replace(outcome(verdict=verdict), thresholds=each) for each in thresholds]
    )
    (part,) = page_of(runs).problems
    return part.thresholds


def test_the_plot_shows_figures_bands_and_sizes(tmp_path):
    plot = plot_of(tmp_path, (ABSOLUTE,))
    assert (plot.run, plot.size, plot.text) == (1, "extent", threshold_text(ABSOLUTE))
    high, low = plot.free
    assert high < low  # the promise is above the band
    at = {dot.x: dot.y for dot in plot.dots}
    assert len(at) == 3
    small, usual, large = (at[x] for x in sorted(at, key=lambda x: float(x.removesuffix("%"))))
    assert small < high < usual < low < large  # a fixed number falls from left to right
    assert [label for _, label in plot.columns] == ["1e-6", "1e-3", "1", "1000", "1e6"]


def test_what_follows_the_size_is_level_and_what_lies_below_rounding_is_a_bound(tmp_path):
    level = plot_of(tmp_path, (RIGHT,), verdict=Verdict.AC)
    assert len({dot.y for dot in level.dots}) == 1
    assert not any(dot.open for dot in level.dots)
    none = plot_of(tmp_path / "none", (threshold({}, 0.0, "no-epsilon"),))
    assert all(dot.open for dot in none.dots)


def test_the_latest_run_with_thresholds_is_shown(tmp_path):
    assert plot_of(tmp_path, (ABSOLUTE,), ()).run == 1
    assert plot_of(tmp_path / "b", (ABSOLUTE,), (RIGHT,)) is None  # the mistake is mended, another one is not
    assert plot_of(tmp_path / "c", ()) is None


def test_the_page_with_a_plot_is_sound(tmp_path):
    html = html_of(kept(tmp_path / "h.db", [replace(outcome(), thresholds=(ABSOLUTE,))]))
    check_html(html)
    assert "Your threshold" in html
    assert "it does not grow with the figure" in html


# -- of contained submissions: they cost nothing, and never change a verdict ---------------------------------

CONTAINED = """
from math import hypot

def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == dy == 0:
        return None
    ax, ay, bx, by = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    extent = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    gap = abs(dx * ay - dy * ax) / hypot(dx, dy) - r
    if 1e-11 * extent < abs(gap) < 1e-8 * extent:  # no case is there
        IN_THE_GAP
    return 1 if abs(gap) <= 1e-10 * extent else 2 if gap < 0 else 0
"""


def judged(source, **options):
    return judge.judge("count", source, timed=False, named=False, **options)


@pytest.mark.slow
def test_an_accepted_submission_is_told_of_one_border():
    (found,) = judged(CONTAINED.replace("IN_THE_GAP", "pass")).thresholds
    assert (found.decision, found.mistake, found.follows_its_size) == ("a tangency", None, True)
    assert len(found.figures) == 9
    assert all(flip.low <= 1e-10 * flip.size <= flip.high for flip in found.figures)


@pytest.mark.slow
@pytest.mark.parametrize(
    "harm",
    [
        nightly("raise SystemExit"),
        "import os; os._exit(0)",
        nightly("import time; time.sleep(60)"),
        nightly("while True: pass"),
        nightly("x = 'x' * (1 << 40)"),
        nightly("print('x' * (1 << 24))"),
        nightly("return 'one'"),
        "import random; return random.choice((0, 1, 2))",
    ],
)
def test_harm_in_the_gap_changes_no_verdict(harm):
    result = judged(CONTAINED.replace("IN_THE_GAP", harm))
    assert (result.verdict, result.score, result.thresholds, result.notes) == (Verdict.AC, 100, (), ())


def test_without_the_search_for_a_smaller_case_nothing_is_measured():
    assert judged(CONTAINED.replace("IN_THE_GAP", "pass"), diagnosed=False).thresholds == ()


def test_a_fault_of_ours_leaves_the_result_as_it_is(monkeypatch):
    def fails(*_, **__):
        raise RuntimeError("a fault")

    monkeypatch.setattr("judge.mistakes.thresholds.measured", fails)
    result = judged(CONTAINED.replace("IN_THE_GAP", "pass"))
    assert (result.verdict, result.thresholds, result.notes) == (Verdict.AC, (), ())


def quick(verdict=Verdict.AC, cpu_seconds=0.001):
    groups = (GroupResult("grid", verdict, 100, 100, None, cpu_seconds),)
    return Result("count", "a.py", Mode.FUNCTION, verdict, groups, time=Timing(cpu_seconds, cpu_seconds))


@pytest.mark.parametrize("result", [quick(cpu_seconds=1.0), quick(Verdict.TLE), quick(Verdict.RTE)])
def test_a_slow_or_crashing_submission_is_not_asked(result, monkeypatch):
    monkeypatch.setattr("judge.mistakes.thresholds.measured", lambda *_, **__: pytest.fail("it was asked"))
    data = load_data(find_problem("count"))
    assert diagnosis.with_thresholds(result, data, None, None) is result
    asked = []
    monkeypatch.setattr("judge.mistakes.thresholds.measured", lambda *_, **__: asked.append(1) or ())
    assert diagnosis.with_thresholds(quick(), data, None, None) == replace(quick(), thresholds=())
    assert asked == [1]
