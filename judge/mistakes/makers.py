"""All that is known to be wrong in a problem: what mistakes.py makes, and the programs of wrong/."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from msgspec import Struct

from judge.errors import ProblemError
from judge.mistakes.catalogue import MistakeText, read_catalogue
from judge.mistakes.computed import ComputedProgram
from judge.mistakes.family import Family, Maker
from judge.problem import Problem
from judge.problem.solutions import Solution, SolutionKind, read_solutions, usual_first

SHARED = "shared-by-all-objects"
_CHANGEABLE = (ast.List, ast.Dict, ast.Set, ast.ListComp, ast.DictComp, ast.SetComp, ast.Call)


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
        found += family.mistakes()
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


def _of_file(solution: Solution, words: MistakeText) -> Maker:
    program = ComputedProgram(solution.source, solution.path.name)
    return Maker(solution.name, solution.file, solution.advice or words.told, words, program)
