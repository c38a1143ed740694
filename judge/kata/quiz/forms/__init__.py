"""The forms of cards: what each asks of a card, and how a question is made of one.

recall                             free recall; the person compares with the model answer, and rates it
choice                             one option is right, every other one a mistake with a name
number                             a number, exactly or nearly
count, first-hit, order, tags      about a figure that is drawn anew each time; drawn.py
spot                               which test group breaks a wrong program
"""

from __future__ import annotations

from collections.abc import Mapping

from judge.kata.quiz.cards import Card, Wants
from judge.kata.quiz.forms import choice, drawn, number, recall, spot
from judge.kata.quiz.question import Question
from judge.kata.quiz.sources import Sources

_FORMS = {
    "recall": recall.FORM,
    "choice": choice.FORM,
    "number": number.FORM,
    **drawn.FORMS,
    "spot": spot.FORM,
}
WANTS: Mapping[str, Wants] = {name: form.wants for name, form in _FORMS.items()}
NAMES = tuple(_FORMS)


def ask(card: Card, sources: Sources, turn: str) -> Question:
    """The card as a question; what is left to chance depends on the seed and on the `turn`.

    Raises:
        UsageError: a problem that it names is not here.
        ProblemError: a problem's own code fails, or the card asks for what it has not.
    """
    return _FORMS[card.form].ask(card, sources, sources.draw(f"{card.key}/{turn}"))
