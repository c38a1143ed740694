"""What `judge quiz` and `judge interview` come to: frozen structs, whose field names are the JSON's keys."""

from __future__ import annotations

from datetime import datetime
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.practice.cards import Card
from judge.practice.events import Rating
from judge.practice.quiz import Practise
from judge.practice.review import Review
from judge.problem import Verdict
from judge.report.views import Published, copied

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from judge.practice.questions import Question
    from judge.practice.quiz import Held


class CardRow(Published, frozen=True):
    """A card without its answer; `last`, `rating` and `due` are null until it is answered."""

    card: str
    form: str
    rows: tuple[str, ...]
    sets: tuple[str, ...]
    front: str
    last: datetime | None
    rating: str | None
    due: datetime | None


class CardList(Struct, frozen=True):
    """The cards of a set, with what is known of each on the day of `now`."""

    cards: tuple[Card, ...]
    reviews: Mapping[str, Review]
    now: datetime

    @property
    def published(self) -> tuple[CardRow, ...]:
        """A row for each card."""
        return tuple(self._row(card, self.reviews.get(card.key)) for card in self.cards)

    def _row(self, card: Card, review: Review | None) -> CardRow:
        rated = (review.last, review.rating.name.lower(), review.due) if review else (None, None, None)
        return CardRow(card.key, card.form, card.rows, card.sets, card.front, *rated)


class Answered(Struct, frozen=True):
    """A card that was answered, and how it went: again, hard, good or easy."""

    card: str
    rating: str


class Quizzed(Published, frozen=True):
    """How the cards went, and what to practise; `next_due` is told where none was asked."""

    asked: int
    known: int
    answers: tuple[Answered, ...]
    practise: tuple[Practise, ...]
    seed: int
    next_due: datetime | None = None


class Interviewed(Published, frozen=True):
    """How the interview went: the minutes it took, its cards, its kata, and what to practise.

    `verdict` and `score` are null where the file was not judged; `lacking` are skills that it did not show.
    """

    minutes: int
    out_of: int
    asked: int
    known: int
    problem: str
    file: str
    runs: int
    solved: bool
    verdict: Verdict | None
    score: int | None
    mistake: str | None
    lacking: tuple[str, ...]
    practise: tuple[Practise, ...]
    seed: int


def quizzed(
    asked: Sequence[tuple[Question, Rating]],
    practise: tuple[Practise, ...],
    seed: int,
    next_due: datetime | None = None,
) -> Quizzed:
    """What these answers come to."""
    answers = tuple(Answered(question.card.key, rating.name.lower()) for question, rating in asked)
    return Quizzed(len(asked), _known(asked), answers, practise, seed, next_due)


def interviewed(
    held: Held,
    asked: Sequence[tuple[Question, Rating]],
    practise: tuple[Practise, ...],
    minutes: tuple[int, int],
    seed: int,
) -> Interviewed:
    """What an interview comes to that took the first of the `minutes`, of the second."""
    last = held.last
    return copied(
        Interviewed,
        held,
        minutes=minutes[0],
        out_of=minutes[1],
        asked=len(asked),
        known=_known(asked),
        problem=held.problem.id,
        verdict=last.verdict if last else None,
        score=last.score if last else None,
        mistake=last.pitfall.name if last and last.pitfall else None,
        lacking=() if held.solved else held.lacking,
        practise=practise,
        seed=seed,
    )


def _known(asked: Sequence[tuple[Question, Rating]]) -> int:
    return sum(rating is not Rating.AGAIN for _, rating in asked)
