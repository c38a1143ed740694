"""Finding katas: by name, or the one that a file solves.

Looked at in this order, and the first problem of a name wins:

    --problems DIR           the caller's own folders
    $JUDGE_PROBLEMS          more of them, separated as in $PATH
    judge/problems           shipped inside the installed package, or
    problems beside judge/   where there is none: a checkout
    entry points             group `judge.problems`: installed packs, looked up only on a miss or for a list

The solutions to a folder of problems are in the folder `solutions` beside it.

Which problem a file is meant to solve is told from its text: neither it nor any problem.py is run. Asked in
this order, until exactly one problem is left:

    the functions that the file defines at its top level: a problem's entry
    the line that a stub begins with (`count: …`), or the file's name (count.py)
    a function inside a class or another function, which the verdict then says to move out

In another language than Python only the first two are looked at, by that language's own patterns. The text is
searched and not parsed: a file that does not compile has its problem too, and no text, however it was made,
takes longer than reading it.
"""

from __future__ import annotations

import os
import re
import shlex
import sys
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from functools import cache, partial
from itertools import groupby
from operator import attrgetter
from pathlib import Path, PurePath
from typing import TypeVar

from msgspec import Struct

from judge.errors import ProblemError, UnknownKataError, UsageError, nearest, printable
from judge.problem.load import Shelf, load_problem
from judge.problem.model import Listed, Problem, Tier

P = TypeVar("P", bound=Listed)
_PACKAGE = Path(__file__).resolve().parent.parent
_VARIABLE = "JUDGE_PROBLEMS"
_ENTRY_POINTS = "judge.problems"
_MARKS = ("problem.toml", "problem.py", "statement.md")  # a problem's folder holds at least one
_READ = 2**20  # characters of a file that are looked at
_MOST_NAMES = 200  # of functions, one of which may be meant
_DOCSTRING = r"(?:#[^\n]*\n\s*)*[rR]?(?:\"\"\"|''')"
_TOP = r"(?m)^(?:async[ \t]+def|def|class)[ \t]+(\w+)|^(\w+)[ \t]*(?::[^=\n]*)?=(?!=)"
_NESTED = r"(?m)^[ \t]+(?:async[ \t]+)?def[ \t]+(\w+)"


def find_problem(name: str, extra: Sequence[Path] = ()) -> Problem:
    """The problem of that name; `extra` are folders of problems to look in first.

    Raises UnknownKataError if there is none and ProblemError if it is broken.
    """
    found: dict[str, Path] = {}
    for installed in (False, True):
        found = {folder.name: folder for folder in problem_folders(extra, installed=installed)}
        if name in found:
            return load_problem(found[name])
    meant = nearest(name, found)
    remedy = f"did you mean {meant!r}?" if meant else f"'judge list' shows all {len(found)}"
    raise UnknownKataError(name, remedy)


def sound_problems(extra: Sequence[Path] = ()) -> tuple[list[Problem], list[ProblemError]]:
    """Every problem that can be read, easiest first, and the fault of each that cannot.

    The order is that of the tiers, in a tier that of the problems' places, and then of their names.
    """
    return listed_problems(extra, Problem)


def listed_problems(extra: Sequence[Path], kind: type[P]) -> tuple[list[P], list[ProblemError]]:
    """The same, as much of each problem as `kind` has."""
    problems, faults = [], []
    for root, folders in groupby(problem_folders(extra), attrgetter("parent")):
        shelf = Shelf(root)
        for folder in folders:
            try:
                problems.append(shelf.problem(folder, kind))
            except ProblemError as fault:
                faults.append(fault)
        shelf.keep()
    tiers = list(Tier)
    return sorted(problems, key=lambda each: (tiers.index(each.tier), each.place, each.id)), faults


def typed(problem: Problem) -> str:
    """The problem as words of a command: with its folder, unless it is found without."""
    if problem.folder in problem_folders(installed=False):
        return problem.id
    folder = problem.folder.parent
    with suppress(ValueError, OSError):
        folder = folder.relative_to(Path.cwd())
    return f"{problem.id} --problems {shlex.quote(str(folder))}"


