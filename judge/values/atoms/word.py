"""`word(a|b|…)`: one of a few words, a str of ASCII letters, digits, hyphens and underscores."""

from __future__ import annotations

from functools import cached_property
from typing import Any

from judge.values.decode import LONGEST_WORD, shown, word
from judge.values.lines import Tokens
from judge.values.outcome import Mismatch, Place, Unreadable
from judge.values.plain import PlainType
from judge.values.type import NOTHING_MEASURED, Question, Quick, Raw, Target


class WordType(PlainType):
    """One of the words given."""

    annotation = "str"
    plural = "words"

    def __init__(self, *words: str) -> None:
        if len(words) < 2 or len(set(words)) < len(words) or "none" in words:
            raise ValueError("a word is one of two or more, all of them different and none of them none")
        if max(map(len, words)) > LONGEST_WORD:
            raise ValueError(f"a word has at most {LONGEST_WORD} characters")
        self.text = f"word({'|'.join(words)})"
        self.samples = words

    @property
    def noun(self) -> str:  # type: ignore[override]
        """The choice."""
        return f"{', '.join(self.samples[:-1])} or {self.samples[-1]}"

    @cached_property
    def quick(self) -> Quick:
        """Whether it is sent as that word."""

        def quick(raw: Raw, target: Target) -> float | None:
            right = type(raw) is dict and type(target) is str and raw == {"word": target}
            return NOTHING_MEASURED if right else None

        return quick

    def why_not(self, value: Any) -> str | None:
        """One of the choice."""
        return (
            None if type(value) is str and value in self.samples else f"{value!r} where {self.noun} is meant"
        )

    def value_of(self, raw: Raw) -> Any:
        """Any word: a wrong one is a wrong answer."""
        given = word(raw)
        if given is None:
            raise ValueError("no word")
        return given

    def matched(self, value: Any, target: Target, question: Question, place: Place) -> float:
        """A word that is no choice at all is told as that."""
        if wrong := self.why_not(value):
            raise Mismatch(f"{place.prefix()}{wrong}", place.name())
        return super().matched(value, target, question, place)

    def sent(self, value: Any) -> Raw:
        """As a word."""
        return {"word": value}

    def shown(self, raw: Raw) -> str:
        """Between quotation marks."""
        return repr(raw) if type(raw) is str else super().shown(raw)

    def take(self, tokens: Tokens) -> Raw:
        """Any word of the usual length."""
        token = tokens.next()
        if len(token) > LONGEST_WORD:
            raise Unreadable(f"{shown(token)} where {self.noun} is meant")
        return {"word": token}

    def value_from(self, token: str) -> Any:
        """One of the choice."""
        if token not in self.samples:
            raise ValueError(f"none of the words: {token[:40]!r}")
        return token


TYPE = WordType
