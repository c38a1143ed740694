"""The cards that were answered, and how many of them are due."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from judge.practice.review import Review


def known_cards(found: Sequence[Review], folders: Sequence[Path]) -> list[Review]:
    """Those reviews whose card is in a deck that can be read; a broken one is told of by `judge quiz`."""
    from judge.practice.quiz.cards import read_decks

    decks, _ = read_decks(folders)
    keys = {card.key for deck in decks for card in deck.cards}
    return [review for review in found if review.name in keys]
