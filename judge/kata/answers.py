"""Answers to quiz cards, as the history keeps them."""

from __future__ import annotations

from datetime import datetime
from enum import IntEnum

from msgspec import Struct


class Rating(IntEnum):
    """How well something was remembered."""

    AGAIN = 1
    HARD = 2
    GOOD = 3
    EASY = 4


class Answered(Struct, frozen=True):
    """One answer to a card; `judged` where the judge decided how it went, and not the person.

    `card` is the card's key, its deck and its id; `given` is what was typed.
    """

    when: datetime
    card: str
    form: str
    rating: Rating
    judged: bool
    given: str = ""

    @property
    def known(self) -> bool:
        """Whether it was remembered at all."""
        return self.rating is not Rating.AGAIN
