"""The solutions that are shown after a problem is solved: the approaches, why each works, its program."""

from __future__ import annotations

import ast
from collections.abc import Sequence
from importlib.util import decode_source

from msgspec import Struct

from judge.errors import ProblemError, UsageError, meant
from judge.languages import NAME, SUFFIX
from judge.problem import Problem
from judge.problem.solutions import Solution, SolutionKind, parted, read_solutions, tree_of
from judge.run.result import Taken


class Approach(Struct, frozen=True):
    """An approach, by its name, and by what `judge solution` calls it among those of all languages.

    `code` is the id of its language, `about` the first sentence of the explanation, `program` is without the
    lines that tell of it, and `taken` is what it takes, where that is measured.
    """

    name: str
    call: str
    file: str
    language: str
    code: str
    idea: str
    about: str
    explanation: str
    program: str
    taken: Taken | None = None


def _approach(solution: Solution, program: str) -> Approach:
    file, language = solution.path.name, solution.language
    name = solution.path.stem.replace("_", "-")
    call, tongue, code = (file, language.name, language.id) if language else (name, NAME, NAME.lower())
    return Approach(name, call, file, tongue, code, solution.name, solution.sentence, solution.text, program)


def approaches(problem: Problem) -> list[Approach]:
    """The accepted functions, or programs where there is no entry: Python's first, of these the timed one.

    Raises:
        ProblemError: there is none, or none that can be read.
    """
    programs, faults = read_solutions(problem, SolutionKind.ACCEPTED)
    timed = (problem.time.function or problem.time.program) if problem.time else None

    def rank(solution: Solution) -> tuple[int, str, bool]:
        language = solution.language
        order = (language.order, language.id) if language else (-1, "")
        return (*order, solution.path.name != timed)

    shown = [(each, _program(each, problem.entry)) for each in sorted(programs, key=rank)]
    if found := [_approach(each, program) for each, program in shown if program is not None]:
        return found
    for fault in faults:
        raise fault
    what = "there is no accepted solution" + f" that defines {problem.entry}" * bool(problem.entry)
    folder = problem.solutions / SolutionKind.ACCEPTED.value
    raise ProblemError(what, where=f"{problem.solutions.name}/{folder.name}", remedy=f"add one to {folder}")


def _program(solution: Solution, entry: str) -> str | None:
    """What follows the text that it begins with; None where it does not define `entry`, if there is one."""
    if solution.language is not None:
        from judge.languages.sources import definition  # only where there is such a file

        defined = not entry or definition(solution.language, solution.source, entry) is not None
        return parted(solution.source, solution.language)[1] if defined else None
    tree = tree_of(solution.source)
    if entry and not any(getattr(part, "name", "") == entry for part in tree.body):
        return None
    lines = decode_source(solution.source).splitlines()
    if ast.get_docstring(tree) is not None:
        lines[tree.body[0].lineno - 1 : tree.body[0].end_lineno] = []
    return "\n".join(lines).strip("\n")


def chosen_approach(
    problem: Problem, models: Sequence[Approach], name: str | None, language: str | None = None
) -> Approach:
    """The approach of that name, or the first; in the language that is meant, where one is.

    Raises UsageError where there is none.
    """
    if language is not None:
        from judge.languages.model import named_language

        tongue = named_language(language)
        code, said = (tongue.id, tongue.name) if tongue else (NAME.lower(), NAME)
        mine = [model for model in models if model.code == code]
        if not mine:
            tongues = ", ".join(dict.fromkeys(model.language for model in models))
            raise UsageError(f"{problem.id} has no solution in {said}", remedy=f"there are some in {tongues}")
        models = mine
    if name is None:
        return models[0]
    wanted = name.removesuffix(SUFFIX).replace("_", "-").replace(" ", "-")
    for model in models:
        if name == model.file or wanted in (model.name, model.idea.replace(" ", "-")):
            return model
    remedy = meant(wanted, [model.call for model in models])
    raise UsageError(f"{problem.id} has no approach {name!r}", remedy=remedy)
