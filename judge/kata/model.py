"""The solutions that are shown after a problem is solved: the approaches, why each works, its program."""

from __future__ import annotations

import ast
from collections.abc import Sequence
from importlib.util import decode_source
from pathlib import Path

from msgspec import Struct

from judge.errors import ProblemError, UsageError, nearest
from judge.language import SUFFIX
from judge.problem import Problem
from judge.problem.program import tree_of
from judge.problem.solutions import Kind, Solution, read_solutions


class Model(Struct, frozen=True):
    """An approach; `idea` is the first line of its docstring, `explanation` the rest, `about` one sentence.

    `program` is without the docstring, `source` the file as it is.
    """

    path: Path
    idea: str
    explanation: str
    about: str
    program: str
    source: bytes

    @property
    def name(self) -> str:
        """What the approach is called by: `cross-product`."""
        return self.path.stem.replace("_", "-")


def approaches(problem: Problem) -> list[Model]:
    """The accepted functions, the one that times are measured against first, at least one.

    Raises:
        ProblemError: there is none, or none that can be read.
    """
    programs, faults = read_solutions(problem, Kind.ACCEPTED)
    timed = problem.time.function if problem.time else None
    found = []
    for program in sorted(programs, key=lambda program: program.path.name != timed):
        tree = tree_of(program.source)
        if _defines(tree, problem.entry):
            found.append(_model(program, tree))
    if found:
        return found
    for fault in faults:
        raise fault
    what = f"there is no accepted solution that defines {problem.entry}"
    folder = problem.solutions / Kind.ACCEPTED.value
    raise ProblemError(what, where=f"{problem.solutions.name}/{folder.name}", remedy=f"add one to {folder}")


def chosen_approach(problem: Problem, models: Sequence[Model], name: str | None) -> Model:
    """The approach of that name, or the first. Raises UsageError where there is none called so."""
    if name is None:
        return models[0]
    wanted = name.removesuffix(SUFFIX).replace("_", "-").replace(" ", "-")
    for model in models:
        if wanted in (model.name, model.idea.replace(" ", "-")):
            return model
    names = [model.name for model in models]
    meant = nearest(wanted, names)
    remedy = f"did you mean {meant!r}?" if meant else f"there are {', '.join(names)}"
    raise UsageError(f"{problem.id} has no approach {name!r}", remedy=remedy)


def _defines(tree: ast.Module, entry: str) -> bool:
    return any(isinstance(part, ast.FunctionDef) and part.name == entry for part in tree.body)


def _model(solution: Solution, tree: ast.Module) -> Model:
    lines = decode_source(solution.source).splitlines()
    if ast.get_docstring(tree) is not None:
        first = tree.body[0]
        lines[first.lineno - 1 : first.end_lineno] = []
    program = "\n".join(lines).strip("\n")
    return Model(solution.path, solution.name, solution.text, solution.sentence, program, solution.source)