# -- folders -----------------------------------------------------------------------------------------------


def problem_folders(extra: Sequence[Path] = (), *, installed: bool = True) -> list[Path]:
    """The folder of every problem that can be found, one of each name, none of them read yet.

    Looking up the `installed` packs takes time: leave them out where what is wanted was found without.
    Raises as find_problem does.
    """
    return _folders(problem_roots(extra, installed=installed))


def folders_within(named: Sequence[Path]) -> list[Path]:
    """The problems' folders in the folders that a person names, and nowhere else. Raises UsageError."""
    return _folders([_root(folder, "--problems") for folder in named])


def _folders(roots: Sequence[Path]) -> list[Path]:
    """The problems' folders in `roots`, one of each name."""
    found: dict[str, Path] = {}
    for root in roots:
        try:
            for name in sorted(os.listdir(root)):  # noqa: PTH208 - of many
                if any(os.path.isfile(f"{root}/{name}/{mark}") for mark in _MARKS):  # noqa: PTH113
                    found.setdefault(name, root / name)
        except OSError as error:
            what, remedy = f"the folder cannot be read: {error.strerror}", "make it readable, or name another"
            raise UsageError(what, where=str(root), remedy=remedy) from None
    return list(found.values())


def problem_roots(extra: Sequence[Path] = (), *, installed: bool = True) -> list[Path]:
    """The folders of problems that are looked in, in their order. Raises as find_problem does."""
    roots = [_root(folder, "--problems") for folder in extra]
    parts = os.environ.get(_VARIABLE, "").split(os.pathsep)
    roots += [_root(Path(part), f"${_VARIABLE}") for part in parts if part]
    roots += filter(None, [shipped_problems()])
    return roots + _installed_roots() if installed else roots


def _root(folder: Path, source: str) -> Path:
    """The folder from the root. Raises UnknownKataError if there is none of that name."""
    with suppress(OSError, ValueError):  # no name at all: too long, with a NUL; or the current folder is gone
        if folder.is_dir():
            return folder.resolve()
    what = f"{printable(str(folder))} is not a folder"
    raise UsageError(what, where=source, remedy="name a folder that holds problems' folders")


def shipped_problems() -> Path | None:
    """The folder of the judge's own problems, if it has any."""
    # Beside an installed package is site-packages, where a folder "problems" would be anybody's.
    places = (_PACKAGE / "problems", _PACKAGE.parent / "problems")
    return next((root for root in places if root.is_dir()), None)


def _installed_roots() -> list[Path]:
    """The folders of the packs that other distributions install.

    An entry point names a package whose folder holds the problems' folders, or a path to such a folder.
    """
    if not _may_be_installed(tuple(sys.path)):
        return []
    from importlib.metadata import entry_points  # slow to import, and seldom wanted

    roots = []
    for point in entry_points(group=_ENTRY_POINTS):
        try:
            pack = point.load()
            root = Path(pack if isinstance(pack, str | Path) else pack.__path__[0])
            if not root.is_dir():
                raise NotADirectoryError(f"{root} is not a folder")
        except (Exception, SystemExit) as error:  # foreign code: whatever it raises is one clear line
            what = f"the pack {point.name!r} cannot be loaded: {type(error).__name__}: {error}"
            where = f"entry point {point.value}"
            raise ProblemError(what, where=where, remedy="repair or uninstall it") from error
        roots.append(root.resolve())
    return roots


@cache
def _may_be_installed(places: tuple[str, ...]) -> bool:
    """Whether a distribution there speaks of packs; seen without importlib.metadata, which is slow."""
    for place in dict.fromkeys(places):
        with suppress(OSError):
            for name in os.listdir(place or "."):  # noqa: PTH208 - of hundreds
                with suppress(OSError):
                    told = f"{place or '.'}/{name}/entry_points.txt"
                    if name.endswith("-info") and _ENTRY_POINTS.encode() in Path(told).read_bytes():
                        return True
    return False


