"""`judge quiz`: what is shown, what is kept whatever happens, and the mock interview."""

from __future__ import annotations

import io
import json
import sys
from datetime import timedelta
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN

from judge.cli import interview
from judge.kata import history as kept
from judge.kata.answers import Rating
from judge.kata.history import History

pytestmark = pytest.mark.slow

SCREEN = """\
1 of 2  number
  What is half of 7?
  a number such as 4, 0.5, 1e-9 or 2/3 >{space}
  'seven' is no answer here; type a number such as 4, 0.5, 1e-9 or 2/3
  a number such as 4, 0.5, 1e-9 or 2/3 >{space}
  ✓ right
  why      7/2, and not 7//2.

2 of 2  choice
  What is 7 // 2 in Python?
  a  4
  b  3
  a or b >{space}
  ✗ wrong: rounded-up
  because  That is -(-7 // 2).
  answer   b  3
  why      It is rounded down.

1 of 2 cards known
"""
NARROW = """\
1 of 1  spot  W3  M18  M4  F5
  Which group of cases breaks this
  program?
"""


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


def test_the_screen_of_a_round(typing, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    ended = typing(["seven", "3.5", "A"], "quiz", "halves", "--seed", "3")
    assert ended.status == 0, ended
    assert ended.out == SCREEN.format(space=" ")
    assert answers() == [
        ("halves/half-of-seven", Rating.GOOD, True, "3.5"),
        ("halves/rounding", Rating.AGAIN, True, "a"),
    ]


@pytest.mark.parametrize("columns", [40, 80])
@pytest.mark.parametrize(
    "card",
    [
        "junior/points-drawn",
        "middle/order-drawn",
        "senior/tags-drawn",
        "middle/spot-segment",
        "middle/half-b",
    ],
)
def test_no_line_is_wider_than_the_screen(typing, monkeypatch, columns, card):
    monkeypatch.setenv("COLUMNS", str(columns))
    ended = typing(["x", "?"], "quiz", "--card", card, "--cards", "1", "--seed", "1")
    assert ended.status == 0
    program = card.startswith("middle/spot")  # whose lines are left as they are
    assert all(len(row) <= columns for row in ended.lines if not (program and row.startswith("    ")))
    assert "To drill" in ended.out


def test_a_narrow_screen(typing, monkeypatch):
    monkeypatch.setenv("COLUMNS", "40")
    ended = typing(["q"], "quiz", "--card", "middle/spot-segment", "--cards", "1", "--seed", "1")
    assert ended.out.startswith(NARROW)
    assert ended.out.endswith("No card was answered.\n")


def test_a_recall_card_takes_an_answer_and_a_rating(typing):
    ended = typing(["by a cross product", "5", "hard"], "quiz", "--card", "junior/dot-product")
    assert "  type 1 again, 2 hard, 3 good, 4 easy\n" in ended.out
    assert "model" in ended.out
    assert "noted: hard" in ended.out
    assert answers() == [("junior/dot-product", Rating.HARD, False, "by a cross product")]


@pytest.mark.parametrize("lines", [[], ["3.5"], ["3.5", "q"], ["3.5", "x", ""]])
def test_whenever_it_ends_what_was_answered_is_kept(typing, lines):
    ended = typing(lines, "quiz", "halves", "--seed", "3")
    assert ended.status == 0
    assert len(answers()) == min(len(lines), 1)
    assert ended.out.endswith("1 of 1 card known\n" if lines else "No card was answered.\n")


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


def test_bytes_that_are_no_text_are_no_answer(judge, monkeypatch):
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"\xff\xfe\x00\n3.5\n"), encoding="utf-8"))
    ended = judge("quiz", "--card", "halves/half-of-seven")
    assert "is no answer here" in ended.out
    assert "✓ right" in ended.out
    assert "\x00" not in ended.out


def test_events_for_a_program(typing):
    ended = typing(["x", "3.5", "a"], "quiz", "halves", "--seed", "3", "--json")
    events = [json.loads(row) for row in ended.lines]
    assert [each["event"] for each in events] == [
        "question",
        "mistyped",
        "answer",
        "question",
        "answer",
        "end",
    ]
    assert (events[0]["card"], events[0]["of"], events[0]["seed"]) == ("halves/half-of-seven", 2, 3)
    assert (events[2]["right"], events[2]["rating"]) == (True, "good")
    assert (events[4]["right"], events[4]["mistake"]) == (False, "rounded-up")
    assert (events[5]["asked"], events[5]["known"]) == (2, 1)


