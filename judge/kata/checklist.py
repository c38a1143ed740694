"""The checklist: the questions of a topic, a row each, and what has shown that the person can answer them.

    problems/checklist.toml        [[sections]]
                                   id = "junior"
                                   title = "Junior questions"
                                   sets = ["junior"]
                                   [[rows]]
                                   id = "J3"
                                   section = "junior"
                                   ask = "How far is a point from the line through A and B?"
                                   katas = ["distance"]

A row is ticked by any one of these, whole:

    katas     each of them that is here was accepted
    skills    each of them that is here is shown (skills.toml)
    cards     each card that names the row was remembered when it was last answered
    broken    one of these mistakes was broken with a case of the person's own, as "count/no-degenerate"

It is lost where one of them once was whole and none is any more.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from datetime import datetime
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.errors import UsageError, nearest
from judge.kata.events import Answer
from judge.kata.skills import SkillProgress, SkillState
from judge.kata.standing import Standing
from judge.problem.find import problem_roots
from judge.problem.tables import TomlFile

if TYPE_CHECKING:
    from judge.kata.quiz.cards import Card

_FILE = "checklist.toml"


class Section(Struct, frozen=True):
    """A part of the checklist; the first of all is what a person ticks off before an interview."""

    id: str
    title: str
    sets: tuple[str, ...] = ()


class Row(Struct, frozen=True):
    """One question, and what may show that it can be answered."""

    id: str
    section: str
    ask: str
    katas: tuple[str, ...] = ()
    skills: tuple[str, ...] = ()
    broken: tuple[str, ...] = ()


class Checklist(Struct, frozen=True):
    """All sections and rows, in their order."""

    sections: tuple[Section, ...] = ()
    rows: tuple[Row, ...] = ()


class Kind(Enum):
    """What ticks a row; the value is its name in JSON."""

    KATA = "kata"
    SKILL = "skill"
    CARD = "card"
    BROKEN = "broken"


class Evidence(Struct, frozen=True):
    """One thing that may tick a row: since when it does, and whether it did and no longer does.

    `drill` are the words of the command that practises it.
    """

    kind: Kind
    name: str
    drill: str
    since: datetime | None = None
    lost: bool = False


class RowProgress(Struct, frozen=True):
    """A row, and all that may tick it: only what is here."""

    row: Row
    evidence: tuple[Evidence, ...]

    def of(self, kind: Kind) -> tuple[Evidence, ...]:
        """What there is of one kind."""
        return tuple(each for each in self.evidence if each.kind is kind)

    @property
    def since(self) -> datetime | None:
        """Since when it has been ticked; None where it is not."""
        found = []
        for kind in Kind:
            dates = [None if each.lost else each.since for each in self.of(kind)]
            there = [date for date in dates if date is not None]
            if there and (kind is Kind.BROKEN or len(there) == len(dates)):
                found.append(min(there) if kind is Kind.BROKEN else max(there))
        return min(found, default=None)

    @property
    def state(self) -> SkillState:
        """Shown, lost or open."""
        if self.since is not None:
            return SkillState.SHOWN
        return SkillState.LOST if any(each.lost for each in self.evidence) else SkillState.OPEN

    @property
    def drills(self) -> tuple[str, ...]:
        """The commands that practise it, what does not tick it yet first; each once."""
        waiting = sorted(self.evidence, key=lambda each: each.since is not None and not each.lost)
        return tuple(dict.fromkeys(each.drill for each in waiting))


class _SectionTable(Struct, forbid_unknown_fields=True, frozen=True):
    id: str
    title: str
    sets: list[str] = []


class _RowTable(Struct, forbid_unknown_fields=True, frozen=True):
    id: str
    section: str
    ask: str
    katas: list[str] = []
    skills: list[str] = []
    broken: list[str] = []


class _ChecklistTable(Struct, forbid_unknown_fields=True, frozen=True):
    sections: list[_SectionTable]
    rows: list[_RowTable]


def read_checklist(extra: Sequence[Path] = ()) -> Checklist:
    """The rows of every folder's file, each id once; the first of a name wins. Raises ProblemError."""
    sections: dict[str, Section] = {}
    rows: dict[str, Row] = {}
    for root in problem_roots(extra):
        if not (root / _FILE).is_file():
            continue
        file = TomlFile(root / _FILE)
        table = file.read(_ChecklistTable)
        here: set[str] = set()
        for section in table.sections:
            sections.setdefault(section.id, Section(section.id, section.title, tuple(section.sets)))
        for place, row in enumerate(table.rows):
            if row.id in here:
                raise file.fault(f"the row {row.id!r} is there twice", "take one out", "rows", place, "id")
            if row.section not in sections:
                remedy = f"the sections are {', '.join(sections)}"
                raise file.fault(f"no section is called {row.section!r}", remedy, "rows", place, "section")
            at = next((at for at, each in enumerate(row.broken) if len(each.split("/")) != 2), None)
            if at is not None:
                remedy = 'write "problem/mistake"'
                raise file.fault(f"{row.broken[at]!r} names no mistake", remedy, "rows", place, "broken", at)
            here.add(row.id)
            parts = (tuple(row.katas), tuple(row.skills), tuple(row.broken))
            rows.setdefault(row.id, Row(row.id, row.section, row.ask, *parts))
    return Checklist(tuple(sections.values()), tuple(rows.values()))


