"""Thresholds next to the bands of sphere and silhouette, and what their promises say."""

import pytest

from judge.data import load_data
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
