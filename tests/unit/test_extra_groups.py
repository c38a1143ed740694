"""Groups worth no points: a run that fails only such ones has all points, and must not look passed."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest

from judge.kata.history import History
from judge.kata.sets import PracticeSet
from judge.kata.standing import Standing
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.report.history import history_lines
from judge.report.interview import Outcome, page_lines
from judge.report.practice import practice_lines
from judge.report.results import group_table, summary_lines, verdict_lines
from judge.report.values import score_text
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


def test_such_a_group_is_extra_in_the_table():
    last = text(group_table(EXTRA.groups).lines(None)).splitlines()[-1]
    assert last.split() == ["g2", "WA", "4/9", "extra"]


def test_the_table_of_several_files_says_so_too():
    row = text(summary_lines([EXTRA, EXTRA], None)).splitlines()[1]
    assert "extra fails" in row
    assert "100" not in row


@pytest.mark.parametrize(
    ("score", "accepted", "said"), [(100, False, "extra fails"), (100, True, "100"), (99, False, "99")]
)
def test_a_score_of_all_points_is_said_of_what_was_accepted_only(score, accepted, said):
    assert score_text(score, accepted=accepted) == said


def test_a_kata_that_fails_extra_groups_only_is_not_at_its_best():
    when = datetime(2026, 11, 20, tzinfo=UTC)
    katas = [(find_problem("beams"), Standing(2, 100, None, when))]
    chosen = PracticeSet("one", "One", "Only one.", (katas[0][0],))
    assert "extra fails" in text(practice_lines(chosen, katas, None, None))


def test_the_history_and_the_interview_say_so(tmp_path):
    with History.open(tmp_path / "runs.db") as history:
        history.add(EXTRA, b"", "/my.py")
        assert "WA extra fails" in text(history_lines(history.runs(), None))
    outcome = Outcome(find_problem("beams"), "beams.py", 2, EXTRA)
    assert "beams: WA, all points, but an extra group fails, after 2 runs" in text(page_lines_of(outcome))


def page_lines_of(outcome):
    return page_lines([], outcome, [], (9, 30), None)
