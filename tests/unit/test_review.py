"""Spaced review: what counts as a review, how it is rated, and that dates follow from the history alone."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta, timezone
from itertools import count

import pytest
from past_runs import START, StoppedClock, past_result

from judge.kata.history import History
from judge.kata.review import Rating, Sitting, reviews, sittings

WRONG = past_result(passed=("grid",), failed=("tangent",))
RIGHT = past_result()
NOTHING = past_result(passed=(), failed=("grid", "tangent"))  # a stub
PART = past_result(passed=("grid",))  # with --group


class Desk:
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

    def sittings(self):
        return list(sittings(self.history.runs("segment"), self.history.helps("segment")))

    def reviews(self, **later):
        return reviews(self.history.runs(), self.history.helps(), self.clock() + timedelta(**later))


@pytest.fixture
def desk():
    clock = StoppedClock()
    with History.open(clock=clock) as history:
        yield Desk(history, clock)


def test_a_sitting_ends_with_the_first_accepted_run(desk):
    desk.judge(WRONG, WRONG, RIGHT, WRONG, RIGHT)
    assert desk.sittings() == [Sitting(START + timedelta(minutes=10), 2, True)]


def test_runs_hours_apart_are_sittings_of_their_own(desk):
    desk.judge(WRONG)
    desk.pause(hours=7)
    desk.judge(WRONG)
    desk.pause(hours=9)
    desk.judge(RIGHT)
    assert [(each.failed, each.solved) for each in desk.sittings()] == [(2, False), (0, True)]


def test_judging_the_accepted_file_again_is_no_review(desk):
    desk.judge(RIGHT, source=b"the answer")
    desk.pause(days=3)
    desk.judge(RIGHT, RIGHT, source=b"the answer")
    assert len(desk.sittings()) == 1
    desk.judge(RIGHT, source=b"written anew")
    assert len(desk.sittings()) == 2


def test_what_is_no_attempt(desk):
    desk.judge(NOTHING, NOTHING)
    assert desk.sittings() == []
    assert desk.reviews() == []
    desk.judge(PART, RIGHT)
    assert [(each.failed, each.solved) for each in desk.sittings()] == [(0, True)]


def test_help_belongs_to_its_sitting(desk):
    desk.history.see_hints("segment", 2)
    desk.judge(RIGHT)
    desk.pause(days=2)
    desk.judge(RIGHT)
    desk.pause(days=2)
    desk.history.give_up("segment")
    desk.judge(RIGHT)
    assert [(each.hints > 0, each.gave_up) for each in desk.sittings()] == [
        (True, False),
        (False, False),
        (False, True),
    ]


def test_looking_at_a_hint_alone_is_no_review(desk):
    desk.history.see_hints("segment", 1)
    assert desk.sittings() == []


@pytest.mark.parametrize(
    ("sitting", "first", "later"),
    [
        (Sitting(START, 0, True), Rating.EASY, Rating.GOOD),
        (Sitting(START, 1, True), Rating.GOOD, Rating.HARD),
        (Sitting(START, 3, True), Rating.GOOD, Rating.HARD),
        (Sitting(START, 4, True), Rating.HARD, Rating.AGAIN),
        (Sitting(START, 0, True, hints=1), Rating.GOOD, Rating.HARD),
        (Sitting(START, 9, True, hints=3), Rating.AGAIN, Rating.AGAIN),
        (Sitting(START, 0, True, gave_up=True), Rating.AGAIN, Rating.AGAIN),
        (Sitting(START, 0, False), Rating.AGAIN, Rating.AGAIN),
    ],
)
def test_the_rating(sitting, first, later):
    assert sitting.rating(first=True) is first
    assert sitting.rating(first=False) is later


def test_the_better_it_went_the_later_it_comes_again(desk):
    for problem, failed in (("count", 0), ("segment", 2), ("ray-nearest", 5)):
        desk.judge(*[past_result(problem, failed=("x",))] * failed, past_result(problem))
    desk.judge(past_result("exact-count", failed=("x",)))
    found = {review.problem: review for review in desk.reviews()}
    assert [problem for problem, review in found.items() if not review.solved] == ["exact-count"]
    assert found["exact-count"].interval == found["ray-nearest"].interval == 1
    assert 1 < found["segment"].interval < found["count"].interval
    assert list(found)[2:] == ["segment", "count"]


def test_intervals_grow_with_success_and_collapse_with_failure(desk):
    intervals = []
    for _ in range(4):
        desk.judge(RIGHT)
        (review,) = desk.reviews()
        intervals.append(review.interval)
        assert review.recall > 0.99
        desk.pause(days=review.interval)
        assert 0.85 < desk.reviews()[0].recall < 0.95
    assert intervals == sorted(set(intervals))
    assert intervals[-1] <= 365
    desk.judge(WRONG)
    assert desk.reviews()[0].interval < intervals[0]


def test_the_same_history_gives_the_same_dates(desk):
    for _ in range(5):
        desk.judge(WRONG, RIGHT)
        desk.pause(days=9)
    assert desk.reviews() == desk.reviews()


def test_it_is_due_by_the_calendar_of_the_persons_own_zone(desk):
    desk.judge(WRONG)  # at 9:00 UTC: due the next day at 9:00
    (review,) = desk.reviews()
    assert not review.is_due(datetime(2026, 3, 1, 23, 59, tzinfo=UTC))
    assert review.is_due(datetime(2026, 3, 2, 0, 1, tzinfo=UTC))
    east = timezone(timedelta(hours=12))
    assert not review.is_due(datetime(2026, 3, 1, 23, 59, tzinfo=east))
    assert review.is_due(datetime(2026, 3, 2, 0, 1, tzinfo=east))


def test_a_clock_that_was_set_back(desk):
    desk.judge(RIGHT)
    desk.pause(days=-30)
    desk.judge(RIGHT)
    (review,) = desk.reviews()
    assert review.sittings == 2