def test_known_cards_come_later_and_missed_ones_sooner(typing, judge, monkeypatch):
    typing(["3.5", "a"], "quiz", "halves", "--seed", "3")
    assert "Nothing is due; the next card is on" in judge("quiz", "halves").out
    told = json.loads(judge("due", "--json").out)["cards"]
    assert (told["due"], len(told["later"])) == ([], 2)
    dates = {each["card"]: each["due"] for each in told["later"]}
    assert dates["halves/rounding"] < dates["halves/half-of-seven"]
    assert json.loads(judge("next", "--json").out)["cards_due"] == 0
    later = kept.now() + timedelta(days=1, hours=1)
    monkeypatch.setattr("judge.kata.history.now", lambda: later)
    assert "judge quiz" in judge("due").out
    assert "1 card is due: judge quiz" in judge("next").out
    assert json.loads(judge("next", "--json").out)["cards_due"] == 1
    again = typing(["b"], "quiz", "halves", "--seed", "3")
    assert again.out.startswith("1 of 1  choice")


def test_a_card_ticks_its_rows_and_loses_them(typing, judge):
    def state():
        return json.loads(judge("progress", "--row", "J13", "--json").out)

    assert state()["state"] == "open"
    typing(["", "3"], "quiz", "--row", "j13")
    assert state()["state"] == "shown"
    assert [each["kind"] for each in state()["by"]] == ["card"]
    typing(["", "1"], "quiz", "--row", "J13")
    assert state()["state"] == "lost"
    assert "lost" in judge("progress", "--rows", "junior").out or "lost" in judge("progress", "--rows").out


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["nothing"], "no set of cards is called 'nothing'"),
        (["junoir"], "did you mean 'junior'?"),
        (["first-steps"], "the set 'first-steps' has no cards; cards are in junior, "),
        (["--row", "J99"], "the checklist has no row 'J99'"),
        (["--form", "recal"], "no form of cards is called 'recal'; did you mean 'recall'?"),
        (["--card", "junior/dot-prodct"], "there is no card 'junior/dot-prodct'; did you mean"),
        (["halves", "--row", "J1"], "no card drills the row 'J1'"),
        (["--row", "Q1", "--form", "tags"], "none of those cards has the form 'tags'; leave out --form"),
        (["--card", "order-drawn", "--form", "tags"], "none of those cards has the form 'tags'"),
        (["halves", "--card", "middle/order-drawn"], "the card 'middle/order-drawn' is not among those"),
        (["--cards", "0"], "--cards 0 asks nothing"),
        (["--interview", "--list"], "--interview and --list do not go together; leave one of them out"),
        (["--list", "--check"], "--list and --check do not go together"),
        (["--minutes", "5"], "--minutes belongs to --interview"),
        (["--file", "mine.py"], "--file belongs to --interview"),
        (["--interview", "--kata", "cuont"], "no problem is called 'cuont'; did you mean 'count'?"),
        (["--interview", "--kata", "middle", "--file", "gone.py"], "gone.py: no such file"),
        (["--seed", "-1"], "-1 is not in the range"),
    ],
)  # fmt: skip
def test_what_cannot_be_asked_is_one_line(typing, words, said):
    ended = typing([], "quiz", *words)
    assert (ended.status, ended.out) == (2, "")
    assert ended.err.startswith("judge: ")
    assert said in ended.err
    assert ended.err.count("\n") == 1


def test_a_broken_deck_is_one_line_and_costs_progress_only_a_note(judge, tmp_path):
    folder = tmp_path / "own" / "quiz"
    folder.mkdir(parents=True)
    (folder / "mine.toml").write_text('title = "M"\n[[cards]]\nid = "a"\nform = "recal"\nfront = "?"\n')
    ended = judge("quiz", "--problems", tmp_path / "own")
    assert (ended.status, ended.out) == (3, "")
    assert (
        ended.err == "judge: quiz/mine.toml:4: no form of cards is called 'recal'; did you mean 'recall'?\n"
    )
    progress = judge("progress", "--rows", "--problems", tmp_path / "own")
    assert progress.status == 0
    assert "quiz/mine.toml:4" in progress.err
    assert "J1 " in progress.out


