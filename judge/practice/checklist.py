"""What there is to learn: skills, and the questions of a checklist; two files in a folder of problems.

    problems/skills.toml            [[skills]]
                                    name = "far from the origin"
                                    about = "Subtract first: the square of a large number drowns a small one."
    problems/count/problem.py       group("offset", …, skills="far from the origin")

    problems/checklist.toml         [[sections]]
                                    id = "junior"
                                    title = "Junior questions"
                                    sets = ["junior"]
                                    [[rows]]
                                    id = "J3"
                                    section = "junior"
                                    ask = "How far is a point from the line through A and B?"
                                    katas = ["distance"]

`judge.practice.progress` says when a skill is shown and what ticks a row.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from msgspec import Struct

from judge.errors import ProblemError, UsageError, nearest
from judge.problem import Problem
from judge.problem.find import problem_roots
from judge.problem.model import group_place
from judge.problem.toml import TomlFile, meant

_SKILLS, _ROWS = "skills.toml", "checklist.toml"


class Skill(Struct, frozen=True, forbid_unknown_fields=True):
    """Something to be able to do, as a person would tick it off."""

    name: str
    about: str


class Section(Struct, frozen=True, forbid_unknown_fields=True):
    """A part of the checklist; the first of all is what a person ticks off before an interview."""

    id: str
    title: str
    sets: tuple[str, ...] = ()


class Row(Struct, frozen=True, forbid_unknown_fields=True):
    """One question, and what ticks it; `broken` names mistakes, as "count/no-clamp"."""

    id: str
    section: str
    ask: str
    katas: tuple[str, ...] = ()
    skills: tuple[str, ...] = ()
    broken: tuple[str, ...] = ()


class Checklist(Struct, frozen=True):
    """All skills, sections and rows, in their order."""

    skills: tuple[Skill, ...] = ()
    sections: tuple[Section, ...] = ()
    rows: tuple[Row, ...] = ()


class _SkillsTable(Struct, forbid_unknown_fields=True, frozen=True):
    skills: list[Skill]


class _RowsTable(Struct, forbid_unknown_fields=True, frozen=True):
    sections: list[Section]
    rows: list[Row]


def read_checklist(extra: Sequence[Path] = ()) -> Checklist:
    """What every folder's files list, each name once; the first of a name wins. Raises ProblemError."""
    sections: dict[str, Section] = {}
    rows: dict[str, Row] = {}
    for root in problem_roots(extra):
        if not (root / _ROWS).is_file():
            continue
        file = TomlFile(root / _ROWS)
        table = file.read(_RowsTable)
        for section in table.sections:
            sections.setdefault(section.id, section)
        _refuse_doubles(file, "rows", "id", [row.id for row in table.rows])
        for place, row in enumerate(table.rows):
            if row.section not in sections:
                what, remedy = f"no section is called {row.section!r}", meant(row.section, list(sections))
                raise file.fault(what, remedy, "rows", place, "section")
            for at, mistake in enumerate(row.broken):
                if len(mistake.split("/")) != 2:
                    what = f"{mistake!r} does not name a mistake"
                    raise file.fault(what, 'write "problem/mistake"', "rows", place, "broken", at)
            rows.setdefault(row.id, row)
    return Checklist(tuple(_skills(extra)), tuple(sections.values()), tuple(rows.values()))


def find_row(name: str, rows: Iterable[Row]) -> Row:
    """The row of that id, in any case. Raises UsageError where there is none."""
    known = {row.id.upper(): row for row in rows}
    if name.upper() in known:
        return known[name.upper()]
    near = nearest(name.upper(), known)
    remedy = f"did you mean {near!r}? " if near else ""
    raise UsageError(f"there is no question {name!r}", remedy=f"{remedy}'judge progress --all' lists them")


def unknown_skills(problems: Iterable[Problem], extra: Sequence[Path] = ()) -> Iterator[ProblemError]:
    """A fault for each skill that a problem names and that no file explains. Raises as read_checklist."""
    known = [skill.name for skill in _skills(extra)]
    for problem in problems:
        for shown in problem.skills:
            if shown.name not in known:
                near = nearest(shown.name, known)
                yield ProblemError(
                    f"no skill is called {shown.name!r}",
                    where=group_place(problem, shown.groups[0]),
                    remedy=f"did you mean {near!r}?" if near else f"explain it in {_SKILLS}",
                )


def _skills(extra: Sequence[Path]) -> list[Skill]:
    found: dict[str, Skill] = {}
    for root in problem_roots(extra):
        if (root / _SKILLS).is_file():
            file = TomlFile(root / _SKILLS)
            skills = file.read(_SkillsTable).skills
            _refuse_doubles(file, "skills", "name", [skill.name for skill in skills])
            for skill in skills:
                found.setdefault(skill.name, skill)
    return list(found.values())


def _refuse_doubles(file: TomlFile, table: str, key: str, names: Sequence[str]) -> None:
    for place, name in enumerate(names):
        if name in names[:place]:
            raise file.fault(f"{name!r} is there twice", "take one out", table, place, key)