def row_ids(extra: Sequence[Path] = ()) -> list[str]:
    """The ids of all rows. Raises ProblemError."""
    return [row.id for row in read_checklist(extra).rows]


def find_row(name: str, checklist: Checklist) -> Row:
    """The row of that id, in any case. Raises UsageError where there is none."""
    known = {row.id.lower(): row for row in checklist.rows}
    if name.lower() in known:
        return known[name.lower()]
    meant = nearest(name.upper(), [row.id for row in checklist.rows])
    remedy = f"did you mean {meant!r}? " if meant else ""
    raise UsageError(
        f"the checklist has no row {name!r}", remedy=f"{remedy}'judge progress --rows' lists them"
    )


class Record(Struct, frozen=True):
    """What a history says of the person, as far as the checklist asks.

    `broken` says when a mistake was first broken with a case of the person's own, by "problem/mistake".
    """

    standings: Mapping[str, Standing]
    skills: Sequence[SkillProgress]
    answers: Sequence[Answer]
    broken: Mapping[str, datetime]


def assess_rows(
    rows: Iterable[Row], record: Record, cards: Sequence[Card], here: Iterable[str], *, breaking: bool = True
) -> list[RowProgress]:
    """How each row stands; `here` are the ids of the problems that can be found.

    Without `breaking` there is no command to break mistakes with, and such evidence counts only where it is
    there already.
    """
    here = set(here)
    answered: dict[str, list[Answer]] = {}
    for answer in record.answers:
        answered.setdefault(answer.card, []).append(answer)
    skills = {each.skill.name: each for each in record.skills}
    of_row: dict[str, list[Card]] = {}
    for card in cards:
        for name in card.rows:
            if not card.problem or card.problem in here:
                of_row.setdefault(name, []).append(card)

    def evidence(row: Row) -> Iterable[Evidence]:
        for name in row.katas:
            if name in here:
                yield _of_kata(name, record.standings.get(name, Standing()))
        for name in row.skills:
            if name in skills:
                yield _of_skill(skills[name])
        for card in of_row.get(row.id, ()):
            yield _of_card(row, card, answered.get(card.key, ()))
        for name in row.broken:
            problem, mistake = name.split("/")
            if name in record.broken or (breaking and problem in here):
                yield Evidence(Kind.BROKEN, name, f"judge hack {problem} {mistake}", record.broken.get(name))

    return [RowProgress(row, tuple(evidence(row))) for row in rows]


def _of_kata(name: str, standing: Standing) -> Evidence:
    return Evidence(Kind.KATA, name, f"judge init {name}", standing.passed)


def _of_skill(progress: SkillProgress) -> Evidence:
    open_ = [each for each in progress.needs if each.since is None or each.lost] or progress.needs
    lost = progress.state is SkillState.LOST
    return Evidence(
        Kind.SKILL, progress.skill.name, f"judge init {open_[0].need.problem}", progress.since, lost
    )


def _of_card(row: Row, card: Card, answers: Sequence[Answer]) -> Evidence:
    known = [answer for answer in answers if answer.known]
    lost = bool(known) and not answers[-1].known
    return Evidence(Kind.CARD, card.key, f"judge quiz --row {row.id}", known[0].when if known else None, lost)


def in_set(checklist: Checklist, name: str, every: str) -> Checklist:
    """The sections that belong to a practice set, with their rows; all of them for the set `every`."""
    kept = [each for each in checklist.sections if name == every or name in each.sets]
    names = {each.id for each in kept}
    return Checklist(tuple(kept), tuple(row for row in checklist.rows if row.section in names))


def by_section(checklist: Checklist, rows: Sequence[RowProgress]) -> list[tuple[Section, list[RowProgress]]]:
    """The sections that have rows, each with its own."""
    found = [
        (section, [each for each in rows if each.row.section == section.id]) for section in checklist.sections
    ]
    return [(section, own) for section, own in found if own]
