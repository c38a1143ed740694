"""The file a kata begins with: signature and types, the statement's contract, its examples as doctests.

A stub is valid Python that a type checker, a linter and a formatter accept, and it fails its problem: its
function only says that it is still to be written. The doctests pass once it is. They show numbers rounded,
since the judge accepts more than one double for an irrational number, and an int for a float.
"""

from __future__ import annotations

import ast
import re
import textwrap
from collections.abc import Iterator
from typing import Any

from judge.errors import ProblemError
from judge.kata.contract import contract_lines
from judge.language import file_name as program_name
from judge.problem import AnswerKind, Example, ParameterType, Problem

_WIDTH = 88  # of a line, as formatters have it
_INDENT = "    "
_QUOTES = '"""'
_DIGITS = 6  # decimals in the doctests
_TYPES = {
    ParameterType.NUMBER: "float",  # for which an int is welcome
    ParameterType.INTEGER: "int",
    ParameterType.POINT: "Point",
    ParameterType.INTEGER_POINT: "IntPoint",
}
_ANSWERS = {
    AnswerKind.COUNT: "int | None",
    AnswerKind.POINTS: "list[Point]",
    AnswerKind.PARAMETER: "float | None",
}
_ALIASES = {"Point": "tuple[float, float]", "IntPoint": "tuple[int, int]"}
_ROUNDED = {
    AnswerKind.POINTS: f'''\
def rounded(points: list[Point]) -> list[Point]:
    """Round the answer as the examples show it; 0.0 stands for -0.0 too."""
    return [(round(x, {_DIGITS}) + 0.0, round(y, {_DIGITS}) + 0.0) for x, y in points]''',
    AnswerKind.PARAMETER: f'''\
def rounded(t: float | None) -> float | None:
    """Round the answer as the examples show it; 0.0 stands for -0.0 too."""
    return None if t is None else round(t, {_DIGITS}) + 0.0''',
}


def file_name(problem: Problem) -> str:
    """The usual name of a problem's file: one that Python can import."""
    return program_name(problem.id.replace("-", "_"))


def make_stub(problem: Problem) -> str:
    """The text of the stub.

    Raises:
        ProblemError: what the setter wrote makes no Python.
    """
    parts = [_head(problem), _function(problem)]
    if problem.answer in _ROUNDED and problem.examples:
        parts.append(_ROUNDED[problem.answer])
    text = "\n\n\n".join(parts) + "\n"
    try:
        ast.parse(text)
    except (SyntaxError, ValueError) as fault:
        what = f"no stub can be made of it: {fault}"
        where = f"{problem.id}/problem.toml"
        raise ProblemError(what, where=where, remedy="write entry and parameters as plain names") from None
    return text


def _head(problem: Problem) -> str:
    """What the file is, the commands to go on with, and the types that the signature names."""
    about = [
        f"`judge show {problem.id}` shows the whole statement, `judge hint` the next hint.",
        "`judge watch` judges this file on every save.",
    ]
    title = _wrapped(f"{problem.id}: {problem.title}.", _WIDTH - len(_QUOTES))
    docstring = f"{_QUOTES}{_quoted([*title, '', *about])}\n{_QUOTES}"
    signature = _signature(problem)
    aliases = [
        f"{name} = {meant}" for name, meant in _ALIASES.items() if re.search(rf"\b{name}\b", signature)
    ]
    return "\n".join([docstring, *([""] if aliases else []), *aliases])


def _wrapped(text: str, width: int) -> list[str]:
    return textwrap.wrap(text, width, break_long_words=False, break_on_hyphens=False)


def _function(problem: Problem) -> str:
    lines = contract_lines(problem, _WIDTH - len(_INDENT), lambda example: _doctest(problem, example))
    summary = _wrapped(problem.summary, _WIDTH - len(_INDENT + _QUOTES))
    docstring = _quoted([*summary, "", *lines], _INDENT)
    return "\n".join(
        [
            _signature(problem),
            f"{_INDENT}{_QUOTES}{docstring}",
            f"{_INDENT}{_QUOTES}",
            f'{_INDENT}raise NotImplementedError("{problem.entry} is still to be written")',
        ]
    )


def _signature(problem: Problem) -> str:
    """The `def` line, broken as formatters break it where it is too long."""
    parameters = [f"{each.name}: {_TYPES[each.type]}" for each in problem.parameters]
    head, tail = f"def {problem.entry}(", f") -> {_ANSWERS[problem.answer]}:"
    inner = ", ".join(parameters)
    if len(head + inner + tail) <= _WIDTH:
        return head + inner + tail
    if len(_INDENT + inner) <= _WIDTH:
        return f"{head}\n{_INDENT}{inner}\n{tail}"
    return "\n".join([head, *(f"{_INDENT}{parameter}," for parameter in parameters), tail])


def _quoted(lines: list[str], indent: str = "") -> str:
    """The lines as they stand between a docstring's quotes."""
    escaped = (line.replace("\\", "\\\\").replace(_QUOTES, r"\"\"\"") for line in lines)
    first, *rest = (line.rstrip() for line in escaped)
    return "\n".join([first, *(indent + line if line else "" for line in rest)])


def _doctest(problem: Problem, example: Example) -> list[str]:
    """An example as at Python's prompt; None, which the prompt does not show, is printed."""
    opened, closed = "", ""
    wanted: Any = example.wanted
    if problem.answer in _ROUNDED:
        opened, closed = "rounded(", ")"
        wanted = _rounded(wanted)
    if wanted is None:
        opened, closed = f"print({opened}", f"{closed})"
    arguments = [repr(argument) for argument in example.case]
    call = list(_filled(f"{opened}{problem.entry}(", arguments, f"){closed}"))
    return [*(f"{'...' if at else '>>>'} {row}" for at, row in enumerate(call)), repr(wanted)]


def _filled(head: str, arguments: list[str], tail: str) -> Iterator[str]:
    """A call in rows that fit into a docstring beside the prompt."""
    room = _WIDTH - len(_INDENT) - len(">>> ")
    row = head
    for at, argument in enumerate(arguments):
        piece = argument + (tail if at == len(arguments) - 1 else ",")
        gap = "" if row in (head, _INDENT) else " "
        if len(row) + len(gap) + len(piece) > room and row.strip():
            yield row
            row, gap = _INDENT, ""
        row += gap + piece
    yield row


def _rounded(wanted: Any) -> Any:
    """What the stub's own `rounded` makes of an answer."""
    if wanted is None:
        return None
    if isinstance(wanted, list | tuple):
        return [(round(x, _DIGITS) + 0.0, round(y, _DIGITS) + 0.0) for x, y in wanted]
    return round(wanted, _DIGITS) + 0.0
