"""Thresholds next to the bands of sphere and silhouette, and what their promises say."""

import pytest

from judge.data import load_data
from judge.data.module import load_module
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.run.execute import run_submission

SILHOUETTE = (find_problem("silhouette").solutions / "accepted" / "state_machine.py").read_text()
WIDTH = "1e-10 * max(r, abs(fx), abs(fy))"


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("width", "verdict"),
    [("1.1e-12", Verdict.AC), ("9.5e-8", Verdict.AC), ("9e-13", Verdict.WA), ("1.2e-7", Verdict.WA)],
)
def test_any_threshold_in_the_gap_is_right_and_none_outside_of_it(width, verdict):
    assert WIDTH in SILHOUETTE
    problem, source = find_problem("silhouette"), SILHOUETTE.replace(WIDTH, WIDTH.replace("1e-10", width))
    assert run_submission(problem, load_data(problem), source.encode(), "mine.py").verdict is verdict


@pytest.mark.parametrize(
    ("name", "case", "words"),
    [
        ("sphere", ((0, 0, 0), 1, (-9.0, 1 + 1e-9, 0), (1, 0, 0)), "less the radius is inside the forbidden"),
        ("sphere", ((0, 0, 0), 1, (-90000, 0, 0), (1, 0, 0)), "the radius is not 0, but too small"),
        ("silhouette", (((0, 0, 1),), (0, 0), (0, 0), 0.1), "there is no line"),
        ("silhouette", (((0, 1, 1),), (0, 0), (1, 0), 0.1), "the circle of the first frame is touched"),
    ],
)
def test_a_promise_says_what_is_broken(name, case, words):
    assert words in load_module(find_problem(name)).solve(*case).broken
