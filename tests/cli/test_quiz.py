"""`judge quiz` and `judge interview`: what is kept however they end, when cards come again, the time.

What they ask and say is in the transcripts of `quiz/`.
"""

from __future__ import annotations

import io
import json
import os
import re
import sys
from datetime import timedelta
from pathlib import Path

import pytest
from cli_support import MEAN, ROOT
from sampling import nightly
from terminals import Terminal

from judge.practice import events
from judge.practice.events import Answer, Rating
from judge.practice.history import History
from judge.practice.review import card_reviews

pytestmark = pytest.mark.slow


@pytest.fixture
def typing(judge, monkeypatch):
    """Run judge with these lines on its standard input; the options of a card are in the same order."""
    monkeypatch.setattr("judge.cli.commands.interview.secrets.randbits", lambda _bits: 1)

    def run(lines, *words):
        typed = "".join(f"{each}\n" for each in lines).encode()
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(typed)))
        return judge(*words)

    return run


@pytest.fixture
def one(tmp_path, monkeypatch):
    """A deck that has one of the shipped cards, and its name."""

    def write(key):
        deck, name = key.split("/")
        _, *cards = (ROOT / "problems" / "quiz" / f"{deck}.toml").read_text().split("[[cards]]\n")
        (text,) = (each for each in cards if f'id = "{name}"' in each)
        folder = tmp_path / "own" / "quiz"
        folder.mkdir(parents=True, exist_ok=True)
        (folder / f"{name}.toml").write_text(f'title = "One"\n[[cards]]\n{text}')
        monkeypatch.setenv("JUDGE_PROBLEMS", f"{folder.parent}{os.pathsep}{os.environ['JUDGE_PROBLEMS']}")
        return name

    return write


def answers():
    with History(reading=True) as history:
        return [(each.card, each.rating, each.judged, each.given) for each in history.events(Answer)]


def test_answers_are_kept_with_their_rating(typing, one):
    typing(["seven", "3.5", "A"], "quiz", "halves")
    typing(["by a cross product", "5", "2"], "quiz", one("junior/dot-product"))
    assert answers() == [
        ("halves/half-of-seven", Rating.GOOD, True, "3.5"),
        ("halves/rounding", Rating.AGAIN, True, "a"),
        ("dot-product/dot-product", Rating.HARD, False, "by a cross product"),
    ]


@pytest.mark.parametrize("lines", [[], ["3.5", "q"], ["3.5", "x", ""]])
def test_whenever_it_ends_what_was_answered_is_kept(typing, lines):
    assert typing(lines, "quiz", "halves").status == 0
    assert len(answers()) == min(len(lines), 1)


def test_known_cards_come_later_and_missed_ones_sooner(typing, judge, monkeypatch):
    noon = events.now().replace(hour=12)
    monkeypatch.setattr("judge.practice.events.now", lambda: noon)
    typing(["3.5", "a"], "quiz", "halves")
    with History(reading=True) as history:
        dates = {each.name: each.due for each in card_reviews(history.events(Answer))}
    assert dates["halves/rounding"] < dates["halves/half-of-seven"]
    assert "Nothing is due today" in judge("quiz", "halves").out
    monkeypatch.setattr("judge.practice.events.now", lambda: noon + timedelta(days=1))
    assert "judge quiz" in judge("progress", "--due").out
    assert "judge quiz      1 card due" in judge().out
    again = typing(["b"], "quiz", "halves")
    assert again.out.startswith("Question 1 of 1\n  What is 7 // 2")


def test_new_cards_are_of_the_highest_set_with_a_solved_kata(judge, submit, typing):
    def first(*words):
        return typing(["?"] * 6, "quiz", "--cards", "6", *words).out

    assert "distance from A to B" in first("--db", "newcomer.sqlite3")  # of the first steps
    submit((ROOT / "solutions" / "count" / "accepted" / "tolerant.py").read_text(), "count.py")
    assert judge("run", "-q", "count", "count.py").status == 0
    assert "distance from A to B" not in first()


def test_the_summary_is_all_that_json_writes(typing):
    ended = typing(["?", "b"], "quiz", "halves", "--json")
    assert len(ended.lines) == 1
    told = json.loads(ended.lines[0])
    ratings = [each["rating"] for each in told["answers"]]
    assert (told["asked"], told["known"], ratings) == (2, 1, [1, 3])
    assert "Question 1 of 2" in ended.err


# -- the interview -----------------------------------------------------------------------------------------


