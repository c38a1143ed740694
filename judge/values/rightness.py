"""Whether an answer is right, without a word about why it is not: for who decides a hundred thousand."""

from __future__ import annotations

from typing import Any

from judge.values.judged import decide
from judge.values.likeness import Outline
from judge.values.outcome import ROOT, Mismatch, Place, Unreadable
from judge.values.type import ExactOf, Question, Raw, Target, Type


def is_right(type_: Type, raw: Raw, target: Target, exact: ExactOf) -> bool:
    """Whether the type's `check` accepts `raw`, JSON of any shape whatever."""
    if _quickly(type_, raw, target):
        return True
    question = Question(exact, type_.words, optional=type_.optional)
    try:
        return accepts(type_, type_.read(raw, question, ROOT), target, question, ROOT)
    except Unreadable:
        return False


def wrong_outline(type_: Type, raw: Raw, target: Target, exact: ExactOf) -> Outline | None:
    """None where `is_right`, and else the answer's outline; it is read once for both."""
    from judge.values.outline import of_value, outline  # a run without wrong answers needs none

    if _quickly(type_, raw, target):
        return None
    question = Question(exact, type_.words, optional=type_.optional)
    try:
        value = type_.read(raw, question, ROOT)
    except Unreadable:
        return outline(type_, raw)
    if accepts(type_, value, target, question, ROOT):
        return None
    return outline(type_, raw) if raw is None else of_value(type_, value)


def _quickly(type_: Type, raw: Raw, target: Target) -> bool:
    """Whether doubles accept it at once."""
    try:
        return type_.quick(raw, target) is not None
    except (TypeError, ValueError):  # as in `check`
        return False


def accepts(type_: Type, value: Any, target: Target, question: Question, place: Place) -> bool:
    """Whether the type's `held` raises nothing."""
    if type(target) is dict and "any" in target:
        steps = enumerate(target["any"])
        return any(accepts(type_, value, each, question, Place(place, at, "")) for at, each in steps)
    if type(target) is dict and "such as" in target:
        try:
            decide(value, question, place)
        except Mismatch:
            return False
        return True
    return type_.fits(value, target, question, place)
