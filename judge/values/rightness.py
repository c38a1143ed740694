"""Whether an answer is right, without a word about why it is not: for who decides a hundred thousand."""

from __future__ import annotations

from judge.values import ExactOf, Raw, Target, Type
from judge.values.outcome import ROOT, Unreadable
from judge.values.type import Question


def is_right(type_: Type, raw: Raw, target: Target, exact: ExactOf) -> bool:
    """Whether the type's `check` accepts `raw`, JSON of any shape whatever."""
    try:
        if type_.quick(raw, target) is not None:
            return True
    except (TypeError, ValueError):  # as in `check`
        pass
    question = Question(exact, type_.words, optional=type_.optional)
    try:
        return type_.accepts(type_.read(raw, question, ROOT), target, question, ROOT)
    except Unreadable:
        return False
