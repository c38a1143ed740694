"""Decks of cards: TOML files beside the problems.

    problems/quiz/junior.toml          title = "Junior"
                                       sets = ["junior"]
                                       [[cards]]
                                       id = "three-counts"
                                       form = "recall"
                                       front = "How many …?"
                                       back = "Exactly 0, 1 or 2."
                                       rows = ["J1"]

Each form is a struct, whose fields are the keys of its cards. `rows` are the questions of checklist.toml that
it practises, `sets` the practice sets that the deck's cards are asked with.
"""

from __future__ import annotations

import re
import reprlib
from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Annotated

from msgspec import Meta, Struct

from judge.errors import ProblemError, UsageError, meant
from judge.practice.events import Answer
from judge.practice.review import Review, card_reviews
from judge.practice.syllabus import (
    USUAL,
    Checklist,
    Table,
    read_checklist,
    refuse_doubles,
    refuse_unknown,
    set_files,
    toml_files,
)
from judge.problem.find import problem_folders
from judge.problem.model import TEXT, Name
from judge.problem.toml import TomlFile, refusal

_NUMBER = re.compile(r"(?ai)[+-]?\d{1,40}((\.\d{0,40})?(e[+-]?\d{1,3})?|/0*[1-9]\d{0,39})")
LETTERS = "abcdefgh"  # of options
NONE = "none"
NUMBER = "4, 0.5, 1e-9 or 2/3"
_Text = Annotated[str, Meta(pattern=TEXT, max_length=2_000)]


class WrongOption(Table, frozen=True):
    """A wrong option of a choice: a mistake with its name, and why it is one."""

    text: _Text
    mistake: _Text
    why: _Text


class Content(Table, tag_field="form", frozen=True, kw_only=True):
    """What a card of any form says: `front` is asked, and `back` is told afterwards."""

    id: Name
    front: _Text
    back: _Text
    rows: tuple[str, ...] = ()


class Recall(Content, tag="recall", frozen=True):
    """Free recall: the person compares with the back, and rates the own answer."""


class Choice(Content, tag="choice", frozen=True):
    """One option is right, every other one a mistake with a name."""

    right: _Text
    wrong: tuple[WrongOption, ...]

    def __post_init__(self) -> None:
        if not 1 <= len(self.wrong) < len(LETTERS):
            raise refusal(f"there are {len(self.wrong)} wrong options", f"write 1 to {len(LETTERS) - 1}")
        texts = [self.right, *(each.text for each in self.wrong)]
        for place, text in enumerate(texts):
            if text in texts[:place]:
                raise refusal(f"two options say {text!r}", "change one of them")


class Number(Content, tag="number", frozen=True):
    """A number, off by `within` as a part of it at most; `unit` is what it counts."""

    answer: str
    within: Annotated[float, Meta(ge=0, lt=1)] = 0
    unit: str = ""

    def __post_init__(self) -> None:
        if not _NUMBER.fullmatch(self.answer):
            raise refusal(f"answer = {self.answer!r} is not a number", f"write {NUMBER}")


class Count(Content, tag="count", frozen=True):
    """How many things the answer to a fresh case holds; in whole numbers up to `largest`, unless it is 0."""

    problem: Name
    groups: tuple[str, ...] = ()
    largest: int = 0


class Drawn(Content, frozen=True):
    """A figure that a problem's topic makes afresh each time."""

    problem: Name


class FirstHit(Drawn, tag="first-hit", frozen=True):
    """What is met first."""


class Order(Drawn, tag="order", frozen=True):
    """In which order things are met."""


class Tags(Drawn, tag="tags", frozen=True):
    """What each thing that is met is."""


AnyForm = Recall | Choice | Number | Count | FirstHit | Order | Tags


class Card(Struct, frozen=True):
    """One card of a deck, which is asked with these practice sets; its questions need `skills`."""

    deck: str
    content: AnyForm
    sets: tuple[str, ...] = ()
    skills: tuple[str, ...] = ()
    topics: tuple[str, ...] = ()

    @property
    def key(self) -> str:
        """How the history knows it: its deck and its id, `junior/three-counts`."""
        return f"{self.deck}/{self.content.id}"

    @property
    def form(self) -> str:
        """The name of its form."""
        return str(self.content.__struct_config__.tag)

    @property
    def front(self) -> str:
        """What is asked."""
        return self.content.front.strip()

    @property
    def back(self) -> str:
        """What is told afterwards."""
        return self.content.back.strip()

    @property
    def problem(self) -> str:
        """The problem that it takes a figure of; empty where it takes none."""
        return getattr(self.content, "problem", "")


class _DeckTable(Table, frozen=True):
    title: str
    cards: list[AnyForm]
    sets: tuple[str, ...] = ()


