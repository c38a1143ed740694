"""What to drill: rows of the checklist, each with the commands that practise it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

from judge.kata.checklist import Row, read_checklist
from judge.problem.find import problem_folders

if TYPE_CHECKING:
    from judge.kata.quiz.cards import Card
    from judge.kata.review import Review


def known_cards(found: Sequence[Review], folders: Sequence[Path]) -> list[Review]:
    """Those reviews whose card is in a deck that can be read; a broken one is told of by `judge quiz`."""
    from judge.kata.quiz.cards import read_decks

    decks, _ = read_decks(folders)
    keys = {card.key for deck in decks for card in deck.cards}
    return [review for review in found if review.name in keys]


def to_drill(
    missed: Sequence[Card], folders: Sequence[Path], more: Mapping[str, str] = MappingProxyType({})
) -> list[tuple[Row, tuple[str, ...]]]:
    """The rows of cards that were not known, and those in `more` with a command; each once, in its order.

    A card that drills several rows stands for its first one.
    """
    carded = {card.rows[0] for card in missed if card.rows}
    here = {folder.name for folder in problem_folders(folders)}
    found = []
    for row in read_checklist(folders).rows:
        if row.id not in carded and row.id not in more:
            continue
        commands = [f"judge quiz --row {row.id}"] if row.id in carded else [more[row.id]]
        commands += [f"judge init {kata}" for kata in row.katas if kata in here]
        found.append((row, tuple(commands)))
    return found
