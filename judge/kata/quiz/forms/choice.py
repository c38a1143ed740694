"""One of several options is right; each of the others is a mistake with a name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

from judge.kata.quiz.cards import Card, Wants, WrongOption
from judge.kata.quiz.forms.form import Form
from judge.kata.quiz.question import Question, Reply
from judge.kata.quiz.sources import Sources
from judge.kata.quiz.typed import letters_of, option

if TYPE_CHECKING:
    from judge.data.draw import Draw

LETTERS = "abcdefgh"


def shuffled(count: int, draw: Draw) -> list[int]:
    """The places 0 … count − 1 in an order by chance."""
    places = list(range(count))
    for end in range(count - 1, 0, -1):
        at = draw.integer(0, end)
        places[at], places[end] = places[end], places[at]
    return places


def _ask(card: Card, _sources: Sources, draw: Draw) -> Question:
    choices: list[WrongOption | None] = [None, *card.wrong]
    order = [choices[place] for place in shuffled(len(choices), draw)]
    letters = LETTERS[: len(order)]
    options = tuple(
        (letter, card.right if each is None else each.text)
        for letter, each in zip(letters, order, strict=True)
    )
    by_letter = dict(zip(letters, order, strict=True))
    right = next(letter for letter, each in by_letter.items() if each is None)
    return Question(
        card,
        letters_of(letters),
        f"{right}  {card.right}",
        partial(_check, by_letter),
        options=options,
        why=card.back,
    )


def _check(by_letter: Mapping[str, WrongOption | None], typed: str) -> Reply:
    letter = option(typed, list(by_letter))
    chosen = by_letter[letter]
    return Reply(True, letter) if chosen is None else Reply(False, letter, chosen.mistake, chosen.why)


def _fault(card: Card) -> tuple[str, str, str] | None:
    if not 1 <= len(card.wrong) < len(LETTERS):
        return "wrong", f"there are {len(card.wrong)} wrong options", f"write 1 to {len(LETTERS) - 1}"
    texts: Sequence[str] = [card.right, *(each.text for each in card.wrong)]
    twice = next((text for place, text in enumerate(texts) if text in texts[:place]), None)
    if twice is not None:
        return "wrong", f"two options say {twice!r}", "change one of them"
    if any(not part.strip() for each in card.wrong for part in (each.text, each.mistake, each.why)):
        return "wrong", "a wrong option is empty", "write its text, its mistake's name, and why it is wrong"
    return None


FORM = Form(Wants(needs=("right", "wrong"), check=_fault), _ask)
