"""What a program reads and writes for a case, as the FORMAT of problem.py says: the setter's own code."""

from __future__ import annotations

from typing import TYPE_CHECKING

from judge.problem.declare import Format
from judge.problem.model import Case, Problem
from judge.problem.module import blaming
from judge.values import parameters, show

if TYPE_CHECKING:
    from judge.values.answers import Target

_SHOWN = 60  # characters of what is no text


def input_of(problem: Problem, own: Format, case: Case) -> str:
    """The input of a program for a case. Raises ProblemError."""
    with blaming(problem, "FORMAT: write fails"):
        assert own.write is not None, "a dialogue has no input"
        text = own.write(*problem.calls([case])[0])
    return _text(problem, "write", text)


def output_of(problem: Problem, own: Format, target: Target) -> str:
    """The output of a perfect program. Raises ProblemError."""
    if own.show is None:
        return show.line(problem.answer, target) + "\n"
    with blaming(problem, "FORMAT: show fails"):
        text = own.show(parameters.given(problem.answer, show.best(problem.answer, target)))
    return _text(problem, "show", text)


def _text(problem: Problem, name: str, text: object) -> str:
    if isinstance(text, str) and text.isascii() and (text.endswith("\n") or (name == "show" and not text)):
        return text
    what = f"FORMAT: {name} gives {repr(text)[:_SHOWN]}"
    raise problem.fault(what, "return ASCII text that ends in a line feed")
