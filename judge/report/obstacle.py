"""What keeps a file from running at all, and what to do, in a sentence or two."""

from __future__ import annotations

import os
import shlex
import sys
from pathlib import Path

from judge.errors import nearest
from judge.languages import file_name
from judge.problem import Problem
from judge.run.result import Hurdle, Obstacle, Result
from judge.sandbox.boundary import IMPORTING

_ONE_FILE = "a submission is one file"
_KNOWN = ("numpy", "scipy", "sympy", "mpmath", "shapely")  # of the modules that Python does not bring


def obstacle_text(result: Result, hurdle: Hurdle, problem: Problem) -> str:
    """The obstacle and the remedy in a sentence or two."""
    entry = problem.entry
    call = f"{entry}({', '.join(parameter.name for parameter in problem.parameters)})"
    match hurdle.kind:
        case Obstacle.STUB:
            line = f" (line {hurdle.line})" if hurdle.line else ""
            return f"Write the body of {entry}{line}, then save."
        case Obstacle.ARITY:
            count = len(problem.parameters)
            return f"{entry} takes {hurdle.takes} arguments and is called with {count}: {call}"
        case Obstacle.MODULE:
            return _missing_module(result, hurdle.name)
        case Obstacle.IMPORT:
            message = result.failure.message.removesuffix(IMPORTING) if result.failure else ""
            more = ", or use 'judge run --mode program'" if message.startswith("EOFError") else ""
            return f"{message} ends the import; put what only you need below if __name__ == '__main__':{more}"
        case Obstacle.NESTED:
            return f"{entry} stands in a class or another function: move it out, to the left margin"
        case Obstacle.MISNAMED:
            return f"there is no {entry}; is {hurdle.name} meant to be it? Rename it: def {call}"
        case Obstacle.NO_ENTRY:
            return (
                f"there is no {entry}: write def {call}, which returns the answer; "
                "a print at the top level answers nothing"
            )


def _missing_module(result: Result, name: str) -> str:
    top = name.partition(".")[0]
    beside = Path(result.submission).parent / top
    if any(os.path.lexists(path) for path in (beside, beside.with_name(file_name(top)))):
        return f"{top} cannot be imported: {_ONE_FILE}; move what it needs of {top} into it"
    meant = None if top in _KNOWN else nearest(top, [*_KNOWN, *sys.stdlib_module_names])
    if meant:
        return f"there is no module {top}; did you mean {meant}? {_ONE_FILE.capitalize()}"
    install = shlex.join([sys.executable, "-m", "pip", "install", top])
    return f"there is no module {top} where the judge runs, and {_ONE_FILE}. To add it: {install}"
