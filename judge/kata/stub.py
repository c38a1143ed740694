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
from judge.languages import file_name as program_name
from judge.problem import Example, Problem
from judge.values import parameters

_WIDTH = 88  # of a line, as formatters have it
_INDENT = "    "
_QUOTES = '"""'
_IMPORTS = {"array": "from array import array"}
_LATE = "from __future__ import annotations"  # before Python 3.12 an array takes no parameters at run time


def file_name(problem: Problem) -> str:
    """The usual name of a problem's file: one that Python can import."""
    return usual_name(problem.id)


def usual_name(problem: str) -> str:
    """The same by the problem's id."""
    return program_name(problem.replace("-", "_"))


def make_stub(problem: Problem) -> str:
    """The text of the stub.

    Raises:
        ProblemError: what the setter wrote makes no Python.
    """
    parts = [_head(problem), _function(problem)]
    if problem.answer.rounded and problem.examples and _settled(problem):
        parts.append(_rounding(problem))
    text = "\n\n\n".join(parts) + "\n"
    try:
        ast.parse(text)
    except (SyntaxError, ValueError) as fault:
        what = f"no stub can be made of it: {getattr(fault, 'msg', fault)}"
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
    named = [problem.answer, *(parameter.type for parameter in problem.parameters)]
    meanings = {name: meant for type_ in named for name, meant in type_.aliases().items()}
    aliases = [
        f"{name} = {meant}"
        for name, meant in sorted(meanings.items())
        if re.search(rf"\b{name}\b", signature)
    ]
    imports = [line for name, line in _IMPORTS.items() if re.search(rf"\b{name}\b", signature)]
    if imports:
        imports = [_LATE, "", *imports]
    return "\n".join([docstring, *([""] if imports else []), *imports, *([""] if aliases else []), *aliases])


def _rounding(problem: Problem) -> str:
    """The function that the doctests round with."""
    answer = problem.answer
    name = answer.words.answer if answer.words.answer.isidentifier() else answer.variable
    return "\n".join(
        [
            f"def rounded({name}: {answer.annotation}) -> {answer.annotation}:",
            f'{_INDENT}"""Round the answer as the examples show it; 0.0 stands for -0.0 too."""',
            *_returned(answer.rounded.format(name)),
        ]
    )


def _returned(expression: str) -> Iterator[str]:
    """The lines that return it, broken as formatters break them where one is too long."""
    line = f"{_INDENT}return {expression}"
    whole = ast.parse(expression, mode="eval").body
    if len(line) <= _WIDTH or not isinstance(whole, ast.IfExp | ast.ListComp | ast.Tuple):
        yield line
    elif isinstance(whole, ast.ListComp):
        yield f"{_INDENT}return ["
        yield f"{_INDENT * 2}{ast.unparse(whole.elt)}"
        yield from (f"{_INDENT * 2}{ast.unparse(each).strip()}" for each in whole.generators)
        yield f"{_INDENT}]"
    elif isinstance(whole, ast.IfExp):
        yield f"{_INDENT}if {ast.unparse(whole.test)}:"
        yield f"{_INDENT * 2}return {ast.unparse(whole.body)}"
        yield from _returned(ast.unparse(whole.orelse))
    else:
        yield f"{_INDENT}return ("
        for part in whole.elts:
            yield from _part(part, 2)
        yield f"{_INDENT})"


def _part(part: ast.expr, depth: int) -> Iterator[str]:
    """A part of a tuple in lines of its own, so many levels deep, broken in the same way."""
    line = f"{_INDENT * depth}{ast.unparse(part)},"
    if len(line) <= _WIDTH or not isinstance(part, ast.Tuple):
        yield line
        return
    yield f"{_INDENT * depth}("
    for inner in part.elts:
        yield from _part(inner, depth + 1)
    yield f"{_INDENT * depth}),"


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
    parameters = [f"{each.name}: {each.type.annotation}" for each in problem.parameters]
    head, tail = f"def {problem.entry}(", f") -> {problem.answer.annotation}:"
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
    """An example as at Python's prompt; None, which the prompt does not show, is printed.

    Where an answer of one's own looks different and is right as well, it is told instead.
    """
    opened, closed = "", ""
    wanted: Any = example.wanted
    if problem.answer.rounded and _settled(problem):
        opened, closed = "rounded(", ")"
        wanted = parameters.rounded(problem.answer, wanted)
    if wanted is None:
        opened, closed = f"print({opened}", f"{closed})"
    values = zip(problem.parameters, example.case, strict=True)
    arguments = [parameters.literal(parameter.type, value) for parameter, value in values]
    if not _settled(problem):
        return list(_filled(f"{problem.entry}(", arguments, f") may return {wanted!r}"))
    call = list(_filled(f"{opened}{problem.entry}(", arguments, f"){closed}"))
    return [*(f"{'...' if at else '>>>'} {row}" for at, row in enumerate(call)), repr(wanted)]


def _settled(problem: Problem) -> bool:
    """Whether an example shows the right answer: who is asked for nothing has more than one."""
    return problem.answer.settled and bool(problem.parameters)


def _filled(head: str, arguments: list[str], tail: str) -> Iterator[str]:
    """A call in rows that fit into a docstring beside the prompt."""
    room = _WIDTH - len(_INDENT) - len(">>> ")
    row = head if arguments else head + tail
    for at, argument in enumerate(arguments):
        piece = argument + (tail if at == len(arguments) - 1 else ",")
        gap = "" if row in (head, _INDENT) else " "
        if len(row) + len(gap) + len(piece) > room and row.strip():
            yield row
            row, gap = _INDENT, ""
        row += gap + piece
    yield row