# -- the problem of a file ---------------------------------------------------------------------------------


class Signs(Struct, frozen=True):
    """What of a file tells its problem."""

    file: str  # its name
    hints: tuple[str, str]  # the id in the first line of a stub, or nothing; the id that the name stands for
    has: Callable[[str], object]  # whether it defines such an entry where it is called
    defined: frozenset[str] = frozenset()  # in Python: at its top level
    nested: frozenset[str] = frozenset()  # functions below it


def signs(source: bytes, name: str) -> Signs:
    """The signs of a file with this text and name. Raises JudgeError as `judge.languages.scan.reading`."""
    from judge.languages import language_of
    from judge.languages.scan import reading, stripped, usual_tokens

    with reading(name):
        text = source[:_READ].decode("utf-8", "replace").replace("\r\n", "\n").removeprefix("\ufeff")
        language = language_of(name)
        begins = re.escape(language.comment) if language else _DOCSTRING
        stub = re.match(rf"\s*{begins}\s*([a-z][a-z0-9-]*): ", text)
        hints = stub[1] if stub else "", id_of(PurePath(name).name.partition(".")[0])
        bare = stripped(text.encode(), language.tokens if language else usual_tokens("#"))
        if language:
            from judge.languages.sources import defined

            return Signs(name, hints, partial(defined, language, bare))
        tops = frozenset(one or other for one, other in re.findall(_TOP, bare))
        return Signs(name, hints, tops.__contains__, tops, frozenset(re.findall(_NESTED, bare)))


def id_of(stem: str) -> str:
    """The problem that a file or folder of this name, without its ending, is called like."""
    return stem.lower().replace("_", "-")


def fitting_problems(found: Signs, extra: Sequence[Path] = ()) -> list[Problem]:
    """The problems that the signs fit equally well: none, one or several; `extra` folders come first.

    Installed packs are searched only where no nearer problem fits, or the stub's line names none of them.
    Raises as `find_problem` does, and JudgeError where the text takes too long to read.
    """
    from judge.languages.scan import reading

    with reading(found.file):
        near = _entries(problem_folders(extra, installed=False))
        fitting, (stub, _) = _fitting(found, near), found.hints
        if not fitting or (stub and stub not in [folder.name for folder in near]):
            fitting = _fitting(found, _entries(problem_folders(extra)))
    return [load_problem(folder) for folder in fitting]


def meant_problem(found: Signs, extra: Sequence[Path] = ()) -> tuple[str, str, str] | None:
    """The function of the file that may be meant as an entry, the entry, and its problem; or None."""
    entries = _entries(problem_folders(extra, installed=False))
    names = {entry: folder.name for folder, entry in entries.items()}
    for name in sorted(found.defined | found.nested)[:_MOST_NAMES]:
        if entry := nearest(name, names):
            return name, entry, names[entry]
    return None


def _fitting(found: Signs, entries: dict[Path, str]) -> list[Path]:
    hinted = [folder for name in found.hints for folder in entries if folder.name == name]
    for has in (found.has, found.nested.__contains__):
        fitting = [folder for folder, entry in entries.items() if has(entry)]
        if fitting:  # of several the stub's line or the file's name says which
            return [folder for folder in hinted if folder in fitting][:1] or fitting
        if hinted:
            return hinted[:1]
    return []


def _entries(folders: Iterable[Path]) -> dict[Path, str]:
    """The entry function of each problem, as its problem.toml seems to have it."""
    entry = re.compile(r"""(?m)^[ \t]*["']?entry["']?[ \t]*=[ \t]*["'](\w+)["']""")
    entries: dict[Path, str] = {}
    for folder in folders:
        with suppress(OSError):  # whoever asks for this one is told
            found = entry.search((folder / "problem.toml").read_text(encoding="utf-8", errors="replace"))
            if found:
                entries[folder] = found[1]
    return entries
