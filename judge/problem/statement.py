"""Reading statement.md: its placeholders and its worked examples.

A placeholder `{{name}}` stands for a number of problem.toml: bounds and tolerances are declared
once. A worked example is written as at Python's prompt, and is read as data, never run:

    >>> line_count(0, 0, 1, (0, 1), (4, 1))
    1
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping
from typing import Any

from judge.errors import ProblemError, nearest
from judge.problem.model import EXAMPLES, Argument, Case, Example, Problem
from judge.problem.text import read_text
from judge.values import parameters
from judge.values.atoms import Type

_BRIEF = 80  # characters of what is wrong
# What reading a text as Python raises: MemoryError if nested deeply, TypeError for {[]} and its like.
_UNREADABLE = (SyntaxError, ValueError, TypeError, RecursionError, MemoryError)
_PLACEHOLDER = re.compile(r"\{\{\s*(.*?)\s*\}\}")


def read_statement(problem: Problem, words: Mapping[str, str]) -> tuple[str, tuple[Example, ...]]:
    """The text with its placeholders filled in from `words`, and its worked examples. Raises ProblemError."""
    name = f"{problem.id}/statement.md"
    text = [
        filled(line, words, f"{name}:{number}")
        for number, line in enumerate(read_text(problem.folder / "statement.md").splitlines(), start=1)
    ]
    examples = tuple(
        Example(
            case=_call(call, problem, f"{name}:{number}"),
            wanted=_wanted(wanted, problem.answer, f"{name}:{number}"),
            line=number,
        )
        for number, call, wanted in _prompts(text)
    )
    if not examples and any(group.name == EXAMPLES for group in problem.groups):
        raise ProblemError(
            "a group wants the worked examples, and there are none",
            where=name,
            remedy=f"add a line >>> {problem.entry}(…) and the answer below it",
        )
    return "\n".join(text) + "\n", examples


def filled(line: str, words: Mapping[str, str], where: str) -> str:
    """The line with its placeholders replaced from `words`. Raises ProblemError."""

    def word(found: re.Match[str]) -> str:
        name = found[1]
        if name not in words:
            meant = nearest(name, words)
            remedy = f"did you mean {{{{{meant}}}}}?" if meant else f"use one of {', '.join(words)}"
            raise ProblemError(f"unknown placeholder {found[0]}", where=where, remedy=remedy)
        return words[name]

    return _PLACEHOLDER.sub(word, line)


def _prompts(text: list[str]) -> Iterator[tuple[int, str, str]]:
    """Each example: the line it starts on, its call and the answer below it, as text."""
    at = 0
    while at < len(text):
        start = at
        at += 1
        if not text[start].lstrip().startswith(">>>"):
            continue
        call = text[start].lstrip()[3:]
        while at < len(text) and text[at].lstrip().startswith("..."):
            call += text[at].lstrip()[3:]
            at += 1
        wanted = ""
        while at < len(text) and text[at].strip() and not text[at].lstrip().startswith((">>>", "```")):
            wanted += text[at].strip() + " "
            at += 1
        yield start + 1, call.strip(), wanted.strip()


def _call(text: str, problem: Problem, where: str) -> Case:
    remedy = f"write {problem.entry}({', '.join(each.name for each in problem.parameters)}) with plain values"
    try:
        call = ast.parse(text, mode="eval").body
    except _UNREADABLE:
        what = f"the example {_brief(text)!r} is no Python call"
        raise ProblemError(what, where=where, remedy=remedy) from None
    if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Name) or call.keywords:
        raise ProblemError(f"the example {_brief(text)!r} is no plain call", where=where, remedy=remedy)
    if call.func.id != problem.entry:
        raise ProblemError(f"the example calls {call.func.id!r}, not the entry", where=where, remedy=remedy)
    if len(call.args) != len(problem.parameters):
        what = f"the example gives {len(call.args)} arguments where {len(problem.parameters)} are wanted"
        raise ProblemError(what, where=where, remedy=remedy)
    try:
        case = tuple(_argument(ast.literal_eval(argument)) for argument in call.args)
    except _UNREADABLE:
        raise ProblemError(
            "the example's arguments are no plain values", where=where, remedy=remedy
        ) from None
    for parameter, value in zip(problem.parameters, case, strict=True):
        fault = parameters.fault(parameter.type, parameter.name, value)
        if fault:
            raise ProblemError(f"the example is invalid: {fault}", where=where, remedy="correct the example")
    return case


def _argument(value: Any) -> Argument:
    """Lists are kept as tuples; the parameter's type judges everything else."""
    return tuple(map(_argument, value)) if isinstance(value, list | tuple) else value


def _wanted(text: str, type_: Type, where: str) -> Any:
    if not text:
        raise ProblemError(
            "the example shows no answer", where=where, remedy="write it on the next line (None as None)"
        )
    try:
        answer = ast.literal_eval(text)
    except _UNREADABLE:
        what = f"the example's answer {_brief(text)!r} is no plain value"
        raise ProblemError(what, where=where, remedy="write numbers, words, tuples, lists or None") from None
    fault = parameters.fault(type_, "it", _argument(answer))
    if fault:
        what = f"the example's answer {_brief(text)!r} is none: {fault}"
        raise ProblemError(what, where=where, remedy="correct it, or the answer that problem.toml declares")
    return answer


def _brief(text: str) -> str:
    """A message is one line, whatever stands in the file."""
    return text if len(text) <= _BRIEF else f"{text[:_BRIEF]}…"
