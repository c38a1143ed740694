"""For setters: a kata to begin with, like another one, and a pack of katas to be installed (`judge new`).

    <folder>/problems/<name>/      problem.toml, problem.py, statement.md, hints.md, pins.json
    <folder>/solutions/<name>/     accepted/, wrong/

The new kata is whole and sound, to be changed file by file into one's own. What it is made of are the katas
of judge/manual/katas.
"""

from __future__ import annotations

import keyword
import os
import re
import tomllib
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from shlex import quote
from tempfile import TemporaryDirectory

from judge.data.pins import PINS
from judge.errors import UnknownKataError, UsageError, meant, unwritable
from judge.files import new_file
from judge.languages import language_of
from judge.problem import Problem
from judge.problem.find import find_problem, problem_folders
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
}  # katas of these, the usual one first
_PACK = Path(__file__).with_name("pack.toml")
_LEFT_OUT = {"pins.json", "libraries", "libraries.json", "same.toml", "__pycache__"}
_LETTERS = "small letters, digits and single hyphens"


class NewKata(Published, frozen=True):
    """A kata that was written: the folder of problems that it is in, and its files."""

    problem: str
    title: str
    problems: Path
    files: tuple[Path, ...]


def begin_kata(
    folder: Path,
    name: str | None = None,
    like: str = "",
    extra: Sequence[Path] = (),
    progress: Progress | None = None,
) -> NewKata:
    """Write a kata of that name, and pin its data; without a name it is called as `folder` is.

    It is `like` one of the KINDS, or any kata that is found, in `extra` folders first; else like the usual.
    A `folder` that is itself a folder of problems is taken as that: the solutions go beside it. Where not all
    can be written, nothing is left behind.

    Raises:
        UsageError: that is no name, there is such a kata already, or a file cannot be written.
        ProblemError: what it is to be like is broken.
    """
    try:
        problems = _folder_of_problems(folder)
        name = _checked(name, folder, problems)
    except FileNotFoundError as fault:  # the current folder is gone
        raise unwritable(folder, fault, "name another folder") from None
    roots = {"solutions": problems.parent / "solutions", "problems": problems}
    _check_free(name, [root / name for root in roots.values()])
    model, made = _model(like, extra), dict[Path, Path]()
    try:
        beside = next(each for each in (problems, *problems.absolute().parents) if each.is_dir())
        with TemporaryDirectory(prefix=".judge-", dir=beside) as scratch:
            for kind, file, content in _renamed(model, name):
                written = Path(scratch, kind, file)
                written.parent.mkdir(parents=True, exist_ok=True)
                written.write_bytes(content)
                if not (place := roots[kind] / file).exists():
                    made[place] = written
            problem = load_problem(Path(scratch, "problems", name))
            verify_problem(problem, Options(pin=True), progress)
            for kind, root in roots.items():
                root.mkdir(parents=True, exist_ok=True)
                Path(scratch, kind, name).rename(root / name)
            for place, written in made.items():
                if not place.exists():  # what katas share
                    place.parent.mkdir(exist_ok=True)
                    written.rename(place)
    except OSError as fault:
        raise unwritable(folder, fault, "name another folder") from None
    files = (*made, problems / name / PINS)
    return NewKata(problem.id, problem.title, problems, files)


def _model(like: str, extra: Sequence[Path]) -> Problem:
    """The kata that a new one is to be like. Raises UsageError, ProblemError."""
    if not like or like in KINDS:
        return load_problem(_TEMPLATES / (KINDS[like] if like else next(iter(KINDS.values()))))
    try:
        return find_problem(like, extra)
    except UnknownKataError:
        what = f"there is no kata {like!r}, and no kind of one"
        raise UsageError(what, remedy=meant(like, list(KINDS), "the kinds are")) from None


