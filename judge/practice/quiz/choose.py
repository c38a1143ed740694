"""Which cards come next: those that are due, then new ones; and what to practise afterwards."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from datetime import datetime
from pathlib import Path
from types import MappingProxyType

from msgspec import Struct

from judge.practice.checklist import read_checklist
from judge.practice.quiz.cards import Card
from judge.practice.review import Review
from judge.problem.find import problem_folders


class Practise(Struct, frozen=True):
    """A question of the checklist to practise, and the commands that do."""

    question: str
    ask: str
    commands: tuple[str, ...]


def next_cards(
    cards: Sequence[Card], reviews: Sequence[Review], now: datetime, *, own: str = "", ahead: bool = False
) -> list[Card]:
    """The cards that are due, the longest overdue first, then new ones, those of the set `own` before others.

    With `ahead` all the others follow, the next due first.
    """
    answered = {review.name: review for review in reviews}
    known = sorted(
        (card for card in cards if card.key in answered),
        key=lambda card: (answered[card.key].due, card.key),
    )
    new = [card for card in cards if card.key not in answered]
    due = [card for card in known if answered[card.key].is_due(now)]
    later = [card for card in known if card not in due]
    return [*due, *sorted(new, key=lambda card: own not in card.sets), *(later if ahead else ())]


def next_due(cards: Iterable[Card], reviews: Iterable[Review]) -> datetime | None:
    """When the next of these cards is due; None where none was ever answered."""
    keys = {card.key for card in cards}
    return min((review.due for review in reviews if review.name in keys), default=None)


def rising(cards: Sequence[Card], count: int, sets: Sequence[str]) -> list[Card]:
    """At most `count` of the cards, about equally many of each set, the first sets first.

    Within a set they stay in their order; cards of none of these sets come last.
    """
    of_set: dict[str, list[Card]] = {name: [] for name in (*sets, "")}
    for card in cards:
        of_set[next((name for name in sets if name in card.sets), "")].append(card)
    ranked = sorted((at, place) for place, own in enumerate(of_set.values()) for at in range(len(own)))
    taken = sorted((place, at) for at, place in ranked[:count])
    every = list(of_set.values())
    return [every[place][at] for place, at in taken]


def to_practise(
    missed: Sequence[Card], folders: Sequence[Path], more: Mapping[str, str] = MappingProxyType({})
) -> tuple[Practise, ...]:
    """The questions of cards that were not known, and those in `more`, each with its command.

    A card that practises several questions stands for its first one. Raises ProblemError where the
    checklist is broken.
    """
    asked = {card.rows[0] for card in missed if card.rows}
    here = {folder.name for folder in problem_folders(folders)}
    return tuple(
        Practise(
            row.id,
            row.ask,
            (
                f"judge quiz --question {row.id}" if row.id in asked else more[row.id],
                *(f"judge start {kata}" for kata in row.katas if kata in here),
            ),
        )
        for row in read_checklist(folders).rows
        if row.id in asked or row.id in more
    )
