"""The solutions that are shown after a problem is solved: the approaches, why each works, its program."""

from __future__ import annotations

import ast
from collections.abc import Sequence
from importlib.util import decode_source
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.errors import ProblemError, UsageError, nearest
from judge.languages import NAME, SUFFIX
from judge.problem import Problem
from judge.problem.solutions import Kind, Solution, parted, read_solutions, tree_of

if TYPE_CHECKING:
    from judge.languages.model import Language


class Model(Struct, frozen=True):
    """An approach; `idea` is the first line of what it begins with, `explanation` the rest.

    `about` is one sentence of it. `program` is without these lines, `source` the file as it is. `language` is
    None for Python.
    """

    path: Path
    idea: str
    explanation: str
    about: str
    program: str
    source: bytes
    language: Language | None = None

    @property
    def name(self) -> str:
        """What the approach is called by: `cross-product`."""
        suffixes = self.language.suffixes if self.language else (SUFFIX,)
        suffix = next(each for each in suffixes if self.path.name.endswith(each))
        return self.path.name.removesuffix(suffix).replace("_", "-")

    @property
    def tongue(self) -> str:
        """The name of its language."""
        return self.language.name if self.language else NAME

    @property
    def call(self) -> str:
        """What names it among those of all languages: its name in Python, its file's in another one."""
        return self.path.name if self.language else self.name


def approaches(problem: Problem) -> list[Model]:
    """The accepted functions, at least one: Python's first, and of these the one that sets the time limit.

    Raises:
        ProblemError: there is none, or none that can be read.
    """
    programs, faults = read_solutions(problem, Kind.ACCEPTED)
    timed = problem.time.function if problem.time else None
    found = []
    for program in sorted(programs, key=lambda program: (*_rank(program), program.path.name != timed)):
        if program.language is not None:
            if _defined(program, program.language, problem.entry):
                below = parted(program.source, program.language)[1]
                found.append(_model(program, below))
            continue
        tree = tree_of(program.source)
        if _defines(tree, problem.entry):
            found.append(_model(program, _undocumented(program, tree)))
    if found:
        return found
    for fault in faults:
        raise fault
    what = f"there is no accepted solution that defines {problem.entry}"
    folder = problem.solutions / Kind.ACCEPTED.value
    raise ProblemError(what, where=f"{problem.solutions.name}/{folder.name}", remedy=f"add one to {folder}")


def chosen_approach(
    problem: Problem, models: Sequence[Model], name: str | None, language: str | None = None
) -> Model:
    """The approach of that name, or the first; in that language, where one is named.

    Raises UsageError where there is none.
    """
    if language is not None:
        models = _in_language(problem, models, language)
    if name is None:
        return models[0]
    wanted = name.removesuffix(SUFFIX).replace("_", "-").replace(" ", "-")
    for model in models:
        if name == model.path.name or wanted in (model.name, model.idea.replace(" ", "-")):
            return model
    names = [model.call for model in models]
    meant = nearest(wanted, names)
    remedy = f"did you mean {meant!r}?" if meant else f"there are {', '.join(names)}"
    raise UsageError(f"{problem.id} has no approach {name!r}", remedy=remedy)


def _in_language(problem: Problem, models: Sequence[Model], language: str) -> Sequence[Model]:
    """Those in the language of that name, its suffix or its id."""
    from judge.languages.model import named_language

    wanted = named_language(language)
    found = [model for model in models if model.language == wanted]
    if not found:
        tongues = ", ".join(dict.fromkeys(model.tongue for model in models))
        what = f"{problem.id} has no solution in {wanted.name if wanted else NAME}"
        raise UsageError(what, remedy=f"there are some in {tongues}")
    return found


def _rank(program: Solution) -> tuple[int, str]:
    return (program.language.order, program.language.id) if program.language else (-1, "")


def _defined(program: Solution, language: Language, entry: str) -> bool:
    from judge.languages.sources import definition  # only where there is such a file

    return definition(language, program.source, entry) is not None


def _defines(tree: ast.Module, entry: str) -> bool:
    return any(isinstance(part, ast.FunctionDef) and part.name == entry for part in tree.body)


def _undocumented(solution: Solution, tree: ast.Module) -> str:
    lines = decode_source(solution.source).splitlines()
    if ast.get_docstring(tree) is not None:
        first = tree.body[0]
        lines[first.lineno - 1 : first.end_lineno] = []
    return "\n".join(lines).strip("\n")


def _model(solution: Solution, program: str) -> Model:
    found = solution
    return Model(
        found.path, found.name, found.text, found.sentence, program, found.source, language=found.language
    )
