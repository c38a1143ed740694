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


class WatchedFile:
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
def watched():
    clock = StoppedClock()
    with History.open(clock=clock) as history:
        yield WatchedFile(history, clock)


def test_a_sitting_ends_with_the_first_accepted_run(watched):
    watched.judge(WRONG, WRONG, RIGHT, WRONG, RIGHT)
    assert watched.sittings() == [Sitting(START + timedelta(minutes=10), 2, True)]


def test_runs_hours_apart_are_sittings_of_their_own(watched):
    watched.judge(WRONG)
    watched.pause(hours=7)
    watched.judge(WRONG)
    watched.pause(hours=9)
    watched.judge(RIGHT)
    assert [(each.failed, each.solved) for each in watched.sittings()] == [(2, False), (0, True)]


def test_judging_the_accepted_file_again_is_no_review(watched):
    watched.judge(RIGHT, source=b"the answer")
    watched.pause(days=3)
    watched.judge(RIGHT, RIGHT, source=b"the answer")
    assert len(watched.sittings()) == 1
    watched.judge(RIGHT, source=b"written anew")
    assert len(watched.sittings()) == 2


def test_a_stub_is_no_attempt(watched):
    watched.judge(NOTHING, NOTHING)
    assert watched.sittings() == []
    assert watched.reviews() == []
    watched.judge(PART, RIGHT)
    assert [(each.failed, each.solved) for each in watched.sittings()] == [(0, True)]


def test_help_belongs_to_its_sitting_and_is_none_by_itself(watched):
    watched.history.see_hints("segment", 2)
    assert watched.sittings() == []
    watched.judge(RIGHT)
    watched.pause(days=2)
    watched.judge(RIGHT)
    watched.pause(days=2)
    watched.history.give_up("segment")
    watched.judge(RIGHT)
    assert [(each.hints > 0, each.gave_up) for each in watched.sittings()] == [
        (True, False),
        (False, False),
        (False, True),
    ]


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


def test_the_better_it_went_the_later_it_comes_again(watched):
    for problem, failed in (("count", 0), ("segment", 2), ("ray-nearest", 5)):
        watched.judge(*[past_result(problem, failed=("x",))] * failed, past_result(problem))
    watched.judge(past_result("exact-count", failed=("x",)))
    found = {review.problem: review for review in watched.reviews()}
    assert [problem for problem, review in found.items() if not review.solved] == ["exact-count"]
    assert found["exact-count"].interval == found["ray-nearest"].interval == 1
    assert 1 < found["segment"].interval < found["count"].interval
    assert list(found)[2:] == ["segment", "count"]


def test_intervals_grow_with_success_and_collapse_with_failure(watched):
    intervals = []
    for _ in range(4):
        watched.judge(RIGHT)
        (review,) = watched.reviews()
        intervals.append(review.interval)
        assert review.recall > 0.99
        watched.pause(days=review.interval)
        assert 0.85 < watched.reviews()[0].recall < 0.95
    assert intervals == sorted(set(intervals))
    assert intervals[-1] <= 365
    watched.judge(WRONG)
    assert watched.reviews()[0].interval < intervals[0]


def test_it_is_due_by_the_calendar_of_the_persons_own_zone(watched):
    watched.judge(WRONG)  # at 9:00 UTC: due the next day at 9:00
    (review,) = watched.reviews()
    assert not review.is_due(datetime(2026, 3, 1, 23, 59, tzinfo=UTC))
    assert review.is_due(datetime(2026, 3, 2, 0, 1, tzinfo=UTC))
    east = timezone(timedelta(hours=12))
    assert not review.is_due(datetime(2026, 3, 1, 23, 59, tzinfo=east))
    assert review.is_due(datetime(2026, 3, 2, 0, 1, tzinfo=east))


def test_a_clock_that_was_set_back(watched):
    watched.judge(RIGHT)
    watched.pause(days=-30)
    watched.judge(RIGHT)
    (review,) = watched.reviews()
    assert review.sittings == 2
