"""`judge quiz`: what is kept however it ends, when cards come again, and the time of the mock interview.

What it asks and says is in the transcripts of `quiz/`.
"""

from __future__ import annotations

import io
import json
import sys
from datetime import timedelta
from pathlib import Path

import pytest
from cli_support import MEAN

from judge.cli import interview
from judge.kata import history as kept
from judge.kata.answers import Rating
from judge.kata.history import History


@pytest.fixture
def typing(judge, monkeypatch):
    """Run judge with these lines on its standard input."""

    def run(lines, *words):
        monkeypatch.setattr(sys, "stdin", io.StringIO("".join(f"{each}\n" for each in lines)))
        return judge(*words)

    return run


def answers():
    with History.open(reading=True) as history:
        return [(each.card, each.rating, each.judged, each.given) for each in history.answers()]


def test_answers_are_kept_with_their_rating(typing):
    typing(["seven", "3.5", "A"], "quiz", "halves", "--seed", "3")
    typing(["by a cross product", "5", "hard"], "quiz", "--card", "junior/dot-product")
    assert answers() == [
        ("halves/half-of-seven", Rating.GOOD, True, "3.5"),
        ("halves/rounding", Rating.AGAIN, True, "a"),
        ("junior/dot-product", Rating.HARD, False, "by a cross product"),
    ]


@pytest.mark.parametrize("lines", [[], ["3.5"], ["3.5", "q"], ["3.5", "x", ""]])
def test_whenever_it_ends_what_was_answered_is_kept(typing, lines):
    assert typing(lines, "quiz", "halves", "--seed", "3").status == 0
    assert len(answers()) == min(len(lines), 1)


def test_ctrl_c_keeps_what_was_answered_and_says_how_it_went(judge, monkeypatch):
    class Interrupted(io.StringIO):
        def readline(self, *size):
            text = super().readline(*size)
            if not text:
                raise KeyboardInterrupt
            return text

    monkeypatch.setattr(sys, "stdin", Interrupted("3.5\n"))
    ended = judge("quiz", "halves", "--seed", "3")
    assert ended.status == 130
    assert ended.out.endswith("1 of 1 card known\n")
    assert len(answers()) == 1


def test_known_cards_come_later_and_missed_ones_sooner(typing, judge, monkeypatch):
    noon = kept.now().replace(hour=12)
    monkeypatch.setattr("judge.kata.history.now", lambda: noon)
    typing(["3.5", "a"], "quiz", "halves", "--seed", "3")
    told = json.loads(judge("due", "--json").out)["cards"]
    dates = {each["card"]: each["due"] for each in told["later"]}
    assert dates["halves/rounding"] < dates["halves/half-of-seven"]
    monkeypatch.setattr("judge.kata.history.now", lambda: noon + timedelta(days=1))
    assert "judge quiz" in judge("due").out
    assert "1 card is due: judge quiz" in judge("next").out
    assert json.loads(judge("next", "--json").out)["cards_due"] == 1
    again = typing(["b"], "quiz", "halves", "--seed", "3")
    assert again.out.startswith("1 of 1  choice")


# -- the interview -----------------------------------------------------------------------------------------


def test_an_interview_keeps_its_runs_and_its_answers(typing, submit):
    submit(MEAN)
    words = ("--interview", "--cards", "3", "--kata", "middle", "--file", "mine.py", "--seed", "3")
    assert typing(["?", "?", "?", "?"], "quiz", "halves", *words).status == 0
    with History.open(reading=True) as history:
        assert [run.problem for run in history.runs()] == ["middle"]
    assert len(answers()) == 2


def test_the_file_of_an_interview_is_never_written_over(typing, submit):
    submit(MEAN, "middle_interview.py")
    typing(["q"], "quiz", "--interview", "--cards", "0", "--kata", "middle")
    assert Path("middle_interview.py").read_text() == MEAN


def test_when_the_time_is_over_no_card_is_asked_any_more(typing, monkeypatch):
    times = iter([0.0, 0.0, *[1e6] * 100])
    monkeypatch.setattr(interview.hold, "__defaults__", (lambda: next(times),))
    ended = typing(["?", "?", "?"], "quiz", "halves", "--interview", "--minutes", "10", "--kata", "middle")
    assert ended.status == 0
    assert len(answers()) == 1
    assert "10 of 10 minutes" in ended.out
