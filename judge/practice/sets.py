"""Practice sets: katas in the order in which to take them up.

A set's file beside the problems says what it is, and each problem names the sets that it is in:

    problems/sets/middle.toml          title = "Middle"
                                       about = "One sentence for the list of sets."
    problems/count/problem.toml        sets = ["middle", "path"]

A file may list its `problems` itself, in an order of its own: then the set is made of these.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Generic, TypeVar

import msgspec
from msgspec import Struct

from judge.cache import DISK, digest, stamp
from judge.errors import ProblemError, UsageError
from judge.problem import Problem, Tier
from judge.problem.find import find_problem, problem_roots, sound_problems
from judge.problem.model import Listed

if TYPE_CHECKING:
    from judge.problem.toml import TomlFile

P = TypeVar("P", bound=Listed)
USUAL = "path"  # the set that stands for all of them in order

FIRST = "first-steps"  # the set that a newcomer begins with

_ORDER = [FIRST, *(tier.value for tier in Tier)]  # sets of these names come first; others after them, by name


class PracticeSet(Struct, Generic[P], frozen=True):
    """Problems to practise, in order; `name` is the file's.

    `faults` are of problems that may belong to it: one that cannot be read, a name that no set has.
    """

    name: str
    title: str
    about: str
    problems: tuple[P, ...]
    faults: tuple[ProblemError, ...] = ()


class _SetTable(Struct, forbid_unknown_fields=True, frozen=True):
    title: str
    about: str
    problems: list[str] | None = None


def find_set(name: str, extra: Sequence[Path] = ()) -> PracticeSet[Problem]:
    """The set of that name; `extra` are folders of problems to look in first.

    Raises:
        UsageError: there is none of that name.
        ProblemError: its file is broken, or it has no problem.
    """
    from judge.problem.toml import TomlFile, meant

    files = _files(extra)
    if name not in files:
        raise UsageError(f"no practice set is called {name!r}", remedy=meant(name, list(files)))
    file = TomlFile(files[name])
    table = file.read(_SetTable)
    faults: list[ProblemError] = []
    if table.problems is not None:
        members = _listed(file, table.problems, extra)
    else:
        problems, faults = sound_problems(extra)
        faults += [fault for problem in problems for fault in unknown_sets(problem, list(files))]
        members = [problem for problem in problems if name in problem.sets]
    if not members:
        fault = file.fault("the set holds no problem", f"name {name!r} in the sets of a problem.toml")
        raise next(iter(faults), fault)
    return PracticeSet(name, table.title, table.about, tuple(members), tuple(faults))


def sound_sets(
    problems: Iterable[P], extra: Sequence[Path] = ()
) -> tuple[list[PracticeSet[P]], list[ProblemError]]:
    """Every set of these problems, easiest first, and the fault of each that cannot be read."""
    by_name = {problem.id: problem for problem in problems}
    found = []
    tables, faults = _tables(_files(problem_roots(extra)))
    for name, table in tables.items():
        listed = [each.id for each in by_name.values() if name in each.sets]
        members = [by_name[each] for each in table.problems or listed if each in by_name]
        found.append(PracticeSet(name, table.title, table.about, tuple(members)))
    return found, faults


def _tables(files: Mapping[str, Path]) -> tuple[dict[str, _SetTable], list[ProblemError]]:
    """What the files say, from the cache while none of them changes; and the fault of each that is broken."""
    paths = [os.fspath(path) for path in files.values()]
    store, key = DISK, stamp(paths)
    name = f"sets/{digest(os.fsencode('/'.join(paths)))[:16]}"
    found = store.read(name, key, dict[str, _SetTable]) if key else None
    if found is not None:
        return found, []
    from judge.problem.toml import TomlFile  # not for who reads the cache

    tables: dict[str, _SetTable] = {}
    faults = []
    for each, path in files.items():
        try:
            tables[each] = TomlFile(path).read(_SetTable)
        except ProblemError as fault:
            faults.append(fault)
    if key and not faults:
        store.write(name, key, msgspec.json.encode(tables))
    return tables, faults


def set_names(extra: Sequence[Path] = ()) -> list[str]:
    """The names of all sets, easiest first; none of them is read."""
    return list(_files(extra))


def unknown_sets(problem: Problem, names: Sequence[str]) -> Iterator[ProblemError]:
    """A fault for each set that the problem names and that is none of `names`."""
    from judge.problem.toml import key_place, meant

    for at, name in enumerate(problem.sets):
        if name not in names:
            remedy = f"{meant(name, names)}; a new one needs a file sets/{name}.toml"
            what = f"no practice set is called {name!r}"
            yield ProblemError(what, where=key_place(problem, ("sets", at)), remedy=remedy)


def _files(extra: Sequence[Path]) -> dict[str, Path]:
    """The sets' files by name: the usual ones in their order, then others by name."""
    found: dict[str, Path] = {}
    for root in problem_roots(extra):
        for path in sorted((root / "sets").glob("*.toml")):
            found.setdefault(path.stem, path)
    names = sorted(found, key=lambda name: (_ORDER.index(name) if name in _ORDER else len(_ORDER), name))
    return {name: found[name] for name in names}


def _listed(file: TomlFile, names: Sequence[str], extra: Sequence[Path]) -> list[Problem]:
    """The problems that a set's file lists itself."""
    found: list[Problem] = []
    for place, name in enumerate(names):
        if name in names[:place]:
            raise file.fault(f"{name!r} is listed twice", "take one out", "problems", place)
        try:
            found.append(find_problem(name, extra))
        except UsageError as fault:
            raise file.fault(fault.what, fault.remedy or "", "problems", place) from None
    return found
