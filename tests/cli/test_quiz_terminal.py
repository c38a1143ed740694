"""`judge quiz` on a terminal: figures are drawn and fit, Ctrl-C and Ctrl-D leave in peace."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from cli_support import MEAN
from sampling import nightly
from terminals import Terminal

from judge.kata.history import History

pytestmark = pytest.mark.slow


def plain(text):
    """What a person sees of it."""
    return re.sub(r"\x1b\[[0-9;?]*[a-zA-Z]", "", text).replace("\r\n", "\n")


def drawn(text):
    """The rows that hold braille characters."""
    return [row for row in text.split("\n") if re.search("[\u2801-\u28ff]", row)]


@pytest.mark.parametrize(
    ("card", "rows", "columns"),
    [
        ("senior/tags-drawn", 24, 40),
        *(
            nightly(card, rows, columns)
            for card in ("junior/points-drawn", "middle/first-hit-drawn", "senior/tags-drawn")
            for rows, columns in ((24, 80), (24, 40), (50, 100))
            if (card, columns) != ("senior/tags-drawn", 40)
        ),
    ],
)
def test_a_question_with_its_figure_fits_the_screen(card, rows, columns):
    words = ["quiz", "--card", card, "--cards", "1", "--seed", "4"]
    with Terminal(*words, rows=rows, columns=columns) as terminal:
        shown = plain(terminal.until(" > "))
        lines = shown.split("\n")
        assert len(lines) <= rows
        assert all(len(line) <= columns for line in lines)
        assert len(drawn(shown)) >= 7
        assert "wanted" not in shown
        terminal.press("?\n")
        assert "not known" in terminal.until("To drill")
        assert terminal.ends() == 0


@pytest.mark.parametrize(("key", "status"), [("\x03", 130), nightly("\x04", 0)])
def test_ctrl_c_and_ctrl_d_keep_what_was_answered(key, status):
    with Terminal("quiz", "halves", "--seed", "3") as terminal:
        terminal.until(" > ")
        terminal.press("3.5\n")
        terminal.until("2 of 2")
        terminal.until(" > ")
        terminal.press(key)
        terminal.until("1 of 1 card known")
        assert terminal.ends() == status
        assert "Traceback" not in terminal.written
    with History.open(reading=True) as history:
        assert [each.card for each in history.answers()] == ["halves/half-of-seven"]


def test_the_kata_of_an_interview_is_judged_when_its_file_is_saved():
    words = ["quiz", "--interview", "--cards", "0", "--kata", "middle", "--minutes", "60"]
    with Terminal(*words, rows=40, columns=100) as terminal:
        terminal.until("q to go on")
        terminal.press("what\n")
        terminal.until("an empty line has the file judged")
        terminal.until("q to go on")
        Path("middle_interview.py").write_text(MEAN)
        terminal.until("accepted, 100 of 100 points")
        terminal.until("middle: AC, 100 of 100 points after 1 run")
        assert terminal.ends() == 0
