"""Which cards come next: those that are due, then new ones, then, where they are asked for, the others."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from datetime import datetime

from judge.kata.quiz.cards import Card
from judge.kata.review import Review

REPEATED = ("count", "first-hit", "order", "tags", "spot")  # forms with something new each time


def due_cards(cards: Iterable[Card], reviews: Iterable[Review], now: datetime) -> list[Card]:
    """The cards that are due, the longest overdue first."""
    named = {card.key: card for card in cards}
    found = [review for review in reviews if review.name in named and review.is_due(now)]
    return [named[review.name] for review in sorted(found, key=lambda review: (review.due, review.name))]


def new_cards(cards: Iterable[Card], reviews: Iterable[Review]) -> list[Card]:
    """The cards that were never answered, in their order."""
    known = {review.name for review in reviews}
    return [card for card in cards if card.key not in known]


def next_cards(
    cards: Sequence[Card], reviews: Sequence[Review], now: datetime, count: int, *, ahead: bool = False
) -> list[Card]:
    """So many cards at most: what is due, then new ones; `ahead` takes the others too, the next due first.

    And then `ahead` fills up with cards that have something new each time, in turn.
    """
    found = [*due_cards(cards, reviews, now), *new_cards(cards, reviews)]
    if ahead:
        dates: Mapping[str, datetime] = {review.name: review.due for review in reviews}
        later = [card for card in cards if card not in found]
        found += sorted(later, key=lambda card: dates[card.key])
        again = [card for card in found if card.form in REPEATED]
        while again and len(found) < count:
            found += again
    return found[:count]


def next_due(cards: Iterable[Card], reviews: Iterable[Review]) -> datetime | None:
    """When the next of these cards is due."""
    keys = {card.key for card in cards}
    return min((review.due for review in reviews if review.name in keys), default=None)


def rising(cards: Sequence[Card], count: int, tiers: Sequence[str]) -> list[Card]:
    """So many of the cards, about equally many of each tier, the easier tiers first.

    Within a tier they are taken in the order in which they come; a card of no tier comes last.
    """
    of_tier: dict[str, list[Card]] = {tier: [] for tier in (*tiers, "")}
    for card in cards:
        of_tier[next((tier for tier in tiers if tier in card.sets), "")].append(card)
    taken: list[Card] = []
    depth = 0
    while len(taken) < min(count, len(cards)):
        level = [own[depth] for own in of_tier.values() if depth < len(own)]
        taken += level[: count - len(taken)]
        depth += 1
    places = {card.key: place for place, card in enumerate(card for own in of_tier.values() for card in own)}
    return sorted(taken, key=lambda card: places[card.key])
