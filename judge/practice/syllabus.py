"""What there is to learn, in the folders of problems: practice sets, skills, and a checklist of questions.

    problems/pack.toml                 title = "Circle and line geometry"
                                       about = "One sentence for the list of katas."

    problems/sets/middle.toml          title = "Middle"
                                       about = "One sentence for the list of sets."
    problems/count/problem.toml        sets = ["middle", "path"]

    problems/skills.toml               [[skills]]
                                       name = "far from the origin"
                                       about = "Subtract first: large squares drown small numbers."
    problems/count/problem.py          group("offset", …, skills="far from the origin")

    problems/checklist.toml            [[sections]]
                                       id = "junior"
                                       title = "Junior questions"
                                       sets = ["junior"]
                                       [[rows]]
                                       id = "J3"
                                       section = "junior"
                                       ask = "How far is a point from the line through A and B?"
                                       katas = ["distance"]

The katas of a set are in the order in which to take them up. A set's file may list its `problems` itself, in
an order of its own. `judge.practice.progress` says when a skill is shown and what ticks a row.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from pathlib import Path
from typing import Generic, TypeVar

from msgspec import Struct

from judge.errors import ProblemError, UsageError, meant, nearest
from judge.problem import Problem, Tier
from judge.problem.find import find_problem, problem_folders, problem_roots
from judge.problem.model import FIRST, Listed
from judge.problem.toml import TomlFile, key_place

P = TypeVar("P", bound=Listed)
USUAL = "path"  # the set that stands for all of them in order
SETS = [FIRST, *(tier.value for tier in Tier)]  # sets of these names come first; others after them, by name


class PracticeSet(Struct, Generic[P], frozen=True):
    """Problems to practise, in order; `name` is the file's."""

    name: str
    title: str
    about: str
    problems: tuple[P, ...]


class Table(Struct, frozen=True, forbid_unknown_fields=True):
    """A table of a TOML file."""


class Pack(Table, frozen=True):
    """What a folder of problems says of itself."""

    title: str
    about: str = ""


class Skill(Table, frozen=True):
    """Something to be able to do, as a person would tick it off; those of a `topic` are drilled together."""

    name: str
    about: str
    topic: str = ""


class Section(Table, frozen=True):
    """A part of the checklist; the first of all is what a person ticks off before an interview."""

    id: str
    title: str
    sets: tuple[str, ...] = ()


class ChecklistRow(Table, frozen=True):
    """One question, and what ticks it; `broken` names mistakes, as "count/no-clamp"."""

    id: str
    section: str
    ask: str
    katas: tuple[str, ...] = ()
    skills: tuple[str, ...] = ()
    broken: tuple[str, ...] = ()


class Checklist(Table, frozen=True):
    """Skills, sections and rows, in their order: those of a file, or of all of them."""

    skills: tuple[Skill, ...] = ()
    sections: tuple[Section, ...] = ()
    rows: tuple[ChecklistRow, ...] = ()

    def drilled(self) -> dict[str, str]:
        """The topic of each mistake that is broken by a question of that topic alone."""
        topics, found = {each.name: each.topic for each in self.skills}, dict[str, str]()
        for row in self.rows:
            own = {topics.get(each, "") for each in row.skills}
            if len(own) == 1 and (topic := own.pop()):
                found |= {each.partition("/")[2]: topic for each in row.broken}
        return found

    def topics(self, skills: Collection[str]) -> tuple[str, ...]:
        """The topics of those skills, in their order."""
        return tuple(dict.fromkeys(each.topic for each in self.skills if each.topic and each.name in skills))


class _SetTable(Table, frozen=True):
    title: str
    about: str
    problems: tuple[str, ...] = ()


# -- sets --------------------------------------------------------------------------------------------------


def find_set(name: str, problems: Sequence[P], extra: Sequence[Path] = ()) -> PracticeSet[P]:
    """The set of that name among these problems, which are all; `extra` are folders to look in first.

    Raises:
        UsageError: there is none of that name.
        ProblemError: its file, or a problem that it lists, is broken, or it has no problem.
    """
    files = set_files(extra)
    if name not in files:
        raise UsageError(f"no practice set is called {name!r}", remedy=meant(name, list(files)))
    file = TomlFile(files[name])
    table = file.read(_SetTable)
    refuse_doubles(file, table.problems, "problems")
    katas = [folder.name for folder in problem_folders(extra)]
    refuse_unknown(file, table.problems, katas, "no kata is called", "problems")
    for each in table.problems:
        find_problem(each, extra)  # a broken one says so
    found = _set_of(name, table, problems)
    if not found.problems:
        raise file.fault("the set has no kata", f"name {name!r} in the sets of a problem.toml")
    return found


def read_pack(root: Path) -> Pack:
    """What is said of a folder of problems; without a pack.toml it has the name of its folder.

    Raises ProblemError.
    """
    if (path := root / "pack.toml").is_file():
        return TomlFile(path).read(Pack)
    return Pack(root.parent.name if root.name == "problems" else root.name)


