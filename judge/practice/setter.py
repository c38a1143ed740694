"""For setters: a kata to begin with, and what a kata needs beyond being judged (`judge new`, `judge verify`).

    <folder>/problems/<name>/      problem.toml, problem.py, statement.md, hints.md, pins.json
    <folder>/solutions/<name>/     accepted/, wrong/

The new kata is whole and sound, to be changed file by file into one's own. Its texts are those of
judge/manual/new-kata.md.
"""

from __future__ import annotations

import keyword
import os
import re
from collections.abc import Collection, Iterable, Sequence
from contextlib import nullcontext
from pathlib import Path
from shlex import quote
from tempfile import TemporaryDirectory

from judge.data.load import load_data
from judge.data.pins import pins_file, pins_of, write_pins
from judge.errors import JudgeError, ProblemError, UsageError, unwritable
from judge.practice.cards import read_decks
from judge.practice.questions import Sources, ask
from judge.practice.stub import make_stub
from judge.practice.syllabus import unknown_names
from judge.problem import Problem
from judge.problem.find import problem_folders, problem_roots
from judge.problem.load import load_problem
from judge.problem.model import EXAMPLES, is_name
from judge.problem.texts import read_hints
from judge.published import Published
from judge.verify.model import Fault, Verified, fault_of

_TEMPLATE = Path(__file__).resolve().parent.parent / "manual" / "new-kata.md"
_FILE = re.compile(r"^## `([^`]+)`\n\n```\w+\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_ID, _ENTRY = "my-kata", "my_kata"  # what stands for the new kata's in the template
_MISTAKES = ["sum-of-legs"]  # of the template, which its groups reject whatever the kata is called
_LETTERS = "small letters, digits and single hyphens"


class NewKata(Published, frozen=True):
    """A kata that was written: the folder of problems that it is in, and its files."""

    problem: str
    title: str
    problems: Path
    files: tuple[Path, ...]


def begin_kata(folder: Path, name: str | None = None) -> NewKata:
    """Write a kata of that name, and pin its data; without a name it is called as `folder` is.

    A `folder` that is itself a folder of problems is taken as that: the solutions go beside it. Where not all
    can be written, nothing is left behind.

    Raises:
        UsageError: that is no name, there is such a kata already, or a file cannot be written.
    """
    problems = _folder_of_problems(folder)
    name = _checked(name, folder, problems)
    homes = {"solutions": problems.parent / "solutions" / name, "problems": problems / name}
    _check_free(name, homes.values())
    entry, files = name.replace("-", "_") + "_" * keyword.iskeyword(name), []
    try:
        beside = next(each for each in (problems, *problems.absolute().parents) if each.is_dir())
        with TemporaryDirectory(prefix=".judge-", dir=beside) as scratch:
            for path, text in _FILE.findall(_TEMPLATE.read_text(encoding="utf-8")):
                kind, file = path.replace(f"/{_ID}", "").split("/", 1)
                written = Path(scratch, kind, name, file)
                written.parent.mkdir(parents=True, exist_ok=True)
                written.write_text(text.replace(_ID, name).replace(_ENTRY, entry), encoding="utf-8")
                files.append(homes[kind] / file)
            problem = load_problem(Path(scratch, "problems", name))
            data = load_data(problem, store=None)
            kills = {group.name: _MISTAKES for group in problem.groups if group.name != EXAMPLES}
            write_pins(problem, pins_of(data.groups, kills))
            for kind, home in homes.items():
                home.parent.mkdir(parents=True, exist_ok=True)
                Path(scratch, kind, name).rename(home)
    except OSError as fault:
        raise unwritable(folder, fault, "name another folder") from None
    files.append(homes["problems"] / pins_file(problem).name)
    return NewKata(problem.id, problem.title, problems, tuple(files))


def _folder_of_problems(folder: Path) -> Path:
    """Where the kata goes: the folder `problems` in `folder`, or `folder` itself. Raises UsageError."""
    if folder.exists() and not folder.is_dir():
        raise UsageError("this is not a folder", where=str(folder), remedy="name a folder for the new kata")
    within = folder / "problems"
    if folder.is_dir() and not within.is_dir():
        holds_problems = any((path / "problem.toml").is_file() for path in folder.iterdir())
        if holds_problems or Path(os.path.realpath(folder)).name == "problems":
            return folder
    return within


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


# -- what a kata needs: hints, a stub, cards, sets and skills ----------------------------------------------


def kata_faults(problem: Problem, extra: Sequence[Path] = ()) -> list[Fault]:
    """The setter's faults; `extra` are folders of problems to look in first for the sets and skills."""
    found: list[ProblemError] = []
    for check in (read_hints, make_stub, lambda each: found.extend(unknown_names([each], extra))):
        try:
            check(problem)
        except ProblemError as fault:
            found.append(fault)
    return [fault_of(fault, problem.id) for fault in found]


def verify_decks(folders: Sequence[Path], katas: Collection[str]) -> Verified:
    """How many cards are there, and a fault for each that cannot be asked.

    They are the cards of the `katas`; without any, those of all decks in the `folders`, or of all there are.
    """
    cards, broken = read_decks(folders)
    faults = [] if katas else [fault_of(fault, "quiz") for fault in broken]
    roots = problem_roots(folders)[: len(folders) or None]
    own = {path.stem for root in roots for path in (root / "quiz").glob("*.toml")}
    cards = [card for card in cards if (card.problem in katas if katas else card.deck in own)]
    sources = Sources(folders, 0, lambda _label: nullcontext())
    for card in cards:
        try:
            ask(card, sources, "check")
        except JudgeError as fault:
            faults.append(fault_of(fault, card.key))
    return Verified("quiz", tuple(faults), cards=len(cards))
