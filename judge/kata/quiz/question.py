"""A card that is asked: what is shown, and what an answer comes to."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.kata.quiz.cards import Card

if TYPE_CHECKING:
    from judge.drawing import Picture


class MistypedError(Exception):
    """What was typed is no answer at all; the message says what one looks like."""


class Reply(Struct, frozen=True):
    """What an answer comes to; `given` is the answer as it was understood.

    Where it is wrong in a way that has a name, `mistake` is that, and `why` says what is wrong with it.
    """

    right: bool
    given: str
    mistake: str = ""
    why: str = ""


class Question(Struct, frozen=True):
    """One question.

    Attributes:
        card: what it is made from.
        expects: what may be typed, in words.
        answer: the right answer in words, the model answer of one that the person rates.
        check: what an answer comes to; raises MistypedError. None where the person rates it.
        given: what is known of the figure, a line each.
        options: what to choose from, each with its letter.
        program: the source that the question is about.
        picture: the figure, without the answer.
        why: what makes the answer right in this figure.
    """

    card: Card
    expects: str
    answer: str
    check: Callable[[str], Reply] | None = None
    given: tuple[str, ...] = ()
    options: tuple[tuple[str, str], ...] = ()
    program: str = ""
    picture: Picture | None = None
    why: str = ""
