"""Spaced review: which katas and cards to do again today, worked out from what happened and when.

Runs of a problem that lie less than eight hours apart are one sitting, and a sitting is one review. It is
rated by what happened in it, not by what the person thinks of it:

    failed runs before the accepted one      none     1 to 3    4 and more
    the first sitting with the problem       easy     good      hard
    a later one                              good     hard      again

Hints make it one step worse; giving up, or no accepted run at all, is "again". A run that passed no test
group at all is no attempt: its file was not written yet. A run of a source that was accepted before counts
for nothing: judging the old file again shows no memory.

Answers to a card make sittings in the same way. The first answer of a sitting rates it: a card that is asked
again minutes later is still in mind.

FSRS, whose model of forgetting gives the intervals, is run without fuzz: the same history gives the same
dates, and nothing is stored.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from datetime import datetime, timedelta

from msgspec import Struct
from msgspec.structs import asdict

from judge.kata.answers import Answered
from judge.kata.answers import Rating as Rating
from judge.kata.history import Help, Run

_SITTING = timedelta(hours=8)  # without a run: then the next one has to be remembered
_SOME, _MANY = 1, 4  # failed runs
_LONGEST = 365  # days until a kata comes again


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


class Memory(Struct, frozen=True):
    """How something stands with memory: its last sitting, when it is due, and after how many days.

    `recall` is how likely it is to be remembered now, between 0 and 1.
    """

    last: datetime
    rating: Rating
    sittings: int
    due: datetime
    recall: float

    @property
    def interval(self) -> int:
        """The days from the last sitting to the next."""
        return (self.due - self.last).days

    def is_due(self, now: datetime) -> bool:
        """Whether it is due on the day of `now`, by the calendar of its time zone."""
        return self.due.astimezone(now.tzinfo).date() <= now.date()


class Review(Memory, frozen=True):
    """How a problem stands with memory, and whether it was ever solved."""

    problem: str
    solved: bool


class CardReview(Memory, frozen=True):
    """How a card stands with memory."""

    card: str


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


def card_reviews(answers: Iterable[Answered], now: datetime) -> list[CardReview]:
    """Every card that was ever answered, the one that is due first at the head; `answers` are in order."""
    of_card: defaultdict[str, list[tuple[datetime, Rating]]] = defaultdict(list)
    last: dict[str, datetime] = {}
    for answer in answers:
        before = last.get(answer.card)
        if before is None or answer.when - before >= _SITTING:
            of_card[answer.card].append((answer.when, answer.rating))
        last[answer.card] = answer.when
    found = [CardReview(card=card, **asdict(_memory(rated, now))) for card, rated in of_card.items()]
    return sorted(found, key=lambda review: (review.due, review.card))


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
    rated = [(sitting.when, sitting.rating(first=place == 0)) for place, sitting in enumerate(found)]
    solved = any(sitting.solved for sitting in found)
    return Review(problem=problem, solved=solved, **asdict(_memory(rated, now)))


def _memory(rated: Sequence[tuple[datetime, Rating]], now: datetime) -> Memory:
    """What memory makes of sittings, at least one, each given by its time and its rating."""
    import fsrs  # late: it costs 40 ms, and only who asks what is due waits for it

    scheduler = fsrs.Scheduler(
        learning_steps=(), relearning_steps=(), maximum_interval=_LONGEST, enable_fuzzing=False
    )
    card = fsrs.Card(card_id=1, due=rated[0][0])
    for when, rating in rated:
        when = max(when, card.last_review or when)  # a clock may have been set back
        card, _ = scheduler.review_card(card, fsrs.Rating(rating), when)
    recall = scheduler.get_card_retrievability(card, now)
    last, rating = rated[-1]
    return Memory(last, rating, len(rated), card.due, recall)
