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

from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path

import msgspec
from msgspec import Struct

from judge.errors import ProblemError, UsageError
from judge.practice.checklist import read_checklist
from judge.practice.quiz.typed import NUMBER, MistypedError, number
from judge.practice.sets import USUAL, set_names
from judge.problem.find import problem_roots
from judge.problem.toml import TomlFile, meant, refusal

_NAME = frozenset("abcdefghijklmnopqrstuvwxyz0123456789-")
_LONGEST = 2_000  # characters of a text
LETTERS = "abcdefgh"  # of options


class WrongOption(Struct, forbid_unknown_fields=True, frozen=True):
    """A wrong option of a choice: a mistake with its name, and why it is one."""

    text: str
    mistake: str
    why: str


class Content(Struct, tag_field="form", forbid_unknown_fields=True, frozen=True, kw_only=True):
    """What a card of any form says: `front` is asked, and `back` is told afterwards."""

    id: str
    front: str
    back: str
    rows: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if not self.id or set(self.id) - _NAME:
            raise refusal(f"{self.id!r} is not an id", "write it in small letters, digits and -")
        for field in msgspec.structs.fields(self):
            text = getattr(self, field.name)
            empty = isinstance(text, str) and field.required and not text.strip()
            if empty or (isinstance(text, str) and len(text) > _LONGEST):
                raise refusal(f"{field.name} is {'empty' if empty else 'too long'}", "write a sentence")


class Recall(Content, tag="recall", frozen=True):
    """Free recall: the person compares with the back, and rates the own answer."""


class Choice(Content, tag="choice", frozen=True):
    """One option is right, every other one a mistake with a name."""

    right: str
    wrong: tuple[WrongOption, ...]

    def __post_init__(self) -> None:
        super().__post_init__()
        if not 1 <= len(self.wrong) < len(LETTERS):
            raise refusal(f"there are {len(self.wrong)} wrong options", f"write 1 to {len(LETTERS) - 1}")
        texts = [self.right, *(each.text for each in self.wrong)]
        for place, text in enumerate(texts):
            if text in texts[:place]:
                raise refusal(f"two options say {text!r}", "change one of them")
        if not all(part.strip() for each in self.wrong for part in (each.text, each.mistake, each.why)):
            raise refusal(
                "a wrong option is empty", "write its text, its mistake's name, and why it is wrong"
            )


class Number(Content, tag="number", frozen=True):
    """A number, off by `within` as a part of it at most; `unit` is what it counts."""

    answer: str
    within: float = 0
    unit: str = ""

    def __post_init__(self) -> None:
        super().__post_init__()
        try:
            number(self.answer)
        except MistypedError:
            raise refusal(f"answer = {self.answer!r} is not a number", f"write {NUMBER}") from None
        if not 0 <= Fraction(self.within) < 1:
            raise refusal(f"within is {self.within}", "write a part of the answer: 0 up to 1")


class Count(Content, tag="count", frozen=True):
    """How many things the answer to a fresh case holds; in whole numbers up to `largest`, unless it is 0."""

    problem: str
    groups: tuple[str, ...] = ()
    largest: int = 0


class Drawn(Content, frozen=True):
    """A figure that a problem's topic makes afresh each time."""

    problem: str


class FirstHit(Drawn, tag="first-hit", frozen=True):
    """What is met first."""


class Order(Drawn, tag="order", frozen=True):
    """In which order things are met."""


class Tags(Drawn, tag="tags", frozen=True):
    """What each thing that is met is."""


class Spot(Content, tag="spot", frozen=True, kw_only=True):
    """Which test group a wrong program fails, that makes one of these `mistakes`, or any."""

    back: str = ""
    problem: str
    mistakes: tuple[str, ...] = ()


AnyForm = Recall | Choice | Number | Count | FirstHit | Order | Tags | Spot
FORMS = {each.__struct_config__.tag: each for each in AnyForm.__args__}


