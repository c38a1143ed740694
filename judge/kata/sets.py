"""Practice sets: katas in the order in which to take them up, one file each beside the problems.

problems/sets/middle.toml
    title = "Middle"
    about = "One sentence for the list of sets."
    problems = ["count", "exact-count"]
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from msgspec import Struct

from judge.errors import UsageError
from judge.kata.tables import Table, unlike_any
from judge.problem.find import problem_folders, problem_roots

USUAL = "path"  # the set that stands for all of them in order

_ORDER = ("junior", "middle", "senior", "professional")  # as the problems' tiers; others after them, by name


class PracticeSet(Struct, frozen=True):
    """Problems to practise, in order; `name` is the file's."""

    name: str
    title: str
    about: str
    problems: tuple[str, ...]


class _SetTable(Struct, forbid_unknown_fields=True, frozen=True):
    title: str
    about: str
    problems: list[str]


def find_set(name: str, extra: Sequence[Path] = ()) -> PracticeSet:
    """The set of that name; `extra` are folders of problems to look in first.

    Raises:
        UsageError: there is none of that name.
        ProblemError: it is broken.
    """
    files = _files(problem_roots(extra, installed=False))
    if name not in files:
        files = _files(problem_roots(extra))
    if name not in files:
        raise UsageError(f"no practice set is called {name!r}", remedy=unlike_any(name, list(files)))
    return _load(files[name], extra)


def set_names(extra: Sequence[Path] = ()) -> list[str]:
    """The names of all sets, easiest first; none of them is read."""
    return list(_files(problem_roots(extra)))


def _files(roots: Iterable[Path]) -> dict[str, Path]:
    found: dict[str, Path] = {}
    for root in roots:
        for path in sorted((root / "sets").glob("*.toml")):
            found.setdefault(path.stem, path)
    return dict(sorted(found.items(), key=lambda item: _place(item[0])))


def _place(name: str) -> tuple[int, str]:
    return (_ORDER.index(name) if name in _ORDER else len(_ORDER), name)


def _load(path: Path, extra: Sequence[Path]) -> PracticeSet:
    file = Table(path)
    table = file.read(_SetTable)
    if not table.problems:
        raise file.fault("the set holds no problem", "name at least one", "problems")
    for place, name in enumerate(table.problems):
        if name not in _beside(path) and name not in (known := _all(extra)):
            what = f"no problem is called {name!r}"
            raise file.fault(what, unlike_any(name, known), "problems", place)
        if name in table.problems[:place]:
            raise file.fault(f"{name!r} is listed twice", "take one out", "problems", place)
    return PracticeSet(path.stem, table.title, table.about, tuple(table.problems))


def _beside(path: Path) -> list[str]:
    """The folders beside the folder of sets: nearly always the problems that a set is made of."""
    return [folder.name for folder in path.parent.parent.iterdir() if (folder / "problem.toml").is_file()]


def _all(extra: Sequence[Path]) -> list[str]:
    return [folder.name for folder in problem_folders(extra)]
