"""Spaced review: which katas and cards to do again today, and why then.

Runs of a kata that lie less than eight hours apart are one sitting; so are answers to a card. After each
sitting the kata or card comes again in a number of days from a ladder: solved at once goes up a step; solved
with failed runs or hints ("hard") goes down a step; not solved, or given up, goes back to one day. The first
answer of a sitting counts: a card that is asked again minutes later is still in mind.

A run that ended with an error and passed no test group is no attempt: the file was not written yet. A run of
a source that was accepted before counts for nothing: judging the old file again shows no memory. Nothing of
this is stored.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from datetime import datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from judge.errors import ProblemError
from judge.practice.events import Answer, Event, Help, Rating, Run, grouped
from judge.practice.progress import Tried, levels_passed, solved, tried
from judge.practice.syllabus import USUAL, PracticeSet, first_sets, sound_sets
from judge.problem import Problem, Verdict
from judge.problem.find import problem_folders, sound_problems
from judge.published import Published

if TYPE_CHECKING:
    from judge.practice.history import History

LADDER = (1, 3, 8, 21, 60, 180)  # days until it comes again
_SITTING = timedelta(hours=8)  # without an event: then the next one has to be remembered
_Rated = tuple[datetime, Rating]


class Review(Struct, frozen=True):
    """How a kata or a card stands: its last sitting, and after how many `days` it comes again.

    `name` is the problem's id or the card's key. `rating` is 1 where the last sitting did not solve it, 2
    where that took several runs or help, else 3 or 4. `in_a_row` counts the last sittings that went well, and
    `solved` says whether it ever was.
    """

    name: str
    due: datetime
    last: datetime
    rating: Rating
    sittings: int
    in_a_row: int
    days: int
    solved: bool

    def is_due(self, now: datetime) -> bool:
        """Whether it is due on the day of `now`, by the calendar of its time zone."""
        return self.due.astimezone(now.tzinfo).date() <= now.date()


def reviews(runs: Iterable[Run], helps: Iterable[Help]) -> list[Review]:
    """Every problem that was ever tried, the one that is due first at the head; runs are in their order."""
    events: list[Run | Help] = [*helps]
    known: set[tuple[str, str]] = set()
    for run in runs:
        attempt = run.passed or run.verdict not in (Verdict.CE, Verdict.RTE)
        if run.counts and attempt and (run.problem, run.source_hash) not in known:
            events.append(run)
        if run.whole:  # a model solution too, which may be copied
            known.add((run.problem, run.source_hash))
    return _reviews(grouped(events, lambda event: event.problem), _rated)


def card_reviews(answers: Iterable[Answer]) -> list[Review]:
    """Every card that was ever answered, the one that is due first at the head."""
    of_card = grouped(answers, lambda answer: answer.card)
    return _reviews(of_card, lambda sitting: (sitting[0].when, sitting[0].rating))


def _rated(events: Sequence[Run | Help]) -> _Rated | None:
    """How a sitting with a kata went, up to its first accepted run; None if nothing was tried or given up."""
    helped = gave_up = False
    when: datetime | None = None
    for event in events:
        if isinstance(event, Help):
            helped, gave_up = True, gave_up or event.gave_up
            when = event.when if event.gave_up else when
            continue
        when = event.when
        if event.solved:
            return when, Rating.AGAIN if gave_up else Rating.HARD if helped else Rating.GOOD
        helped = helped or bool(event.failed)  # not if some groups only were judged, and passed
    return (when, Rating.AGAIN) if when else None


def _reviews(named: Mapping[str, list[Any]], rate: Callable[[list[Any]], _Rated | None]) -> list[Review]:
    found = []
    for name, events in named.items():
        sittings: list[list[Event]] = []
        for event in sorted(events, key=lambda event: event.when):
            if not sittings or event.when - sittings[-1][-1].when >= _SITTING:
                sittings.append([])
            sittings[-1].append(event)
        rated = [each for each in map(rate, sittings) if each]
        step = in_a_row = 0
        for _, rating in rated:
            well = rating >= Rating.GOOD
            in_a_row = in_a_row + 1 if well else 0
            step = 0 if rating is Rating.AGAIN else min(max(step + (1 if well else -1), 0), len(LADDER) - 1)
        if rated:
            last, rating = rated[-1]
            solved = any(each is not Rating.AGAIN for _, each in rated)
            due = last + timedelta(days=LADDER[step])
            found.append(Review(name, due, last, rating, len(rated), in_a_row, LADDER[step], solved))
    return sorted(found, key=lambda review: (review.due, review.name))


# -- all of it together -------------------------------------------------------------------------------------


class Unfinished(Struct, frozen=True):
    """A kata that was tried and is not solved: its most points, and its last run."""

    problem: str
    best: int
    last: datetime


class Due(Published, frozen=True):
    """What is unfinished `now`, what to do again, and the cards that were answered, the first due first."""

    time: datetime
    now: list[Unfinished]
    due: list[Review]
    later: list[Review]
    cards: list[Review]

    @property
    def cards_due(self) -> int:
        """How many cards are due."""
        return sum(card.is_due(self.time) for card in self.cards)


class Learner(Struct, frozen=True):
    """What a person did: all runs, those that say something of them by problem, help, and answers to cards.

    `problems` and `sets` are all katas; `solved` says since when one is. `extra` are the folders that were
    looked in first, and `faults` are the problems and sets that cannot be read.
    """

    problems: Sequence[Problem]
    sets: Sequence[PracticeSet[Problem]]
    solved: Mapping[str, datetime]
    runs: Sequence[Run]
    own: Tried
    helps: Sequence[Help]
    answers: Sequence[Answer]
    extra: Sequence[Path]
    faults: Sequence[ProblemError]

    def set_of(self, problem: str) -> PracticeSet[Problem] | None:
        """The first set that a kata belongs to; None where it is in none but the whole path."""
        name = first_sets(self.sets).get(problem)
        return next((each for each in self.sets if each.name == name), None)

    def counted(self, part: PracticeSet[Problem]) -> list[Problem]:
        """The katas that count in that set: those whose first one it is, and all of the whole path."""
        firsts = first_sets(self.sets)
        return [each for each in part.problems if part.name in (USUAL, firsts[each.id])]

    def from_own(self, name: str = "") -> list[PracticeSet[Problem]]:
        """The sets from the person's own on, then those before; `name` may name another one.

        A person's set is the highest in which a kata is solved, or the first.
        """
        sets = [each for each in self.sets if each.name != USUAL and each.problems]
        firsts = first_sets(sets)
        won = {firsts[each] for each in self.solved if each in firsts}
        own = max((at for at, each in enumerate(sets) if each.name in won), default=0)
        at = next((at for at, each in enumerate(sets) if each.name == name), own)
        return sets[at:] + sets[:at]

    def next(self, after: str) -> Problem | None:
        """The kata that comes after that one and is not solved; None where all others are.

        First in its own set, from there on and then from the start, so that one that was left out comes back;
        then on the whole path.
        """
        own = self.set_of(after)
        path = next((each.problems for each in self.sets if each.name == USUAL), self.problems)
        for row in (own.problems if own else (), path):
            names = [each.id for each in row]
            at = names.index(after) + 1 if after in names else 0
            for each in (*row[at:], *row[:at]):
                if each.id not in self.solved and each.id != after:
                    return each
        return None

    def stars(self, problems: Iterable[Problem]) -> tuple[int, int]:
        """How many of these katas have one star, and how many two."""
        won = [len(levels_passed(each, self.own.get(each.id, ()))) for each in problems]
        return won.count(1), won.count(2)

    def due(self, time: datetime, cards: Sequence[Review] = ()) -> Due:
        """What is to be done at that time, of the known cards too; an unfinished kata is not repeated yet."""
        here = {folder.name for folder in problem_folders(self.extra)}
        own = ((name, runs) for name, runs in self.own.items() if name in here)
        unsolved = {name: runs for name, runs in own if not any(run.solved for run in runs)}
        known = [each for each in reviews(self.runs, self.helps) if each.name in here - unsolved.keys()]
        due = [each for each in known if each.is_due(time)]
        later = [each for each in known if each not in due]
        now = [
            Unfinished(name, max(run.score for run in runs), runs[-1].when) for name, runs in unsolved.items()
        ]
        return Due(time, now, due, later, list(cards))


def read_learner(history: History, extra: Sequence[Path] = ()) -> Learner:
    """What a history says of a person, with all katas and sets that can be read. Raises StoreError."""
    problems, faults = sound_problems(extra)
    sets, broken = sound_sets(problems, extra)
    runs = history.runs()
    done = solved(runs)
    here = {each.id: done[each.id] for each in problems if each.id in done}
    helps, answers = history.events(Help), history.events(Answer)
    return Learner(problems, sets, here, runs, tried(runs), helps, answers, extra, [*faults, *broken])