class Card(Struct, frozen=True):
    """One card of a deck; `key` is how the history knows it: `junior/three-counts`."""

    deck: str
    content: AnyForm
    sets: tuple[str, ...] = ()

    @property
    def key(self) -> str:
        """Its deck and its id."""
        return f"{self.deck}/{self.id}"

    @property
    def id(self) -> str:
        """Its name in its deck."""
        return self.content.id

    @property
    def form(self) -> str:
        """The name of its form."""
        return str(self.content.__struct_config__.tag)

    @property
    def front(self) -> str:
        """What is asked."""
        return self.content.front.strip()

    @property
    def rows(self) -> tuple[str, ...]:
        """The questions of the checklist that it practises."""
        return self.content.rows

    @property
    def problem(self) -> str:
        """The problem that it takes a figure or a program of; empty where it takes none."""
        return getattr(self.content, "problem", "")


class Deck(Struct, frozen=True):
    """One file of cards."""

    name: str
    path: Path
    title: str
    cards: tuple[Card, ...]


class _DeckTable(Struct, forbid_unknown_fields=True, frozen=True):
    title: str
    cards: list[AnyForm]
    sets: tuple[str, ...] = ()


def read_decks(extra: Sequence[Path] = ()) -> tuple[list[Deck], list[ProblemError]]:
    """Every deck that can be read, one of each name, and the fault of each that cannot.

    The sets' own decks come first, in the sets' order.
    """
    found: dict[str, Path] = {}
    for root in problem_roots(extra):
        for path in sorted((root / "quiz").glob("*.toml")):
            found.setdefault(path.stem, path)
    sets = set_names(extra)
    decks: list[Deck] = []
    faults: list[ProblemError] = []
    try:
        rows = [row.id for row in read_checklist(extra).rows]
    except ProblemError as fault:
        return [], [fault]
    for name in sorted(found, key=lambda name: (sets.index(name) if name in sets else len(sets), name)):
        try:
            decks.append(_deck(name, found[name], rows, sets))
        except ProblemError as fault:
            faults.append(fault)
    return decks, faults


def all_cards(extra: Sequence[Path] = ()) -> list[Card]:
    """The cards of all decks, in their order. Raises ProblemError where a deck is broken."""
    decks, faults = read_decks(extra)
    for fault in faults:
        raise fault
    return [card for deck in decks for card in deck.cards]


def cards_of(name: str, cards: Sequence[Card], extra: Sequence[Path] = ()) -> list[Card]:
    """The cards of a practice set, or of a deck. Raises UsageError where nothing is called so."""
    found = [card for card in cards if name == USUAL or name == card.deck or name in card.sets]
    if not found:
        known = list(dict.fromkeys([*set_names(extra), *(card.deck for card in cards)]))
        what = f"The set {name!r} has no cards" if name in known else f"There is no set of cards {name!r}"
        holding = [each for each in known if each == USUAL or any(each in card.sets for card in cards)]
        remedy = meant(name, known) if name not in known else f"cards are in {', '.join(holding)}"
        raise UsageError(what, remedy=remedy)
    return found


def _deck(name: str, path: Path, rows: Sequence[str], sets: Sequence[str]) -> Deck:
    file = TomlFile(path)
    table = file.read(_DeckTable)
    for place, each in enumerate(table.sets):
        if each not in sets:
            raise file.fault(f"no practice set is called {each!r}", meant(each, sets), "sets", place)
    if not table.cards:
        raise file.fault("the deck has no card", "add [[cards]]")
    ids = [card.id for card in table.cards]
    for place, card in enumerate(table.cards):
        if card.id in ids[:place]:
            what = f"the card {card.id!r} is there twice"
            raise file.fault(what, "give one another id", "cards", place, "id")
        for at, row in enumerate(card.rows):
            if row not in rows:
                what = f"the checklist has no row {row!r}"
                raise file.fault(what, meant(row, rows), "cards", place, "rows", at)
    return Deck(name, path, table.title, tuple(Card(name, card, table.sets) for card in table.cards))
