"""Decks of cards: TOML files beside the problems.

    problems/quiz/junior.toml          title = "Junior"
                                       sets = ["junior"]
                                       [[cards]]
                                       id = "three-counts"
                                       form = "recall"
                                       front = "How many …?"
                                       back = "Exactly 0, 1 or 2."
                                       rows = ["J1"]

What else a card says depends on its form (judge.kata.quiz.forms). `rows` are those of checklist.toml that it
drills, `sets` the practice sets that the deck's cards are asked with.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NoReturn

from msgspec import Struct

from judge.errors import ProblemError, UsageError, nearest
from judge.kata.sets import set_names
from judge.problem.find import problem_folders, problem_roots
from judge.problem.tables import TomlFile, meant

_FOLDER = "quiz"
_ALWAYS = ("id", "form", "front", "back", "rows")
_NAME = "abcdefghijklmnopqrstuvwxyz0123456789-"
_LONGEST = 2_000  # characters of a text


class WrongOption(Struct, forbid_unknown_fields=True, frozen=True):
    """A wrong option of a choice: a mistake with its name, and why it is one."""

    text: str
    mistake: str
    why: str


class Card(Struct, frozen=True):
    """One card. `front` is asked and `back` told afterwards; the rest belongs to some forms only.

    Attributes:
        deck: the name of its deck; `key` is how the history knows it.
        right, wrong: the options of a choice.
        answer, within, unit: the number that is wanted, how far off an answer may be as a part of it, what it
            counts.
        problem, groups, mistakes: of which a figure or a wrong program is taken.
        largest: figures are in whole numbers up to this; 0 where any will do.
    """

    deck: str
    id: str
    form: str
    front: str
    back: str
    rows: tuple[str, ...] = ()
    sets: tuple[str, ...] = ()
    right: str = ""
    wrong: tuple[WrongOption, ...] = ()
    answer: str = ""
    within: float = 0
    unit: str = ""
    problem: str = ""
    groups: tuple[str, ...] = ()
    mistakes: tuple[str, ...] = ()
    largest: int = 0

    @property
    def key(self) -> str:
        """What the history knows it by: `junior/three-counts`."""
        return f"{self.deck}/{self.id}"


class Deck(Struct, frozen=True):
    """One file of cards."""

    name: str
    title: str
    cards: tuple[Card, ...]


class Wants(Struct, frozen=True):
    """What a form asks of a card: keys that must be there, keys that may be, and a check of their values.

    The check gives the key at fault, what is wrong, and what to do.
    """

    needs: tuple[str, ...] = ()
    takes: tuple[str, ...] = ()
    check: Callable[[Card], tuple[str, str, str] | None] | None = None


class _CardTable(Struct, forbid_unknown_fields=True, frozen=True):
    id: str
    form: str
    front: str
    back: str | None = None
    rows: list[str] | None = None
    right: str | None = None
    wrong: list[WrongOption] | None = None
    answer: str | None = None
    within: float | None = None
    unit: str | None = None
    problem: str | None = None
    groups: list[str] | None = None
    largest: int | None = None
    mistakes: list[str] | None = None


class _DeckTable(Struct, forbid_unknown_fields=True, frozen=True):
    title: str
    cards: list[_CardTable]
    sets: list[str] = []


def all_cards(extra: Sequence[Path] = ()) -> list[Card]:
    """The cards of all decks, in their order. Raises ProblemError where a deck is broken."""
    return [card for deck in all_decks(extra) for card in deck.cards]


def all_decks(extra: Sequence[Path] = ()) -> list[Deck]:
    """Every deck that can be found, one of each name; the sets' own decks come first, in the sets' order.

    Raises:
        ProblemError: a deck is broken: the first fault there is.
    """
    decks, faults = sound_decks(extra)
    for fault in faults:
        raise fault
    return decks


def sound_decks(extra: Sequence[Path] = ()) -> tuple[list[Deck], list[ProblemError]]:
    """Every deck that can be read, and the fault of each that cannot."""
    from judge.kata.checklist import read_checklist  # which does not need decks

    found: dict[str, Path] = {}
    for root in problem_roots(extra):
        for path in sorted((root / _FOLDER).glob("*.toml")):
            found.setdefault(path.stem, path)
    sets = set_names(extra)
    order = {name: place for place, name in enumerate(sets)}
    decks: list[Deck] = []
    faults: list[ProblemError] = []
    try:
        rows = [row.id for row in read_checklist(extra).rows]
    except ProblemError as fault:
        return [], [fault]
    for name in sorted(found, key=lambda name: (order.get(name, len(order)), name)):
        try:
            decks.append(_Reader(found[name], rows, sets).deck())
        except ProblemError as fault:
            faults.append(fault)
    return decks, faults


def cards_of(name: str, cards: Sequence[Card], extra: Sequence[Path] = ()) -> list[Card]:
    """The cards of a practice set, or of a deck. Raises UsageError where nothing is called so."""
    from judge.kata.sets import USUAL

    found = [card for card in cards if name == USUAL or name == card.deck or name in card.sets]
    if not found:
        known = list(dict.fromkeys([*set_names(extra), *(card.deck for card in cards)]))
        what = f"the set {name!r} has no cards" if name in known else f"no set of cards is called {name!r}"
        holding = [each for each in known if each == USUAL or any(each in card.sets for card in cards)]
        remedy = meant(name, known) if name not in known else f"cards are in {', '.join(holding)}"
        raise UsageError(what, remedy=remedy)
    return found


class _Reader:
    """Reads one deck; every fault has its line."""

    def __init__(self, path: Path, rows: Sequence[str], sets: Sequence[str]) -> None:
        self._file = TomlFile(path)
        self._name = path.stem
        self._rows = rows
        self._sets = sets

    def deck(self) -> Deck:
        """The deck. Raises ProblemError."""
        table = self._file.read(_DeckTable)
        for place, name in enumerate(table.sets):
            if name not in self._sets:
                remedy = meant(name, list(self._sets))
                raise self._file.fault(f"no practice set is called {name!r}", remedy, "sets", place)
        if not table.cards:
            raise self._file.fault("the deck has no card", "add [[cards]]")
        cards: dict[str, Card] = {}
        for place, each in enumerate(table.cards):
            if each.id in cards:
                what = f"the card {each.id!r} is there twice"
                raise self._file.fault(what, "give one another id", "cards", place, "id")
            cards[each.id] = self._card(each, place, tuple(table.sets))
        return Deck(self._name, table.title, tuple(cards.values()))

    def _card(self, table: _CardTable, place: int, sets: tuple[str, ...]) -> Card:
        from judge.kata.quiz.forms import WANTS

        given = {key for key in table.__struct_fields__ if getattr(table, key) is not None}
        if not table.id or set(table.id) - set(_NAME):
            self._fail(place, "id", f"{table.id!r} is no id", "write it in small letters, digits and -")
        wants = WANTS.get(table.form)
        if wants is None:
            meant = nearest(table.form, WANTS)
            remedy = f"did you mean {meant!r}?" if meant else f"the forms are {', '.join(WANTS)}"
            self._fail(place, "form", f"no form of cards is called {table.form!r}", remedy)
        for key in (*wants.needs, *(() if "back" in wants.takes else ("back",))):
            if key not in given:
                self._fail(
                    place, "", f"the key {key!r} is missing, which {table.form} asks for", f"add {key} = …"
                )
        for key in sorted(given - {*_ALWAYS, *wants.needs, *wants.takes}):
            self._fail(place, key, f"{key!r} is no key of the form {table.form}", "remove it")
        for key in given:
            value = getattr(table, key)
            if isinstance(value, str) and (not value.strip() or len(value) > _LONGEST):
                self._fail(
                    place, key, f"{key} is {'too long' if value.strip() else 'empty'}", "write a sentence"
                )
        for at, row in enumerate(table.rows or ()):
            if row not in self._rows:
                what, remedy = f"the checklist has no row {row!r}", self._like_row(row)
                raise self._file.fault(what, remedy, "cards", place, "rows", at)
        card = self._made(table, sets)
        if wants.check and (fault := wants.check(card)):
            self._fail(place, *fault)
        return card

    def _made(self, table: _CardTable, sets: tuple[str, ...]) -> Card:
        return Card(
            deck=self._name,
            id=table.id,
            form=table.form,
            front=table.front.strip(),
            back=(table.back or "").strip(),
            rows=tuple(table.rows or ()),
            sets=sets,
            right=table.right or "",
            wrong=tuple(table.wrong or ()),
            answer=table.answer or "",
            within=table.within or 0,
            unit=table.unit or "",
            problem=table.problem or "",
            groups=tuple(table.groups or ()),
            mistakes=tuple(table.mistakes or ()),
            largest=table.largest or 0,
        )

    def _like_row(self, row: str) -> str:
        meant = nearest(row, self._rows)
        return f"did you mean {meant!r}?" if meant else "'judge progress --all' lists them"

    def _fail(self, place: int, key: str, what: str, remedy: str) -> NoReturn:
        path: tuple[str | int, ...] = ("cards", place, key) if key else ("cards", place)
        raise self._file.fault(what, remedy, *path)


def unknown_parts(cards: Sequence[Card], extra: Sequence[Path] = ()) -> Mapping[str, str]:
    """The problems that cards name and that are not here, each with a card that does."""
    here = {folder.name for folder in problem_folders(extra)}
    return {card.problem: card.key for card in cards if card.problem and card.problem not in here}
