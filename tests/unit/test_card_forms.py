"""Each form of cards: what is asked, what is read, and that the right answer is right."""

from __future__ import annotations

import io
import os
import re
from fractions import Fraction
from itertools import pairwise
from math import sqrt

import pytest

from judge.errors import ProblemError
from judge.practice.cards import (
    AnyForm,
    Card,
    Count,
    Drawn,
    MistypedError,
    WrongOption,
    cards_of,
    count,
    number,
    option,
    read_decks,
    sequence,
)
from judge.practice.events import Rating
from judge.practice.questions import ask
from judge.report import exercises as texts
from judge.report.screen import Screen, drawn

NUMBERS = re.compile(r"-?\d+")

FORMS = {each.__struct_config__.tag: each for each in AnyForm.__args__}


@pytest.fixture(autouse=True, scope="module")
def _own_pack_and_cache(built):
    with pytest.MonkeyPatch.context() as patched:
        patched.delenv("JUDGE_PROBLEMS", raising=False)
        patched.setenv("JUDGE_CACHE", str(built))
        yield


def card(form, **keys):
    return Card("deck", FORMS[form](id="card", front="What?", back="So.", **keys))


def questions(wanted, many):
    return [ask(wanted, (), 5, str(turn)) for turn in range(many)]


def test_a_number_a_count_and_an_option_are_read():
    assert [number(text) for text in (" −1/2 ", "1e-9", "+2.")] == [Fraction(-1, 2), Fraction(1, 10**9), 2]
    for text in ("", "1/0", "0x10", "1e9999", "9" * 50, "nan", "1_0", "²", "1 2x"):
        with pytest.raises(MistypedError, match=r"^[^\n]{,119}$"):
            number(text)
    assert [count(text) for text in ("2", " 02 ", "None")] == ["2", "2", "none"]
    assert [option(text, "abc") for text in ("b", "B", "(b)", "b.")] == ["b"] * 4
    for text in ("-1", "2.0", "two", "٢", ""):
        with pytest.raises(MistypedError):
            count(text)
    with pytest.raises(MistypedError, match="Type a, b or c"):
        option("d", "abc")


def test_a_sequence_is_read_by_words_or_by_what_they_mean():
    tags = {"i": "in", "o": "out", "t": "touch"}
    for text in ("i t o", "iTo", "in, touch, out", "i;t;o", "in → touch → out"):
        assert sequence(text, tags) == "i t o"
    assert sequence("none", tags) == "none"
    assert sequence("b A", {"A": "", "B": ""}) == "B A"
    for text in ("x", "i x", "ioxo"):
        with pytest.raises(MistypedError, match=r"i, o and t\. Type them in their order, or none"):
            sequence(text, tags)


def test_a_choice_tells_which_mistake_a_wrong_option_is():
    wrong = (WrongOption("w1", "first-mistake", "Because."), WrongOption("w2", "second-mistake", "Why."))
    asked = questions(card("choice", right="r", wrong=wrong), 20)
    for question in asked:
        by_text = {text: letter for letter, text in question.options}
        assert sorted(by_text) == ["r", "w1", "w2"]
        assert question.check(by_text["r"]).right
        reply = question.check(by_text["w2"].upper())
        assert (reply.right, reply.mistake, reply.why) == (False, "second-mistake", "Why.")
        assert question.answer == f"{by_text['r']}  r"
    assert len({question.options for question in asked}) > 2  # in another order each time


def test_a_number_may_be_off_by_a_part_and_have_its_unit_and_recall_is_not_checked():
    (exact,) = questions(card("number", answer="24", unit="MB"), 1)
    assert exact.check("24").right
    assert exact.check("24 MB").right
    assert exact.check("48/2").right
    assert not exact.check("24.0001").right
    (near,) = questions(card("number", answer="0.005", within=0.01), 1)
    assert near.check("0.00505").right
    assert not near.check("0.0051").right
    (recalled,) = questions(card("recall"), 1)  # which the person rates
    assert (recalled.check, recalled.answer) == (None, "So.")


def line_count(text):
    """How often a circle and a line meet, by another formula than the references', in whole numbers."""
    cx, cy, r, ax, ay, bx, by = map(int, NUMBERS.findall(re.sub(r"c[xy]=|[rAB]=", "", text)))
    a, b = (bx - ax) ** 2 + (by - ay) ** 2, (bx - ax) * (ax - cx) + (by - ay) * (ay - cy)
    if not a:
        return "none"
    delta = b * b - a * ((ax - cx) ** 2 + (ay - cy) ** 2 - r * r)
    return str(1 + (delta > 0) - (delta < 0))


