"""For setters: a kata to begin with, of one of several kinds (`judge new`).

    <folder>/problems/<name>/      problem.toml, problem.py, statement.md, hints.md, pins.json
    <folder>/solutions/<name>/     accepted/, wrong/

The new kata is whole and sound, to be changed file by file into one's own. What it is made of are the katas
of judge/manual/katas.
"""

from __future__ import annotations

import keyword
import os
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from shlex import quote
from tempfile import TemporaryDirectory

from judge.data.pins import PINS
from judge.errors import UsageError, unwritable
from judge.languages import language_of
from judge.problem import Problem
from judge.problem.find import problem_folders
from judge.problem.load import load_problem
from judge.problem.model import is_name
from judge.published import Published
from judge.verify.gate import Options, verify_problem
from judge.verify.model import Progress

_TEMPLATES = Path(__file__).resolve().parent.parent / "manual" / "katas" / "problems"
KINDS = {
    "numbers": "two-points",
    "text": "runs",
    "list": "knapsack",
    "class": "least-recently-used",
    "program": "depot",
    "judged": "tasks-in-order",
    "growth": "hops",
    "dialogue": "higher-lower",
}  # katas of these
USUAL = "numbers"


class NewKata(Published, frozen=True):
    """A kata that was written: the folder of problems that it is in, and its files."""

    problem: str
    title: str
    problems: Path
    files: tuple[Path, ...]


def begin_kata(
    folder: Path, name: str | None = None, kind: str = USUAL, progress: Progress | None = None
) -> NewKata:
    """Write a kata of that name, and pin its data; without a name it is called as `folder` is.

    It is of one of the KINDS. A `folder` that is itself a folder of problems is taken as that: the solutions
    go beside it. Where not all can be written, nothing is left behind.

    Raises UsageError: that is no name, there is such a kata already, or a file cannot be written.
    """
    problems = _folder_of_problems(folder)
    name = _checked(name, folder, problems)
    homes = {"problems": problems / name, "solutions": problems.parent / "solutions" / name}
    _check_free(name, homes.values())
    files = []
    try:
        beside = next(each for each in (problems, *problems.absolute().parents) if each.is_dir())
        with TemporaryDirectory(prefix=".judge-", dir=beside) as scratch:
            made = {each: Path(scratch, each, name) for each in homes}
            for part, file, text in _renamed(load_problem(_TEMPLATES / KINDS[kind]), name):
                files.append(homes[part] / file)
                written = made[part] / file
                written.parent.mkdir(parents=True, exist_ok=True)
                written.write_text(text, encoding="utf-8")
            problem = load_problem(made["problems"])
            verify_problem(problem, Options(pin=True), progress)
            for part, home in homes.items():
                home.parent.mkdir(parents=True, exist_ok=True)
                made[part].rename(home)
    except OSError as fault:
        raise unwritable(folder, fault, "name another folder") from None
    return NewKata(problem.id, problem.title, problems, (*files, homes["problems"] / PINS))


def _renamed(model: Problem, name: str) -> Iterator[tuple[str, Path, str]]:
    """The files of a kata under another name: of its problem or solutions, the path there, and the text."""
    entry = name.replace("-", "_")
    if model.entry[:1].isupper():  # a class
        entry = "".join(word.capitalize() for word in name.split("-"))
    entry += "_" * keyword.iskeyword(entry)
    homes = {"problems": model.folder, "solutions": model.solutions}
    for part, path in ((part, path) for part, home in homes.items() for path in sorted(home.rglob("*"))):
        if not path.is_file() or path.name == PINS or path.parent.name == "__pycache__":
            continue
        text = path.read_text(encoding="utf-8")
        if model.entry:
            text = text.replace(f'entry = "{model.entry}"', f'entry = "{entry}"')
            language = language_of(path)
            old, new = map(language.spelt, (model.entry, entry)) if language else (model.entry, entry)
            called = r"\b" if old[:1].isupper() else r" *\("  # else it may be a word of the text
            text = re.sub(rf"\b{old}(?={called})", new, text)
        if "-" in model.id:
            text = re.sub(rf"(?<![\w-]){model.id}(?![\w-])", name, text)
        yield part, path.relative_to(homes[part]), text


def _folder_of_problems(folder: Path) -> Path:
    """Where the kata goes: the folder `problems` in `folder`, or `folder` itself. Raises UsageError."""
    if folder.exists() and not folder.is_dir():
        raise UsageError("this is not a folder", where=str(folder), remedy="name a folder for the new kata")
    inner = folder / "problems"
    is_one = Path(os.path.realpath(folder)).name == "problems" or any(folder.glob("*/problem.toml"))
    return folder if folder.is_dir() and is_one and not inner.is_dir() else inner


def _checked(name: str | None, folder: Path, problems: Path) -> str:
    """The kata's name. Raises UsageError if it is none."""
    say = f"name it: judge new {quote(str(folder))} NAME"
    if name is None and problems == folder:
        raise UsageError("the new kata has no name", where=str(folder), remedy=say)
    chosen = Path(os.path.realpath(folder)).name if name is None else name
    if not is_name(chosen):
        remedy = f"{say}, with small letters, digits and single hyphens"
        raise UsageError(f"{chosen!r} is no name for a kata", remedy=remedy)
    return chosen


def _check_free(name: str, places: Iterable[Path]) -> None:
    """Refuse to write over anything, or to hide another kata. Raises UsageError."""
    for place in places:
        if place.is_symlink() or place.is_file() or (place.is_dir() and any(place.iterdir())):
            remedy = "choose another name, or take it away first"
            raise UsageError("it is there already", where=str(place), remedy=remedy)
    for other in problem_folders(installed=False):
        if other.name == name:
            what, remedy = f"a kata is called {name!r} already", "choose another name: runs are kept by it"
            raise UsageError(what, where=str(other), remedy=remedy)
