"""Free recall: the model answer is shown, and the person rates the own one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from judge.kata.quiz.cards import Card, Wants
from judge.kata.quiz.forms.form import Form
from judge.kata.quiz.question import Question
from judge.kata.quiz.sources import Sources

if TYPE_CHECKING:
    from judge.data.draw import Draw


def _ask(card: Card, _sources: Sources, _draw: Draw) -> Question:
    return Question(card, "your answer, or nothing if you say it aloud", card.back)


FORM = Form(Wants(), _ask)
