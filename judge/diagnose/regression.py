"""Failing cases as a pytest file of their own: it imports the submission by its path and needs no judge.

A function in another language than Python cannot be imported, and what a problem itself accepts has
no bounds: there the test replays the case with the judge.

The file begins with a line that says who wrote it. A file that does not is never added to.
"""

from __future__ import annotations

import os
import re
from itertools import count
from pathlib import Path

from judge.atomic import replace_file
from judge.data.model import ProblemData
from judge.errors import UsageError, unwritable
from judge.languages import language_of
from judge.problem.model import case_of
from judge.reading import read_ordinary_text
from judge.run.result import Failure
from judge.values import Target, Type, check, parameters, show

_MARK = "# Written by `judge run --save-regression`, which adds more cases at the end."
_HEAD = f'''{_MARK}
"""Cases that broke a submission once: each calls its function and holds the answer against exact bounds."""

import importlib.util
from pathlib import Path


def called(place, entry, *arguments):
    """What the function `entry` of the file at `place`, seen from this one, answers."""
    path = Path(__file__).parent / place
    spec = importlib.util.spec_from_file_location(path.stem.replace("-", "_"), path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return getattr(module, entry)(*arguments)
'''
_REPLAYED = """\
    # {command}
    import subprocess
    import sys

    command = [sys.executable, "-m", "judge", "replay", {replay!r}, str(Path(__file__).parent / {place!r})]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
"""
_IMPORTS = {  # what few tests need
    "array(": "    from array import array",
    "Fraction(": "    from fractions import Fraction",
}


def is_ours(path: Path) -> bool:
    """Whether `path` was written here, or is empty. Raises UsageError if it cannot be read."""
    content = _read(path)
    return content.startswith(_MARK) or not content.strip()


def add_case(path: Path, submission: Path, data: ProblemData, found: Failure) -> bool:
    """Add the counterexample to `path`; False if it was there already.

    Raises:
        UsageError: the file cannot be read or written, or was not written here.
        ProblemError: `solve` fails.
    """
    assert found.replay is not None
    content = _read(path) if path.exists() else ""
    if content.strip() and not content.startswith(_MARK):
        raise UsageError("this file was not written by --save-regression", where=str(path))
    place = os.path.relpath(submission.resolve(), path.resolve().parent)
    lines = _case(place, data, found)
    if lines in content:
        return False
    case = f"def {_free_name(place, found, content)}():\n{lines}"
    try:
        replace_file(path, ((content if content.strip() else _HEAD) + "\n\n" + case).encode())
    except OSError as fault:
        raise unwritable(path, fault, "name another file with --save-regression") from fault
    return True


def _case(place: str, data: ProblemData, found: Failure) -> str:
    """The body of the test."""
    problem = data.problem
    group = problem.group(found.group or "")
    assert group is not None
    assert found.input is not None
    case = case_of(found.input)
    answer, tolerance = data.exact(case, group)
    target = check.target(problem.answer, answer, tolerance)
    if language_of(place) is not None or _is_decided(target):
        return _REPLAYED.format(command=f"judge replay {found.replay}", replay=found.replay, place=place)
    values = zip(problem.parameters, case, strict=True)
    arguments = "".join(
        f"        {parameters.literal(parameter.type, value)},\n" for parameter, value in values
    )
    conditions = _asserts(problem.answer, target)
    lines = [
        f"    # judge replay {found.replay}",
        *(line for name, line in _IMPORTS.items() if any(name in text for text in (arguments, *conditions))),
        f"    answer = called(\n        {place!r},\n        {problem.entry!r},\n{arguments}    )",
        *conditions,
    ]
    return "\n".join(lines) + "\n"


def _is_decided(target: Target) -> bool:
    """Whether the problem itself says which answers are right, of the whole or of a part."""
    if type(target) is dict:
        return "such as" in target or any(map(_is_decided, target.values()))
    return isinstance(target, list | tuple) and any(map(_is_decided, target))


def _free_name(place: str, found: Failure, content: str) -> str:
    """A name that no other test of the file has: two files of the same name may fail on the same case."""
    problem, group, *_, check = (found.replay or "").split(":")
    words = f"test_{Path(place).stem}_{problem}_{group}_{check}"
    # Not every letter of a file's name may stand in a function's: not "²", nor a half of a surrogate pair.
    name = "".join(letter if f"_{letter}".isidentifier() else "_" for letter in words)
    taken = set(re.findall(r"def (\w++)\(\)", content))
    names = (name if number == 1 else f"{name}_{number}" for number in count(1))
    return next(name for name in names if name not in taken)


def _asserts(answer: Type, target: Target) -> list[str]:
    conditions = show.asserts(answer, "answer", target)
    return [f"    assert {condition}" for condition in conditions]


def _read(path: Path) -> str:
    try:
        return read_ordinary_text(path)
    except OSError as fault:
        reason = (fault.strerror or "unknown").lower()
        raise UsageError(f"cannot be read ({reason})", where=str(path)) from fault
    except ValueError:  # not text: somebody else's
        return "\0"
