"""What is said of a file that could answer nothing: the obstacle, and what to do."""

from __future__ import annotations

import os
import shlex
import sys
from pathlib import Path

from judge.errors import one_slip
from judge.languages import file_name, spelt
from judge.problem import Problem, Verdict
from judge.problem.solutions import install_command, requirement
from judge.run.result import EntryError, EntryKind
from judge.sandbox.boundary import IMPORTING

_ONE_FILE = "a submission is one file"
_KNOWN = ("numpy", "scipy", "sympy", "mpmath", "shapely")  # of the modules that Python does not bring
# What brings a module of another name, or of one that is nearly another's.
_PACKAGES = {"attr": "attrs", "cv2": "opencv-python", "PIL": "pillow", "yaml": "pyyaml"}
_PACKAGES |= {"skimage": "scikit-image", "sklearn": "scikit-learn"}


def entry_text(error: EntryError, problem: Problem, submission: str, verdict: Verdict, message: str) -> str:
    """The obstacle and the remedy in a sentence or two; `message` is the failure's."""
    entry, count = problem.entry, len(problem.parameters)
    call = f"{entry}({', '.join(parameter.name for parameter in problem.parameters)})"
    definition = f"class {entry}" if problem.methods else f"def {call}"
    line = f" (line {error.line})" if error.line else ""
    library = requirement(Path(submission))
    match error.kind:
        case EntryKind.STUB:
            what = f"the body of {spelt(entry, submission)}" if entry else "the program"
            return f"Write {what}{line}, then save."
        case EntryKind.NO_CLASS:
            return f"{entry} is a function{line}; the kata asks for a class with {error.name}."
        case EntryKind.NO_ENTRY if problem.methods:
            return f"The kata asks for a class, and a program cannot be asked: write class {entry}."
        case EntryKind.ARITY:
            return f"{entry} takes {error.takes} arguments and is called with {count}: {call}"
        case EntryKind.MODULE if library:
            return f"{library.partition('==')[0]} is not installed: {install_command(library)}"
        case EntryKind.MODULE:
            return _missing_module(submission, error.name)
        case EntryKind.IMPORT:
            ended = message.removesuffix(IMPORTING)
            if library:
                return f"{ended} ends the import. It calls {library}: {install_command(library)}"
            more = ", or use 'judge run --mode program'" if ended.startswith("EOFError") else ""
            return f"{ended} ends the import; put what only you need below if __name__ == '__main__':{more}"
        case EntryKind.NESTED if error.name:
            text = f"Is {error.name} in {error.within}{line} meant? "
            text += f"Rename it {entry} and move it to the left margin."
        case EntryKind.NESTED:
            text = f"{entry} stands in {error.within}{line}: move it out, to the left margin"
        case EntryKind.TEXT | EntryKind.COMMENT:
            text = f"{entry} stands in a {error.kind.value}{line}: it is never defined"
        case EntryKind.MISNAMED if odd := next((letter for letter in error.name if letter > "~"), ""):
            text = f"{error.name}{line} has {odd!r} (U+{ord(odd):04X}). Type it anew: {entry}"
        case EntryKind.MISNAMED:
            text = f"There is no {entry}; is {error.name}{line} meant? Rename it: {definition}"
        case EntryKind.EMPTY:
            return "The file holds no program."
        case EntryKind.NO_ENTRY:
            text = f"There is no {entry}: write def {call}, which returns the answer"
            text += "; a print at the top level answers nothing." if error.name else "."
            if verdict is not Verdict.WA:
                text = f"Or write def {call}, which is called."
    # What ended it is known, the rest is a guess.
    return text if verdict is Verdict.WA else f"{message}. {text}"


def _missing_module(submission: str, name: str) -> str:
    top = name.partition(".")[0]
    beside = Path(submission).parent / top
    if any(os.path.lexists(path) for path in (beside, beside.with_name(file_name(top)))):
        return f"{top} cannot be imported: {_ONE_FILE}; move what it needs of {top} into it"
    meant = next((each for each in (*_KNOWN, *sorted(sys.stdlib_module_names)) if one_slip(top, each)), None)
    if meant and top not in _PACKAGES:
        return f"There is no module {top}; did you mean {meant}? {_ONE_FILE.capitalize()}"
    install = shlex.join([sys.executable, "-m", "pip", "install", _PACKAGES.get(top, top)])
    return f"There is no module {top} here. To add it: {install}"