def _renamed(model: Problem, name: str) -> Iterator[tuple[str, str, bytes]]:
    """The files of a kata under another name: problems or solutions, the path there, and the content."""
    entry = name.replace("-", "_")
    if model.entry[:1].isupper():  # a class
        entry = "".join(word.capitalize() for word in name.split("-"))
    entry += "_" * keyword.iskeyword(entry)
    toml = (model.folder / "problem.toml").read_text(encoding="utf-8")
    types = (model.folder.parent / "types").glob("*.py")
    shared = {
        "problems": [each for each in types if re.search(rf"\b{each.stem}\b", toml)],
        "solutions": model.solutions.parent.glob("mistakes.toml"),
    }
    homes = {"problems": model.folder, "solutions": model.solutions}
    found = [(kind, path) for kind, home in homes.items() for path in sorted(home.rglob("*"))]
    found += [(kind, path) for kind, paths in shared.items() for path in paths]
    for kind, path in found:
        first, *parts = path.relative_to(homes[kind].parent).parts
        if not path.is_file() or not _LEFT_OUT.isdisjoint(parts):
            continue
        file = "/".join([name if first == model.id else first, *parts])
        content = path.read_bytes()
        try:
            text = content.decode()
        except UnicodeDecodeError:  # no text, as a picture
            yield kind, file, content
            continue
        if path.name == "problem.toml":
            text = re.sub(r"^(sets|place) *=.*\n", "", text, flags=re.M)
            text = text.replace(f'entry = "{model.entry}"', f'entry = "{entry}"')
        if model.entry:
            language = language_of(path)
            old, new = map(language.spelt, (model.entry, entry)) if language else (model.entry, entry)
            called = r"\b" if old[:1].isupper() else r" *\("  # else it may be a word of the text
            text = re.sub(rf"\b{old}(?={called})", new, text)
        if "-" in model.id:
            text = re.sub(rf"(?<![\w-]){model.id}(?![\w-])", name, text)
        text = text.replace(f".in.{model.id}]", f".in.{name}]")
        yield kind, file, text.encode()


def _folder_of_problems(folder: Path) -> Path:
    """Where the kata goes: the folder `problems` in `folder`, or `folder` itself. Raises UsageError."""
    if folder.exists() and not folder.is_dir():
        raise UsageError("this is not a folder", where=str(folder), remedy="name a folder for the new kata")
    inner = folder / "problems"
    own = Path(os.path.realpath(folder)).name == inner.name or any(folder.glob("*/problem.toml"))
    return folder if own and not inner.is_dir() else inner


def _checked(name: str | None, folder: Path, problems: Path) -> str:
    """The kata's name. Raises UsageError if it is none."""
    say = f"name it: judge new {quote(str(folder))} NAME"
    if name is None and problems == folder:
        raise UsageError("the new kata has no name", where=str(folder), remedy=say)
    chosen = Path(os.path.realpath(folder)).name if name is None else name
    if not is_name(chosen):
        remedy = f"{say}, with {_LETTERS}" if name is None else f"use {_LETTERS}"
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


# -- a pack ------------------------------------------------------------------------------------------------


def begin_pack(folder: Path, name: str | None) -> NewKata:
    """Write a package without katas, which is found by the judge once it is installed.

    Raises UsageError where a file is there already, or cannot be written.
    """
    name = _checked(name, folder, folder / "problems")
    words = {"name": name, "module": name.replace("-", "_"), "title": name.replace("-", " ").capitalize()}
    made = tomllib.loads(_PACK.read_text(encoding="utf-8"))
    files = {folder / path.format(**words): text.format(**words) for path, text in made.items()}
    for path in files:
        if path.exists():
            raise UsageError("it is there already", where=str(path), remedy="name another folder")
    try:
        for path, text in files.items():
            path.parent.mkdir(parents=True, exist_ok=True)
            new_file(path, text.encode())
    except OSError as fault:
        raise unwritable(folder, fault, "name another folder") from None
    return NewKata("", words["title"], folder / words["module"] / "problems", tuple(files))
