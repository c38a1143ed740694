"""The solution that is shown after a problem is solved: its idea, why it works, its program."""

from __future__ import annotations

import ast
from pathlib import Path

from msgspec import Struct

from judge.errors import ProblemError
from judge.language import programs
from judge.problem import Problem


class Model(Struct, frozen=True):
    """A model solution; `idea` is the first line of its docstring, `explanation` the rest."""

    path: Path
    idea: str
    explanation: str
    program: str  # without the docstring


def model_solution(problem: Problem) -> Model:
    """The accepted function that times are measured against; where there is none, the first accepted one.

    Raises:
        ProblemError: there is none, or it is no Python.
    """
    where = f"{problem.solutions.name}/accepted"
    paths = programs(problem.solutions / "accepted")
    if problem.time is not None:
        paths.sort(key=lambda path: problem.time is None or path.name != problem.time.function)
    for path in paths:
        try:
            text = path.read_text(encoding="utf-8")
            tree = ast.parse(text)
        except OSError as fault:
            what = f"cannot be read ({fault.strerror})"
            raise ProblemError(what, where=f"{where}/{path.name}", remedy="make it readable") from fault
        except (SyntaxError, ValueError) as fault:
            raise ProblemError(
                f"no Python: {fault}", where=f"{where}/{path.name}", remedy="repair it"
            ) from fault
        if _defines(tree, problem.entry):
            return _model(path, text, tree)
    what = f"there is no accepted solution that defines {problem.entry}"
    raise ProblemError(what, where=where, remedy=f"add one to {problem.solutions / 'accepted'}")


def _defines(tree: ast.Module, entry: str) -> bool:
    return any(isinstance(part, ast.FunctionDef) and part.name == entry for part in tree.body)


def _model(path: Path, text: str, tree: ast.Module) -> Model:
    docstring = ast.get_docstring(tree) or ""
    idea, _, explanation = docstring.partition("\n")
    lines = text.splitlines()
    if docstring:
        first = tree.body[0]
        lines[first.lineno - 1 : first.end_lineno] = []
    return Model(path, idea.strip().rstrip("."), explanation.strip("\n"), "\n".join(lines).strip("\n"))
