"""A kata to begin with: whole and sound, to be changed file by file into one's own.

    <folder>/problems/<name>/      problem.toml, problem.py, statement.md, hints.md, pins.json
    <folder>/solutions/<name>/     accepted/, wrong/

Its texts are those of judge/manual/new-kata.md.
"""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterator
from pathlib import Path
from shlex import quote

from msgspec import Struct

from judge.data.load import ProblemData, load_data
from judge.data.pins import pins_file, pins_of, write_pins
from judge.errors import UsageError, unwritable
from judge.files import new_file
from judge.mistakes.computed import Computer, Program
from judge.mistakes.makers import read_makers
from judge.problem import Problem
from judge.problem.find import near_problem_folders
from judge.problem.load import load_problem
from judge.problem.model import is_name
from judge.run.verify import ENOUGH

_TEMPLATE = Path(__file__).resolve().parent.parent / "manual" / "new-kata.md"
_FILE = re.compile(r"^## `([^`]+)`\n\n```\w+\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_ID, _ENTRY = "my-kata", "my_kata"  # what stands for the new kata's in the template
_LETTERS = "small letters, digits and single hyphens"
_PROBLEMS, _SOLUTIONS = "problems", "solutions"


class Begun(Struct, frozen=True):
    """A new kata: the folder of problems that it is in, and the files that were written."""

    problem: Problem
    problems: Path
    files: tuple[Path, ...]


def begin_kata(folder: Path, name: str | None = None) -> Begun:
    """Write a kata of that name, and pin its data; without a name it is called as `folder` is.

    A `folder` that is itself a folder of problems is taken as that: the solutions go beside it. Where not all
    can be written, nothing is left behind.

    Raises:
        UsageError: that is no name, there is such a kata already, or a file cannot be written.
    """
    made: list[Path] = []
    try:
        problems = _folder_of_problems(folder)
        name = _checked(name, folder, problems)
        homes = {_PROBLEMS: problems, _SOLUTIONS: problems.parent / _SOLUTIONS}
        _check_free(name, [home / name for home in homes.values()])
        for file, text in _files(name):
            home, _, rest = file.partition("/")
            _write(homes[home] / rest, text, made)
        problem = load_problem(problems / name)
        made.append(pins_file(problem))
        data = load_data(problem, store=None)
        write_pins(problem, pins_of(data.groups, _kills(data)))
    except OSError as fault:
        _undo(made)
        raise unwritable(Path(fault.filename or folder), fault, "name another folder") from None
    except BaseException:
        _undo(made)
        raise
    return Begun(problem, problems, tuple(path for path in made if path.is_file()))


def _folder_of_problems(folder: Path) -> Path:
    """Where the kata goes: the folder `problems` in `folder`, or `folder` itself. Raises UsageError."""
    if folder.exists() and not folder.is_dir():
        raise UsageError("this is no folder", where=str(folder), remedy="name a folder for the new kata")
    within = folder / _PROBLEMS
    if not within.is_dir() and folder.is_dir():
        holds_problems = any((path / "problem.toml").is_file() for path in folder.iterdir())
        if holds_problems or folder.resolve().name == _PROBLEMS:
            return folder
    return within


def _checked(name: str | None, folder: Path, problems: Path) -> str:
    """The kata's name. Raises UsageError if it is none."""
    if name is None and problems == folder:
        remedy = f"name it: judge new {quote(str(folder))} NAME"
        raise UsageError("the new kata has no name", where=str(folder), remedy=remedy)
    chosen = folder.resolve().name if name is None else name
    if not is_name(chosen):
        remedy = f"use {_LETTERS}"
        if name is None:
            remedy = f"name it: judge new {quote(str(folder))} NAME, with {_LETTERS}"
        raise UsageError(f"{chosen!r} is no name for a kata", remedy=remedy)
    return chosen


def _check_free(name: str, places: list[Path]) -> None:
    """Refuse to write over anything, or to hide another kata. Raises UsageError."""
    for place in places:
        if place.is_symlink() or (place.exists() and not (place.is_dir() and not any(place.iterdir()))):
            what, remedy = "it is there already", "choose another name, or take it away first"
            raise UsageError(what, where=str(place), remedy=remedy)
    for other in near_problem_folders():
        if other.name == name:
            what, remedy = f"a kata is called {name!r} already", "choose another name: runs are kept by it"
            raise UsageError(what, where=str(other), remedy=remedy)


def _files(name: str) -> Iterator[tuple[str, str]]:
    """The path of each file, which begins with problems/ or solutions/, and its text."""
    entry = name.replace("-", "_")
    if keyword.iskeyword(entry):
        entry += "_"
    template = _TEMPLATE.read_text(encoding="utf-8")
    for file, text in _FILE.findall(template):
        yield file.replace(_ID, name), text.replace(_ID, name).replace(_ENTRY, entry)


def _write(path: Path, text: str, made: list[Path]) -> None:
    """Write one file, never over another; `made` gets it and each folder that was missing."""
    for folder in reversed(path.parents):
        if not folder.is_dir():
            folder.mkdir()
            made.append(folder)
    try:
        new_file(path, text.encode())
    except OSError as fault:
        fault.filename = str(path)  # the place that is meant, not what was written beside it
        raise
    made.append(path)


def _undo(made: list[Path]) -> None:
    """Take away what was made, and nothing else."""
    for path in reversed(made):
        try:
            path.rmdir() if path.is_dir() else path.unlink(missing_ok=True)
        except OSError:  # somebody else has put something there
            continue


def _kills(data: ProblemData) -> dict[str, list[str]]:
    """The mistakes of the new kata's own wrong programs that each group rejects."""
    computer = Computer(data)
    found: dict[str, list[str]] = {}
    for maker in read_makers(data.problem).all:
        program = Program(maker.program.source, maker.file, trusted=True)  # the template's
        for group, answers in computer.behaviour(program).items():
            if len(answers.wrong) >= ENOUGH:
                found.setdefault(group, []).append(maker.name)
    return found
