"""Spaced review: which katas to do again today, worked out from what was judged and when.

Runs of a problem that lie less than eight hours apart are one sitting, and a sitting is one review. It is
rated by what happened in it, not by what the person thinks of it:

    failed runs before the accepted one      none     1 to 3    4 and more
    the first sitting with the problem       easy     good      hard
    a later one                              good     hard      again

Hints make it one step worse; giving up, or no accepted run at all, is "again". A run that passed no test
group at all is no attempt: its file was not written yet. A run of a source that was accepted before counts
for nothing: judging the old file again shows no memory. FSRS, whose model of forgetting gives the intervals,
is run without fuzz: the same history gives the same dates, and nothing is stored.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from datetime import datetime, timedelta
from enum import IntEnum

from msgspec import Struct

from judge.kata.history import Help, Run

_SITTING = timedelta(hours=8)  # without a run: then the next one has to be remembered
_SOME, _MANY = 1, 4  # failed runs
_LONGEST = 365  # days until a kata comes again


class Rating(IntEnum):
    """How well a sitting went, in the numbers that FSRS has for it."""

    AGAIN = 1
    HARD = 2
    GOOD = 3
    EASY = 4


class Sitting(Struct, frozen=True):
    """One review: when it was over, how many runs failed, whether one was accepted, what help was taken."""

    when: datetime
    failed: int
    solved: bool
    hints: int = 0
    gave_up: bool = False

    def rating(self, *, first: bool) -> Rating:
        """How well it went; `first` where the problem was new."""
        if self.gave_up or not self.solved:
            return Rating.AGAIN
        best = Rating.EASY if first else Rating.GOOD
        worse = (self.failed >= _SOME) + (self.failed >= _MANY) + (self.hints > 0)
        return Rating(max(best - worse, Rating.AGAIN))


class Review(Struct, frozen=True):
    """How a problem stands with memory: its last sitting, when it is due, and after how many days.

    `recall` is how likely it is to be remembered now, between 0 and 1. `solved` is whether it ever was.
    """

    problem: str
    last: datetime
    rating: Rating
    sittings: int
    solved: bool
    due: datetime
    recall: float

    @property
    def interval(self) -> int:
        """The days from the last sitting to the next."""
        return (self.due - self.last).days

    def is_due(self, now: datetime) -> bool:
        """Whether it is due on the day of `now`, by the calendar of its time zone."""
        return self.due.astimezone(now.tzinfo).date() <= now.date()


def reviews(runs: Iterable[Run], helps: Iterable[Help], now: datetime) -> list[Review]:
    """Every problem that was ever tried, the one that is due first at the head."""
    of_problem: defaultdict[str, tuple[list[Run], list[Help]]] = defaultdict(lambda: ([], []))
    for run in runs:
        of_problem[run.problem][0].append(run)
    for help_ in helps:
        of_problem[help_.problem][1].append(help_)
    found = [
        review
        for problem, (own, taken) in of_problem.items()
        if (review := _review(problem, list(sittings(own, taken)), now))
    ]
    return sorted(found, key=lambda review: (review.due, review.problem))


def sittings(runs: Sequence[Run], helps: Sequence[Help]) -> Iterator[Sitting]:
    """The sittings with one problem; its runs and the help taken with it are in their order."""
    known: set[str] = set()
    events: list[Run | Help] = []
    for run in runs:
        if run.counts and run.passed and run.source_hash not in known:
            events.append(run)
        if run.whole:  # a model solution too, which may be copied
            known.add(run.source_hash)
    events = sorted([*helps, *events], key=_when)
    begun: list[Run | Help] = []
    for event in events:
        if begun and _when(event) - _when(begun[-1]) >= _SITTING:
            yield from _sitting(begun)
            begun = []
        begun.append(event)
    yield from _sitting(begun)


def _when(event: Run | Help) -> datetime:
    return event.when


def _sitting(events: Sequence[Run | Help]) -> Iterator[Sitting]:
    """The sitting of these events, up to its first accepted run; none where nothing was tried or given up."""
    failed = hints = 0
    gave_up = solved = False
    when: datetime | None = None
    for event in events:
        if isinstance(event, Help):
            hints += event.hints
            gave_up = gave_up or event.gave_up
            when = event.when if event.gave_up else when
            continue
        when = event.when
        if event.solved:
            solved = True
            break
        failed += bool(event.failed)  # not where it was judged on some groups only, and passed those
    if when is not None:
        yield Sitting(when, failed, solved, hints, gave_up)


def _review(problem: str, found: Sequence[Sitting], now: datetime) -> Review | None:
    if not found:
        return None
    import fsrs  # late: it costs 40 ms, and only who asks what is due waits for it

    scheduler = fsrs.Scheduler(
        learning_steps=(), relearning_steps=(), maximum_interval=_LONGEST, enable_fuzzing=False
    )
    card = fsrs.Card(card_id=1, due=found[0].when)
    rating = Rating.AGAIN
    for place, sitting in enumerate(found):
        rating = sitting.rating(first=place == 0)
        when = max(sitting.when, card.last_review or sitting.when)  # a clock may have been set back
        card, _ = scheduler.review_card(card, fsrs.Rating(rating), when)
    solved = any(sitting.solved for sitting in found)
    recall = scheduler.get_card_retrievability(card, now)
    return Review(problem, found[-1].when, rating, len(found), solved, card.due, recall)