def test_an_interview_keeps_its_runs_and_its_answers(typing, submit):
    submit(MEAN, "middle_interview.py")
    ended = typing(["?", "?", "", "?"], "interview", "halves", "--kata", "middle")
    assert ended.status == 0
    with History(reading=True) as history:
        assert [run.problem for run in history.runs()] == ["middle"]
    assert len(answers()) == 2
    assert "middle: AC, 100 of 100 points after 1 run" in ended.out


def test_the_file_of_an_interview_is_never_written_over(typing, submit):
    submit(MEAN, "middle_interview.py")
    typing(["?", "?", "q"], "interview", "halves", "--kata", "middle")
    assert Path("middle_interview.py").read_text() == MEAN


@pytest.mark.parametrize(
    ("lines", "asked", "runs"),
    [
        (["q", "q", "?"], 0, 0),
        (["q", "", "q", "?"], 1, 1),
        (["?", "q", "q", "?"], 1, 0),
        (["?", "q", "", "q", "?"], 2, 1),
    ],
)
def test_q_goes_on_to_the_next_part_and_a_second_q_ends_it(typing, submit, lines, asked, runs):
    submit("def middle(a, b):\n    return 1\n", "middle_interview.py")
    ended = typing(lines, "interview", "first-steps", "--minutes", "10", "--kata", "middle", "--json")
    told = json.loads(ended.lines[0])
    assert (told["asked"], told["runs"]) == (asked, runs)


def test_when_the_time_is_over_no_card_is_asked_any_more(typing, monkeypatch):
    times = iter([0.0, 0.0, *[1e6] * 100])
    monkeypatch.setattr("judge.cli.commands.interview.monotonic", lambda: next(times))
    ended = typing(["?", "?", "?"], "interview", "halves", "--minutes", "10", "--kata", "middle")
    assert ended.status == 0
    assert len(answers()) == 1
    assert "10 of 10 minutes" in ended.out


# -- on a terminal ---------------------------------------------------------------------------------------


def plain(text):
    """What a person sees of it."""
    return re.sub(r"\x1b\[[0-9;?]*[a-zA-Z]", "", text).replace("\r\n", "\n")


@pytest.mark.parametrize(
    ("card", "rows", "columns"),
    [
        ("senior/tags-drawn", 24, 40),
        nightly("junior/points-drawn", 24, 80),
        nightly("middle/first-hit-drawn", 50, 100),
    ],
)
def test_a_question_with_its_figure_fits_the_screen(card, rows, columns, one, tmp_path):
    (tmp_path / "sitecustomize.py").write_text("import secrets\nsecrets.randbits = lambda _bits: 4\n")
    path = f"{tmp_path}{os.pathsep}{ROOT}"
    with Terminal("quiz", one(card), rows=rows, columns=columns, PYTHONPATH=path) as terminal:
        shown = plain(terminal.until("):"))
        if card == "junior/points-drawn":  # whose figure comes with the answer
            terminal.press("?\n")
            shown = plain(terminal.until("Practise")).partition("0 of 1")[0].rpartition("Question 1")[2]
        lines = shown.split("\n")
        assert len(lines) <= rows
        assert all(len(line) <= columns for line in lines)
        assert sum(bool(re.search("[\u2801-\u28ff]", row)) for row in lines) >= 7
        terminal.press("?\n")
        assert terminal.ends() == 0


@pytest.mark.parametrize(("key", "status"), [("\x03", 130), nightly("\x04", 0)])
def test_ctrl_c_and_ctrl_d_keep_what_was_answered(key, status):
    with Terminal("quiz", "halves") as terminal:
        terminal.until("):")
        terminal.press("3.5\n")
        terminal.until("2 of 2")
        terminal.until("):")
        terminal.press(key)
        terminal.until("1 of 1 card known")
        assert terminal.ends() == status
        assert "Traceback" not in terminal.written
    with History(reading=True) as history:
        assert [each.card for each in history.events(Answer)] == ["halves/half-of-seven"]


def test_the_kata_of_an_interview_is_judged_when_its_file_is_saved():
    words = ["interview", "halves", "--kata", "middle", "--minutes", "60"]
    with Terminal(*words, rows=40, columns=100) as terminal:
        for _ in range(2):
            terminal.until("):")
            terminal.press("?\n")
        terminal.until("q goes on:")
        terminal.press("\n")
        terminal.until("0 of 52 cases pass")
        terminal.until("q goes on:")
        Path("middle_interview.py").write_text(MEAN)
        terminal.until("all 52 cases pass")
        terminal.until("middle: AC, 100 of 100 points after 2 runs")
        assert terminal.ends() == 0
