"""Cases as a pytest file of their own: it imports the submission by its path and needs no judge.

A function in another language than Python cannot be imported, and where several answers are right, bounds do
not say it: such a test runs `judge try`.
"""

from __future__ import annotations

import os
import re
from itertools import count
from pathlib import Path

from judge.diagnose.replay import encode
from judge.languages import language_of
from judge.run.tried import Tried
from judge.values import parameters, show
from judge.values.answers import Target

MARK = b"# Written by `judge "  # how the file begins, those of earlier versions too
_HEAD = '''# Written by `judge try --pytest`, which adds more cases at the end.
"""Each test calls the function of a submission with one case, and checks the answer by exact bounds."""

import importlib.util
from pathlib import Path


def called(place, entry, *arguments):
    """The answer of the function `entry` in the file at `place`, a path from here."""
    path = Path(__file__).parent / place
    spec = importlib.util.spec_from_file_location(path.stem.replace("-", "_"), path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return getattr(module, entry)(*arguments)
'''
_RUN = """\
    # judge try {replay}
    import subprocess
    import sys

    command = [sys.executable, "-m", "judge", "try", {replay!r}, str(Path(__file__).parent / {place!r})]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
"""
_IMPORTS = {  # what few tests need
    "array(": "    from array import array",
    "Fraction(": "    from fractions import Fraction",
}


def with_case(content: str, path: Path, submission: Path, tried: Tried) -> str:
    """The text of the pytest file at `path`, with a test of the submission on this case at its end.

    `content` is the text that is there, or empty; a test that it has already is not added again.
    """
    replay = encode(tried.problem, tried.group, tried.case)
    place = os.path.relpath(submission.resolve(), path.resolve().parent)
    body = _body(place, replay, tried)
    if body in content:
        return content
    return f"{content if content.strip() else _HEAD}\n\ndef {_free_name(place, replay, content)}():\n{body}"


def _body(place: str, replay: str, tried: Tried) -> str:
    problem = tried.problem
    if language_of(place) is not None or _is_decided(tried.target):
        return _RUN.format(replay=replay, place=place)
    values = zip(problem.parameters, tried.case, strict=True)
    arguments = "".join(
        f"        {parameters.literal(parameter.type, value)},\n" for parameter, value in values
    )
    conditions = [f"    assert {each}" for each in show.asserts(problem.answer, "answer", tried.target)]
    lines = [
        f"    # judge try {replay}",
        *(line for name, line in _IMPORTS.items() if any(name in text for text in (arguments, *conditions))),
        f"    answer = called(\n        {place!r},\n        {problem.entry!r},\n{arguments}    )",
        *conditions,
    ]
    return "\n".join(lines) + "\n"


def _is_decided(target: Target) -> bool:
    """Whether several answers are right, of the whole or of a part."""
    return type(target) is dict or (isinstance(target, list | tuple) and any(map(_is_decided, target)))


def _free_name(place: str, replay: str, content: str) -> str:
    """A name that no other test of the file has: two files of the same name may get the same case."""
    problem, group, *_, check = replay.split(":")
    words = f"test_{Path(place).stem}_{problem}_{group}_{check}"
    # Not every letter of a file's name may stand in a function's: not "²", nor a half of a surrogate pair.
    name = "".join(letter if f"_{letter}".isidentifier() else "_" for letter in words)
    taken = set(re.findall(r"def (\w++)\(\)", content))
    names = (name if number == 1 else f"{name}_{number}" for number in count(1))
    return next(name for name in names if name not in taken)
