"""The solution that is shown after a problem is solved: its idea, why it works, its program."""

from __future__ import annotations

import ast
from importlib.util import decode_source
from pathlib import Path

from msgspec import Struct

from judge.errors import ProblemError
from judge.problem import Problem
from judge.problem.program import tree_of
from judge.problem.solutions import Kind, Solution, read_solutions


class Model(Struct, frozen=True):
    """A model solution; `idea` is the first line of its docstring, `explanation` the rest."""

    path: Path
    idea: str
    explanation: str
    program: str  # without the docstring


def model_solution(problem: Problem) -> Model:
    """The accepted function that times are measured against; where there is none, the first accepted one.

    Raises:
        ProblemError: there is none, or what there is cannot be read.
    """
    programs, faults = read_solutions(problem, Kind.ACCEPTED)
    timed = problem.time.function if problem.time else None
    for program in sorted(programs, key=lambda program: program.path.name != timed):
        tree = tree_of(program.source)
        if _defines(tree, problem.entry):
            return _model(program, tree)
    for fault in faults:
        raise fault
    what = f"there is no accepted solution that defines {problem.entry}"
    folder = problem.solutions / Kind.ACCEPTED.value
    raise ProblemError(what, where=f"{problem.solutions.name}/{folder.name}", remedy=f"add one to {folder}")


def _defines(tree: ast.Module, entry: str) -> bool:
    return any(isinstance(part, ast.FunctionDef) and part.name == entry for part in tree.body)


def _model(solution: Solution, tree: ast.Module) -> Model:
    lines = decode_source(solution.source).splitlines()
    if ast.get_docstring(tree) is not None:
        first = tree.body[0]
        lines[first.lineno - 1 : first.end_lineno] = []
    return Model(solution.path, solution.name, solution.text, "\n".join(lines).strip("\n"))