@pytest.mark.slow
def test_the_count_of_a_figure_is_right():
    asked = questions(card("count", problem="crossings", groups=(), largest=30), 20)
    for question in asked:
        right = line_count(question.given[0])
        assert question.answer == right
        for typed in ("0", "1", "2", "none"):
            assert question.check(typed).right == (typed == right)
    assert len({question.given for question in asked}) > 15
    assert {question.answer for question in asked} >= {"0", "1", "2"}


def figure(question):
    """The circles by letter, and the two points or the point and the direction of the last line."""
    *circles, last = question.given
    rings = {}
    for text in circles:
        x, y, r = map(int, NUMBERS.findall(text))
        rings[text.split()[1].rstrip(":")] = (x, y, r)
    return rings, tuple(map(int, NUMBERS.findall(last)))


def roots(ring, ox, oy, dx, dy):
    """Both parameters, by the quadratic formula in doubles: in these figures that tells them apart."""
    x, y, r = ring
    a, b, c = dx * dx + dy * dy, dx * (ox - x) + dy * (oy - y), (ox - x) ** 2 + (oy - y) ** 2 - r * r
    delta = b * b - a * c
    return [] if delta < 0 else sorted({(-b - sqrt(delta)) / a, (-b + sqrt(delta)) / a})


def order_of(question):
    rings, (ox, oy, dx, dy) = figure(question)
    ahead = {label: [t for t in roots(ring, ox, oy, dx, dy) if t >= 0] for label, ring in rings.items()}
    first = {label: ts[0] for label, ts in ahead.items() if ts}
    assert all(after - before > 0.01 for before, after in pairwise(sorted(first.values())))
    return sorted(first, key=first.get)


def test_what_a_ray_meets_and_what_first_is_right():
    orders, answers = set(), set()
    for question in questions(card("order", problem="ray-nearest"), 20):
        wanted = order_of(question)
        assert question.answer.split() == wanted
        assert question.check(" ".join(wanted).lower()).right
        assert not question.check(" ".join(reversed(wanted))).right
        assert len(wanted) >= 2
        orders.add(tuple(wanted))
    assert len(orders) > 5
    for question in questions(card("first-hit", problem="ray-nearest"), 20):
        assert question.answer == order_of(question)[0]
        answers.add(question.answer)
        with pytest.raises(MistypedError):
            question.check("E")
    assert answers == {"A", "B", "C", "D"}


@pytest.mark.parametrize(
    ("wanted", "said"),
    [
        (card("count", problem="count", groups=("gird",)), "count has no group 'gird' to draw from"),
        (card("count", problem="distance"), "the answer of distance counts nothing"),
        (card("tags", problem="count"), "count has no figure for 'tags'"),
    ],
)
def test_what_a_problem_has_not_is_one_line(wanted, said):
    with pytest.raises(ProblemError) as fault:
        ask(wanted, (), 5, "0")
    assert said in str(fault.value)
    assert str(fault.value).startswith("quiz/deck.toml: ")


@pytest.mark.nightly
def test_every_shipped_card_can_be_asked():
    cards = cards_of("path")
    assert len(cards) > 100
    for each in cards:
        question = ask(each, (), 5, "0")
        assert question.expects
        assert question.answer
        assert each.form in FORMS


FIGURES = [each for each in read_decks()[0] if isinstance(each.content, Count | Drawn)]


class Person(io.StringIO):
    encoding = "utf-8"

    def isatty(self):
        return True


@pytest.mark.parametrize("asks", FIGURES, ids=lambda each: each.key)
def test_a_question_with_a_figure_fits_a_screen_of_24_rows_and_so_does_its_reply(asks, monkeypatch):
    monkeypatch.setattr("judge.report.screen._size", lambda _stream: os.terminal_size((80, 24)))
    screen = Screen(Person(), False, 80)
    for asked in questions(asks, 8):
        told = drawn(texts.question(asked, "Question 1 of 10", screen), screen)
        told += f"{texts.prompt(f'Answer ({asked.expects}): ', screen)}?\n"
        told += drawn(texts.reply(asked, None, Rating.AGAIN, screen), screen)
        assert told.count("\n") < 24
        assert all(len(row) <= 80 for row in told.split("\n"))