def read_decks(extra: Sequence[Path] = ()) -> tuple[list[Card], list[ProblemError]]:
    """The cards of every deck that can be read, one deck of each name, and the fault of each that cannot.

    The sets' own decks come first, in the sets' order.
    """
    cards: list[Card] = []
    faults: list[ProblemError] = []
    sets = list(set_files(extra))
    try:
        checklist = read_checklist(extra)
    except ProblemError as fault:
        return [], [fault]
    for name, path in toml_files("quiz", sets, extra).items():
        try:
            cards += _deck(TomlFile(path), name, checklist, sets)
        except ProblemError as fault:
            faults.append(fault)
    return cards, faults


def known_cards(answers: Sequence[Answer], extra: Sequence[Path] = ()) -> list[Review]:
    """How the cards stand that were answered and are in a deck that can be read, as `card_reviews`."""
    keys = {card.key for card in read_decks(extra)[0]}
    return [review for review in card_reviews(answers) if review.name in keys]


def cards_of(name: str, extra: Sequence[Path] = ()) -> list[Card]:
    """The cards of a practice set, of a deck or of a topic, whose problems are here.

    Raises UsageError where there are none, ProblemError where a deck is broken.
    """
    cards, faults = read_decks(extra)
    for fault in faults:
        raise fault
    found = [card for card in cards if name in (USUAL, card.deck, *card.sets, *card.topics)]
    if not found:
        names = dict.fromkeys(each for card in cards for each in (*card.sets, card.deck, *card.topics))
        raise UsageError(f"There is no set of cards {name!r}", remedy=meant(name, [USUAL, *names]))
    here = {folder.name for folder in problem_folders(extra)}
    return [card for card in found if not card.problem or card.problem in here]


def _deck(file: TomlFile, name: str, checklist: Checklist, sets: Sequence[str]) -> list[Card]:
    table = file.read(_DeckTable)
    skills = {row.id: row.skills for row in checklist.rows}
    refuse_unknown(file, table.sets, sets, "no practice set is called", "sets")
    if not table.cards:
        raise file.fault("the deck has no card", "add [[cards]]")
    refuse_doubles(file, [card.id for card in table.cards], "cards", "id")
    for place, card in enumerate(table.cards):
        refuse_unknown(file, card.rows, list(skills), "the checklist has no row", "cards", place, "rows")
    found = []
    for card in table.cards:
        needs = tuple(dict.fromkeys(each for row in card.rows for each in skills[row]))
        found.append(Card(name, card, table.sets, needs, checklist.topics(needs)))
    return found


# -- what a person types -----------------------------------------------------------------------------------


class MistypedError(Exception):
    """What was typed is not an answer; the message says what one looks like."""


def number(text: str) -> Fraction:
    """The number that is typed. Raises MistypedError."""
    plain = text.replace("−", "-").replace(" ", "")
    if not _NUMBER.fullmatch(plain):
        raise _mistyped(text, "a number", NUMBER)
    return Fraction(plain)


def count(text: str) -> str:
    """How many are typed, or `none`. Raises MistypedError."""
    word = text.strip().lower()
    if not re.fullmatch(rf"{NONE}|\d{{1,6}}", word, re.ASCII):
        raise _mistyped(text, "a number", "0, 1, 2 … or none")
    return word if word == NONE else str(int(word))


def option(text: str, letters: Sequence[str]) -> str:
    """The letter that is typed. Raises MistypedError."""
    word = text.strip().lower().strip("().")
    if word not in letters:
        raise _mistyped(text, "one of the options", listed(letters, "or"))
    return word


def sequence(text: str, words: Mapping[str, str]) -> str:
    """The words that are typed, each as it is or by what it means, in any case; or `none`.

    Words of one letter each may be typed without blanks. Raises MistypedError.
    """
    parts = [part for part in re.split(r"[\s,;>→]+", text.lower()) if part]
    if parts == [NONE]:
        return NONE
    known = {word.lower(): word for word in words}
    known |= {meaning.lower(): word for word, meaning in words.items() if meaning}
    if len(parts) == 1 and parts[0] not in known and all(len(word) == 1 for word in words):
        parts = list(parts[0])
    lost = next((part for part in parts if part not in known), None)
    if lost is not None or not parts:
        raise _mistyped(lost or text, f"one of {listed(list(words), 'and')}", "them in their order, or none")
    return " ".join(known[part] for part in parts)


def listed(words: Sequence[str], last: str) -> str:
    """The words with commas, and the `last` word before the last of them: `a, b or c`."""
    *first, end = words
    return f"{', '.join(first)} {last} {end}" if first else end


def _mistyped(text: str, kind: str, remedy: str) -> MistypedError:
    word = text.strip()
    if not word:
        return MistypedError(f"Type {remedy}; ? if you do not know, q to stop")
    return MistypedError(f"{reprlib.repr(word)} is not {kind}. Type {remedy}")