def sound_sets(
    problems: Sequence[P], extra: Sequence[Path] = ()
) -> tuple[list[PracticeSet[P]], list[ProblemError]]:
    """Every set of these problems, easiest first, and the fault of each that cannot be read."""
    found, faults = list[PracticeSet[P]](), list[ProblemError]()
    for name, path in set_files(extra).items():
        try:
            found.append(_set_of(name, TomlFile(path).read(_SetTable), problems))
        except ProblemError as fault:
            faults.append(fault)
    return found, faults


def _set_of(name: str, table: _SetTable, problems: Sequence[P]) -> PracticeSet[P]:
    """The set of those that name it, or of those that its file lists."""
    here = {each.id: each for each in problems}
    names = table.problems or [each.id for each in problems if name in each.sets]
    return PracticeSet(name, table.title, table.about, tuple(here[each] for each in names if each in here))


def first_sets(sets: Sequence[PracticeSet[P]]) -> dict[str, str]:
    """The first set of each kata, in which it counts; the whole path is none."""
    rows = ((each.name, kata.id) for each in reversed(sets) if each.name != USUAL for kata in each.problems)
    return {kata: name for name, kata in rows}


def set_files(extra: Sequence[Path] = ()) -> dict[str, Path]:
    """The sets' files by name: the usual ones in their order, easiest first, then others by name."""
    return toml_files("sets", SETS, extra)


def toml_files(folder: str, order: Sequence[str], extra: Sequence[Path]) -> dict[str, Path]:
    """The files in a folder of each folder of problems, by name, one of each: those in `order` come first."""
    found: dict[str, Path] = {}
    for root in problem_roots(extra):
        for path in (root / folder).glob("*.toml"):
            found.setdefault(path.stem, path)
    return {name: found[name] for name in (*filter(found.get, order), *sorted(found.keys() - set(order)))}


# -- skills and questions ----------------------------------------------------------------------------------


def read_checklist(extra: Sequence[Path] = ()) -> Checklist:
    """What every folder's files list, each name once; the first of a name wins. Raises ProblemError."""
    skills: dict[str, Skill] = {}
    sections: dict[str, Section] = {}
    rows: dict[str, ChecklistRow] = {}
    paths = [root / name for root in problem_roots(extra) for name in ("skills.toml", "checklist.toml")]
    for file in (TomlFile(path) for path in paths if path.is_file()):
        table = file.read(Checklist)
        refuse_doubles(file, [skill.name for skill in table.skills], "skills", "name")
        refuse_doubles(file, [row.id for row in table.rows], "rows", "id")
        for skill in table.skills:
            skills.setdefault(skill.name, skill)
        for section in table.sections:
            sections.setdefault(section.id, section)
        known = list(sections)
        for place, row in enumerate(table.rows):
            refuse_unknown(file, [row.section], known, "no section is called", "rows", place, "section")
            for at, mistake in enumerate(row.broken):
                if mistake.count("/") != 1:
                    what = f"{mistake!r} does not name a mistake"
                    raise file.fault(what, 'write "problem/mistake"', "rows", place, "broken", at)
            rows.setdefault(row.id, row)
    return Checklist(tuple(skills.values()), tuple(sections.values()), tuple(rows.values()))


def find_row(name: str, rows: Iterable[ChecklistRow]) -> ChecklistRow:
    """The row of that id, in any case. Raises UsageError where there is none."""
    known = {row.id.upper(): row for row in rows}
    if found := known.get(name.upper()):
        return found
    remedy = meant(name.upper(), [row.id for row in known.values()], "they are")
    raise UsageError(f"there is no question {name!r}", remedy=remedy)


def unknown_names(problems: Iterable[Problem], extra: Sequence[Path] = ()) -> Iterator[ProblemError]:
    """A fault for each set and skill that a problem names and no file does. Raises as read_checklist."""
    sets, skills = list(set_files(extra)), [skill.name for skill in read_checklist(extra).skills]
    for problem in problems:
        for at, name in enumerate(problem.sets):
            if name not in sets:
                remedy = f"{meant(name, sets)}; a new one needs a file sets/{name}.toml"
                where = key_place(problem, ("sets", at))
                yield ProblemError(f"no practice set is called {name!r}", where=where, remedy=remedy)
        for shown in problem.skills:
            if shown.name not in skills:
                near = nearest(shown.name, skills)
                remedy = f"did you mean {near!r}?" if near else "explain it in skills.toml"
                shown_by = next(each for each in problem.groups if shown.name in each.skills)
                yield problem.fault(f"no skill is called {shown.name!r}", remedy, shown_by.line)


def refuse_doubles(file: TomlFile, names: Sequence[str], table: str, *key: str) -> None:
    """Raise a ProblemError for the first name of a list in the file that is there for the second time."""
    for place, name in enumerate(names):
        if name in names[:place]:
            raise file.fault(f"{name!r} is there twice", "take one out", table, place, *key)


def refuse_unknown(
    file: TomlFile, names: Iterable[str], known: Sequence[str], said: str, *path: str | int
) -> None:
    """Raise a ProblemError for the first name of a list in the file that is not known."""
    for at, name in enumerate(names):
        if name not in known:
            raise file.fault(f"{said} {name!r}", meant(name, known), *path, at)
