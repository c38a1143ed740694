"""Groups worth no points: a run that fails only such ones has all points, and must not look passed.

The tables, the history and a practice set are in golden/transcripts: run/extra-groups.txt.
"""

from __future__ import annotations

import pytest

from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.report.interview import Outcome, page_lines
from judge.report.results import verdict_lines
from judge.run import GroupResult, Mode, Result


def text(lines):
    return "\n".join("".join(span.text for span in line) for line in lines)


def run(*groups):
    """A result of groups, each its verdict and its points."""
    made = tuple(
        GroupResult(f"g{at}", verdict, 9, 9 if verdict is Verdict.AC else 4, None, 0.0, points)
        for at, (verdict, points) in enumerate(groups)
    )
    worst = next((group.verdict for group in made if group.verdict is not Verdict.AC), Verdict.AC)
    return Result("beams", "my.py", Mode.FUNCTION, worst, made)


EXTRA = run((Verdict.AC, 60), (Verdict.AC, 40), (Verdict.WA, 0))


@pytest.mark.parametrize(
    ("result", "said"),
    [
        (EXTRA, "WA  wrong answer, all 100 points, but 1 extra group fails, 22 of 27 cases"),
        (run((Verdict.AC, 100), (Verdict.TLE, 0), (Verdict.WA, 0)), "100 points, but 2 extra groups fail, "),
        (run((Verdict.AC, 60), (Verdict.WA, 40), (Verdict.WA, 0)), "WA  wrong answer, 60 of 100 points, "),
        (run((Verdict.AC, 100), (Verdict.AC, 0)), "AC  accepted, 100 of 100 points, "),
        (run((Verdict.WA, 0)), "WA  wrong answer, 1 extra group fails, "),
    ],
)
def test_the_verdict_says_what_the_points_do_not(result, said):
    assert said in text(verdict_lines(result, None))


def test_the_interview_says_so():
    shown = text(page_lines([], Outcome(find_problem("beams"), "beams.py", 2, EXTRA), [], (9, 30), None))
    assert "beams: WA, all points, but an extra group fails, after 2 runs" in shown
