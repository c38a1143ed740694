"""Spaced review: what counts as a sitting, and the ladder of days that follows from the history alone."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta, timezone
from itertools import count

import pytest
from past_runs import StoppedClock, past_result

from judge.kata.answers import Rating
from judge.kata.history import History
from judge.kata.review import LADDER, card_reviews, reviews

WRONG = past_result(passed=("grid",), failed=("tangent",))
RIGHT = past_result()


class Person:
    """A person at work: results follow each other by minutes, each of a new source unless one is given."""

    def __init__(self, history, clock):
        self.history, self.clock = history, clock
        self._sources = count()

    def judge(self, *results, source=None):
        for result in results:
            self.history.add(result, source or b"%d" % next(self._sources), "")
            self.clock.forward(minutes=5)

    def pause(self, **amount):
        self.clock.forward(**amount)

    def stands(self):
        found = reviews(self.history.runs(), self.history.helps())
        return [(each.rating, each.sittings, each.days) for each in found]


@pytest.fixture
def person():
    clock = StoppedClock()
    with History.open(clock=clock) as history:
        yield Person(history, clock)


def test_the_ladder(person):
    days = []
    for _ in range(len(LADDER)):
        person.judge(RIGHT)
        (review,) = reviews(person.history.runs(), [])
        assert review.due == review.last + timedelta(days=review.days)
        days.append(review.days)
        person.pause(days=review.days)
    assert days == [3, 8, 21, 60, 180, 180]
    assert review.in_a_row == len(LADDER)
    person.judge(WRONG, RIGHT)
    assert person.stands() == [(Rating.HARD, 7, 60)]
    person.pause(days=60)
    person.judge(WRONG)
    assert person.stands() == [(Rating.AGAIN, 8, 1)]


def test_hints_and_giving_up(person):
    person.history.see_hints("segment", 2)
    assert person.stands() == []
    person.judge(RIGHT)
    assert person.stands() == [(Rating.HARD, 1, 1)]
    person.pause(days=1)
    person.history.give_up("segment")
    person.judge(RIGHT)
    assert person.stands() == [(Rating.AGAIN, 2, 1)]


def test_cards_climb_the_same_ladder(person):
    def answer(card, rating):
        person.history.answer(card, "choice", rating, judged=True)
        person.pause(minutes=1)

    answer("deck/a", Rating.AGAIN)
    answer("deck/a", Rating.GOOD)  # minutes later it is still in mind
    for _ in range(3):
        answer("deck/b", Rating.EASY)
        person.pause(days=8)
    answer("deck/b", Rating.HARD)
    found = [(each.name, each.rating, each.days) for each in card_reviews(person.history.answers())]
    assert found == [("deck/a", Rating.AGAIN, 1), ("deck/b", Rating.HARD, 8)]


def test_it_is_due_by_the_calendar_of_the_persons_own_zone(person):
    person.judge(WRONG)  # at 9:00 UTC: due the next day at 9:00
    (review,) = reviews(person.history.runs(), [])
    for zone in (UTC, timezone(timedelta(hours=12))):
        assert not review.is_due(datetime(2026, 3, 1, 23, 59, tzinfo=zone))
        assert review.is_due(datetime(2026, 3, 2, 0, 1, tzinfo=zone))
