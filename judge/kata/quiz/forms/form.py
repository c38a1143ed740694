"""What a form of cards is."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from msgspec import Struct

from judge.errors import ProblemError
from judge.kata.quiz.cards import Card, Wants
from judge.kata.quiz.question import Question
from judge.kata.quiz.sources import Sources


class Form(Struct, frozen=True):
    """A form: what it asks of a card, and how a question is made of one, some of it by chance."""

    wants: Wants
    ask: Callable[[Card, Sources, Any], Question]  # with the Draw that chance comes from


def cannot(card: Card, what: str, remedy: str) -> ProblemError:
    """The fault of a card that asks for what its problem has not."""
    return ProblemError(f"card {card.id!r}: {what}", where=f"quiz/{card.deck}.toml", remedy=remedy)