def test_a_card_of_a_problem_that_is_not_here_is_passed_over(typing, judge, tmp_path):
    folder = tmp_path / "own" / "quiz"
    folder.mkdir(parents=True)
    card = '[[cards]]\nid = "{}"\nform = "{}"\nfront = "F?"\nback = "B."\n{}'
    text = card.format("a", "count", 'problem = "later"\n') + card.format("b", "number", 'answer = "1"\n')
    (folder / "mine.toml").write_text(f'title = "M"\n{text}')
    ended = typing(["1"], "quiz", "mine", "--problems", tmp_path / "own")
    assert ended.out.startswith("1 of 1  number")
    checked = judge("quiz", "mine", "--check", "--problems", tmp_path / "own")
    assert "mine/a is left out: no problem is called 'later'" in checked.err
    assert "1 card checked" in checked.out


def test_cards_are_listed_and_checked(judge):
    listed = judge("quiz", "halves", "--list")
    assert "halves/rounding" in listed.out
    assert listed.lines[-1] == "2 cards, 2 new"
    assert len(judge("quiz", "--list", "--json").lines) > 120
    assert judge("quiz", "halves", "--check").out == "sound  2 cards checked\n"


@pytest.mark.parametrize("width", [40, 60, 80])
def test_a_listed_card_has_one_line_where_there_is_room(judge, monkeypatch, width):
    monkeypatch.setenv("COLUMNS", str(width))
    listed = judge("quiz", "middle", "--list").lines
    assert max(map(len, listed)) <= width
    if width == 80:
        cards = int(listed[-1].split()[0])
        assert len(listed) == cards + 3
        assert any(line.endswith(" …") for line in listed)


# -- the interview -----------------------------------------------------------------------------------------


def test_an_interview_in_a_pipe(typing, submit):
    submit(FLOOR)
    words = ("--interview", "--minutes", "10", "--cards", "3", "--kata", "middle", "--file", "mine.py")
    ended = typing(["?", "?", "?", "?"], "quiz", "halves", *words, "--seed", "3")
    assert ended.status == 0, ended
    assert ended.out.startswith("Mock interview  10 minutes\n2 cards, the kata middle, 0 cards. q leaves")
    assert "WA  mine.py  middle" in ended.out
    page = ended.out[ended.out.index("The interview") :]
    assert "cards    0 of 2 cards known" in page
    assert "kata     middle: WA, 40 of 100 points after 1 run, floor-division" in page
    with History.open(reading=True) as history:
        assert [run.problem for run in history.runs()] == ["middle"]
    assert len(answers()) == 2


def test_a_kata_is_judged_for_every_empty_line_until_it_is_solved(typing, submit):
    submit(MEAN, "middle_interview.py")
    ended = typing(
        ["what", "", "never read"], "quiz", "--interview", "--cards", "0", "--kata", "middle", "--json"
    )
    events = [json.loads(row) for row in ended.lines]
    assert [each["event"] for each in events] == ["kata", "run", "page"]
    assert events[0]["file"] == "middle_interview.py"
    assert events[2]["kata"]["solved"] is True
    assert events[2]["drill"] == []
    assert "an empty line has the file judged, q goes on" in ended.err


def test_the_file_of_an_interview_is_begun_and_never_written_over(typing, submit):
    ended = typing(["q"], "quiz", "--interview", "--cards", "0", "--kata", "middle")
    assert "Writing middle_interview.py" in ended.out
    assert "def middle(" in Path("middle_interview.py").read_text()
    assert "middle: not judged" in ended.out
    submit(MEAN, "middle_interview.py")
    typing(["q"], "quiz", "--interview", "--cards", "0", "--kata", "middle")
    assert Path("middle_interview.py").read_text() == MEAN


def test_an_interview_that_is_left_ends_with_its_page(typing):
    ended = typing(["q"], "quiz", "--interview", "--minutes", "10", "--kata", "middle")
    assert ended.status == 0
    assert "cards    none answered" in ended.out
    assert "middle: not judged" in ended.out


def test_when_the_time_is_over_no_card_is_asked_any_more(typing, monkeypatch):
    times = iter([0.0, 0.0, *[1e6] * 100])
    monkeypatch.setattr(interview.hold, "__defaults__", (lambda: next(times),))
    ended = typing(["?", "?", "?"], "quiz", "halves", "--interview", "--minutes", "10", "--kata", "middle")
    assert ended.status == 0
    assert len(answers()) == 1
    assert "10 of 10 minutes" in ended.out
