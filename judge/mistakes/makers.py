"""All that is known to be wrong in a problem: the choices of mistakes.py, and the programs of wrong/."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Sequence

from msgspec import Struct

from judge.errors import ProblemError
from judge.mistakes.catalogue import EXAMPLE, MistakeText, read_catalogue
from judge.mistakes.computed import ComputedProgram
from judge.mistakes.family import Family, SpoiledLine, Variant
from judge.problem import Problem
from judge.problem.solutions import Solution, SolutionKind, read_solutions, usual_first
from judge.run.result import Behaviour

SHARED = "shared-by-all-objects"
_CHANGEABLE = (ast.List, ast.Dict, ast.Set, ast.ListComp, ast.DictComp, ast.SetComp, ast.Call)


class Maker(Struct, frozen=True):
    """A program that makes a known mistake: a choice, or a file.

    `file` is where it stands, `text` what is said of whoever makes it, `words` what mistakes.toml says of the
    mistake, `lines` are those that it spoils, where they are known. One that is `offered` comes from the
    types alone: it may be no mistake of this kata, and is a name where no other is nearly as like.
    """

    name: str
    file: str
    text: str
    words: MistakeText
    program: ComputedProgram
    lines: tuple[SpoiledLine, ...] = ()
    choice: Variant | None = None
    offered: bool = False

    @property
    def seen(self) -> str:
        """What is seen in the answers."""
        seen = self.words.seen
        return seen if seen and self.text.startswith(seen) else _first(self.text)

    @property
    def wrong(self) -> str:
        """What is seen, and an example of it, without what to do instead: that is for the hints."""
        rest = self.text.removeprefix(self.seen)
        return self.seen + (_first(rest) if rest.startswith(f" {EXAMPLE}") else "")


class Makers(Struct, frozen=True):
    """Every maker, and what is wrong with the files; `family` is None where there is no mistakes.py.

    `problem` is the problem with all of its groups' kills.
    """

    problem: Problem
    all: tuple[Maker, ...]
    faults: tuple[ProblemError, ...]
    family: Family | None


def read_makers(problem: Problem) -> Makers:
    """What is known of a problem's mistakes. A file that cannot be read is a fault and no maker."""
    solutions, faults = read_solutions(problem, SolutionKind.WRONG)
    programs = [each for each in solutions if each.language is None]  # the others would be compiled for it
    found: list[Maker] = []
    family = None
    try:
        catalogue = read_catalogue(problem)
        family = Family.of(problem, catalogue)
    except ProblemError as fault:
        catalogue, family, faults = {}, None, (*faults, fault)
    if family is not None:
        found += [_of_choice(family, choice, name) for choice, name in family.named]
    found += [_of_file(each, catalogue.get(each.name, MistakeText())) for each in usual_first(programs)]
    if problem.methods and SHARED not in {each.name for each in found}:
        found += _of_classes(problem, catalogue.get(SHARED, MistakeText()))
    return Makers(problem, tuple(found), faults, family)


def _of_classes(problem: Problem, words: MistakeText) -> Iterator[Maker]:
    """The right classes of which all objects share their state."""
    for each in read_solutions(problem, SolutionKind.ACCEPTED)[0]:
        source = shared(each.source, problem.entry) if each.language is None else None
        if source is not None:
            program = ComputedProgram(source.encode(), each.path.name)
            yield Maker(SHARED, each.file, words.told, words, program, offered=True)


def shared(source: bytes, entry: str) -> str | None:
    """The class, which has itself what its constructor makes of no argument; None if that is nothing."""
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError):
        return None
    made = next((each for each in tree.body if isinstance(each, ast.ClassDef) and each.name == entry), None)
    body = made.body if made else []
    first = next(
        (each for each in body if isinstance(each, ast.FunctionDef) and each.name == "__init__"), None
    )
    if made is None or first is None:
        return None
    own = {each.arg for each in ast.walk(first.args) if isinstance(each, ast.arg)}
    moved = [each for each in first.body if isinstance(each, ast.Assign) and _is_fresh(each, own)]
    kept = [each for each in first.body if each not in moved]
    first.body = kept or [ast.Pass()]
    for each in moved:
        each.targets = [ast.Name(target.attr) for target in each.targets if isinstance(target, ast.Attribute)]
    made.body[:0] = moved
    return ast.unparse(ast.fix_missing_locations(tree)) if moved else None


def _is_fresh(statement: ast.Assign, own: set[str]) -> bool:
    """Whether it gives attributes an object that is made there, of no argument, and may be changed."""
    nodes = [*ast.walk(statement.value)]
    plain = not own.intersection(each.id for each in nodes if isinstance(each, ast.Name))
    attributes = all(isinstance(target, ast.Attribute) for target in statement.targets)
    return plain and attributes and any(isinstance(each, _CHANGEABLE) for each in nodes)


def _of_choice(family: Family, choice: Variant, name: str) -> Maker:
    place = family.place(choice)
    program = ComputedProgram(family.program(choice).encode(), place, trusted=True)
    words, lines, offered = family.words(name), family.lines(choice), family.offered(choice)
    return Maker(name, place, family.told(choice), words, program, lines, choice, offered)


def _of_file(solution: Solution, words: MistakeText) -> Maker:
    program = ComputedProgram(solution.source, solution.path.name)
    return Maker(solution.name, solution.file, solution.advice or words.told, words, program)


def _first(text: str) -> str:
    """Its first sentence."""
    return re.split(r"(?<=[.!?])\s", text, maxsplit=1)[0]


def distinct(makers: Sequence[Maker], answers: Sequence[Behaviour]) -> list[list[int]]:
    """The places of those to compare with, each with all of its mistake's that answer alike: one object."""
    alike: dict[tuple[str, int], list[int]] = {}
    for place, (maker, each) in enumerate(zip(makers, answers, strict=True)):
        alike.setdefault((maker.name, id(each)), []).append(place)
    return [places for places in alike.values() if any(each.wrong for each in answers[places[0]].values())]
