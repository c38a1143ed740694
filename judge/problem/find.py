"""Where problems live, and finding one by its name.

Looked at in this order, and the first problem of a name wins:

    --problems DIR           the caller's own folders
    $JUDGE_PROBLEMS          more of them, separated as in $PATH
    judge/problems           shipped inside the installed package, or
    problems beside judge/   where there is none: a checkout
    entry points             group `judge.problems`: installed packs, looked up only on a miss or for a list

The solutions to a folder of problems are in the folder `solutions` beside it.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from judge.errors import ProblemError, UsageError, nearest
from judge.problem.load import load_problem
from judge.problem.model import Problem, Tier

_TIERS = list(Tier)
_PACKAGE = Path(__file__).resolve().parent.parent
_VARIABLE = "JUDGE_PROBLEMS"
_ENTRY_POINTS = "judge.problems"
_FEW = 8  # problems that a message may name


def find_problem(name: str, extra: Sequence[Path] = ()) -> Problem:
    """The problem of that name; `extra` are folders of problems to look in first.

    Raises UsageError if there is none and ProblemError if it is broken.
    """
    for folder in near_problem_folders(extra):
        if folder.name == name:
            return load_problem(folder)
    folders = problem_folders(extra)
    for folder in folders:
        if folder.name == name:
            return load_problem(folder)
    names = [folder.name for folder in folders]
    meant = nearest(name, names)
    known = f"there are {', '.join(names) or 'none at all'}"
    if len(names) > _FEW:
        known = f"'judge list' shows all {len(names)}"
    remedy = f"did you mean {meant!r}?" if meant else known
    raise UsageError(f"no problem is called {name!r}", remedy=remedy)


def all_problems(extra: Sequence[Path] = ()) -> list[Problem]:
    """Every problem that can be found, easiest first. Raises as find_problem does."""
    problems, faults = sound_problems(extra)
    for fault in faults:
        raise fault
    return problems


def sound_problems(extra: Sequence[Path] = ()) -> tuple[list[Problem], list[ProblemError]]:
    """Every problem that can be read, easiest first, and the fault of each that cannot.

    The order is that of the tiers, in a tier that of the problems' places, and then of their names.
    """
    problems, faults = [], []
    for folder in problem_folders(extra):
        try:
            problems.append(load_problem(folder))
        except ProblemError as fault:
            faults.append(fault)
    return sorted(problems, key=_order), faults


def _order(problem: Problem) -> tuple[int, bool, int, str]:
    return _TIERS.index(problem.tier), problem.place is None, problem.place or 0, problem.id


def problem_folders(extra: Sequence[Path] = ()) -> list[Path]:
    """The folder of every problem that can be found, one of each name, none of them read yet."""
    found: dict[str, Path] = {}
    for folder in _folders(problem_roots(extra)):
        found.setdefault(folder.name, folder)
    return list(found.values())


def folders_within(named: Sequence[Path]) -> list[Path]:
    """The problems' folders in the folders that a person names, and nowhere else. Raises UsageError."""
    return _folders([_root(folder, "--problems") for folder in named])


def problem_roots(extra: Sequence[Path] = (), *, installed: bool = True) -> list[Path]:
    """The folders of problems that are looked in, in their order. Raises as find_problem does.

    Looking up the installed packs takes time: leave them out where what is wanted was found without.
    """
    return [*_near_roots(extra), *(_installed_roots() if installed else [])]


def near_problem_folders(extra: Sequence[Path] = ()) -> list[Path]:
    """The folders of the problems that are found without searching installed packages for packs."""
    return _folders(problem_roots(extra, installed=False))


def _near_roots(extra: Sequence[Path]) -> list[Path]:
    """The folders of problems that cost nothing to look up."""
    named = [(folder, "--problems") for folder in extra]
    named += [
        (Path(part), f"${_VARIABLE}") for part in os.environ.get(_VARIABLE, "").split(os.pathsep) if part
    ]
    roots = [_root(folder, source) for folder, source in named]
    own = shipped_problems()
    return roots + ([own] if own is not None else [])


def _root(folder: Path, source: str) -> Path:
    """The folder from the root. Raises UsageError if there is none of that name."""
    try:
        if folder.is_dir():
            return folder.resolve()
    except (OSError, ValueError):  # no name at all: too long, with a NUL; or the current folder is gone
        pass
    remedy = "name a folder that holds problems' folders"
    raise UsageError(f"{folder} is not a folder", where=source, remedy=remedy)


def shipped_problems() -> Path | None:
    """The folder of the judge's own problems, if it has any."""
    # Beside an installed package is site-packages, where a folder "problems" would be anybody's.
    places = (_PACKAGE / "problems", _PACKAGE.parent / "problems")
    return next((root for root in places if root.is_dir()), None)


def _installed_roots() -> list[Path]:
    """The folders of the packs that other distributions install.

    An entry point names a package whose folder holds the problems' folders, or a path to such a folder.
    """
    if not _may_be_installed():
        return []
    from importlib.metadata import entry_points  # slow to import, and seldom wanted

    roots = []
    for point in entry_points(group=_ENTRY_POINTS):
        try:
            pack = point.load()
            root = Path(pack if isinstance(pack, str | Path) else pack.__path__[0])
        except (Exception, SystemExit) as error:  # foreign code: whatever it raises is one clear line
            what = f"the pack {point.name!r} cannot be loaded: {type(error).__name__}: {error}"
            raise ProblemError(
                what, where=f"entry point {point.value}", remedy="repair or uninstall it"
            ) from error
        if not root.is_dir():
            what = f"the pack {point.name!r} names {root}, which is not a folder"
            raise ProblemError(what, where=f"entry point {point.value}", remedy="repair or uninstall it")
        roots.append(root.resolve())
    return roots


def _may_be_installed() -> bool:
    """Whether an installed distribution speaks of packs; seen without importlib.metadata, which is slow."""
    wanted = _ENTRY_POINTS.encode()
    for place in map(Path, dict.fromkeys(sys.path)):
        if place.is_file():  # a zip archive
            return True
        for told in place.glob("*-info/entry_points.txt"):
            with suppress(OSError):
                if wanted in told.read_bytes():
                    return True
    return False


def _folders(roots: Sequence[Path]) -> list[Path]:
    """The problems' folders in `roots`: those that hold at least one of a problem's own files."""
    return [folder for root in roots for folder in _inside(root)]


def _inside(root: Path) -> list[Path]:
    try:
        return [
            folder
            for folder in sorted(root.iterdir())
            if any((folder / mark).is_file() for mark in ("problem.toml", "problem.py", "statement.md"))
        ]
    except OSError as error:
        what = f"the folder cannot be read: {error.strerror}"
        raise UsageError(what, where=str(root), remedy="make it readable, or name another") from None
