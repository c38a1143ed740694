"""A number: exactly, or off by a part of it at most."""

from __future__ import annotations

from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING

from judge.kata.quiz.cards import Card, Wants
from judge.kata.quiz.forms.form import Form
from judge.kata.quiz.question import MistypedError, Question, Reply
from judge.kata.quiz.sources import Sources
from judge.kata.quiz.typed import NUMBER, number

if TYPE_CHECKING:
    from judge.data.draw import Draw


def _ask(card: Card, _sources: Sources, _draw: Draw) -> Question:
    answer = f"{card.answer} {card.unit}".rstrip()
    return Question(card, NUMBER, answer, partial(_check, card), why=card.back)


def _check(card: Card, typed: str) -> Reply:
    typed = typed.strip().removesuffix(card.unit) if card.unit else typed
    found, wanted = number(typed), number(card.answer)
    right = abs(found - wanted) <= Fraction(card.within) * abs(wanted)
    return Reply(right, typed.strip())


def _fault(card: Card) -> tuple[str, str, str] | None:
    try:
        number(card.answer)
    except MistypedError:
        return "answer", f"answer = {card.answer!r} is no number", f"write {NUMBER}"
    if not 0 <= card.within < 1:
        return "within", f"within is {card.within}", "write a part of the answer: 0 up to 1"
    return None


FORM = Form(Wants(needs=("answer",), takes=("within", "unit"), check=_fault), _ask)
