"""The texts of a kata: statement.md with its worked examples, and hints.md.

A placeholder `{{name}}` in either stands for a number of problem.toml: bounds and tolerances are declared
once. A worked example is written as at Python's prompt, and is read as data, never run:

    >>> line_count(0, 0, 1, (0, 1), (4, 1))
    1

In a kata without entry `{{examples}}` stands for the input and the output of each case of EXAMPLES. Of a
dialogue the setter writes one down.

The hints go one step after another, from a nudge to nearly everything:

    # Anything                  a title, which nobody is shown
    ## What stays the same      the first step
    Its text, in Markdown.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from typing import Any

from msgspec import Struct, to_builtins

from judge.errors import nearest
from judge.problem.declare import InvalidCase
from judge.problem.formats import input_of, output_of
from judge.problem.model import Case, Example, GroupLimits, Problem, tupled
from judge.problem.module import Module
from judge.problem.toml import TomlFile, read_text
from judge.problem.transcripts import check_example, prompts, read_transcripts
from judge.values import check, parameters, show
from judge.values.answers import Tolerance
from judge.values.letters import TextType
from judge.values.types import lasting
from judge.values.wire import cut

_NEARLY = Tolerance(relative=Fraction(1, 10**9))  # of an example, whose answer is only shown
_STEP = "begin each step with a line '## Its title', and write its text below"
_BRIEF = 80  # characters of what is wrong: a message is one line, whatever stands in the file
# What reading a text as Python raises: MemoryError if nested deeply, TypeError for {[]} and its like.
_UNREADABLE = (SyntaxError, ValueError, TypeError, RecursionError, MemoryError)
_PLACEHOLDER = re.compile(r"\{\{\s*(.*?)\s*\}\}")


def read_statement(
    problem: Problem, module: Module, raw: Mapping[str, Any]
) -> tuple[str, tuple[Example, ...]]:
    """The text, its placeholders filled in from problem.toml, and its worked examples. Raises ProblemError.

    `raw` are the tables of problem.toml, with Decimals.
    """
    if not problem.entry:
        return _of_programs(problem, module, raw)
    text = "\n".join([*_filled(problem, "statement.md", raw), ""])
    if problem.methods:
        return text, read_transcripts(problem, text)
    examples = [
        Example(_case(typed, problem, line), _wanted(below, problem, line), line)
        for line, typed, below in prompts(text)
    ]
    return text, tuple(examples)


def _of_programs(problem: Problem, module: Module, raw: Mapping[str, Any]) -> tuple[str, tuple[Example, ...]]:
    """The same of a kata without entry."""
    assert module.format is not None
    examples, shown = [], []
    for number, case in enumerate(module.examples, 1):
        for parameter, value in zip(problem.parameters, case, strict=False):
            if fault := parameters.fault(parameter.type, parameter.name, value):
                raise problem.fault(f"EXAMPLES: case {number} is invalid: {fault}", "correct it")
        if len(case) != len(problem.parameters):
            takes = ", ".join(each.name for each in problem.parameters)
            raise problem.fault(f"EXAMPLES: case {number} is no case", f"write ({takes},) for each")
        try:
            exact = module.solve(*case)
        except InvalidCase as broken:
            raise problem.fault(f"EXAMPLES: case {number} is invalid: {broken}", "correct it") from None
        target = check.target(problem.answer, exact, _NEARLY)
        examples.append(Example(case, show.best(problem.answer, target), 0))
        if not problem.talks:
            given, wanted = input_of(problem, module.format, case), output_of(problem, module.format, target)
            shown.append(f"Input\n\n```\n{given}```\n\nOutput\n\n```\n{wanted}```\n")
    more = {} if problem.talks else {"examples": "\n".join(shown).rstrip()}
    lines = _filled(problem, "statement.md", raw, **more)
    for number, line in enumerate(read_text(problem.folder / "statement.md").splitlines(), 1):
        if line.lstrip().startswith(">>>"):
            what = "a kata without entry has no calls"
            remedy = "write a dialogue as text" if problem.talks else "write {{examples}}"
            raise problem.fault(what, remedy, number, "statement.md")
    return "\n".join([*lines, ""]), tuple(examples)


def _filled(problem: Problem, file: str, raw: Mapping[str, Any], **more: str) -> list[str]:
    """The file's lines, their placeholders replaced by what `raw` and `more` say. Raises ProblemError."""
    words, lines = _words(problem, raw) | more, []
    for number, line in enumerate(read_text(problem.folder / file).splitlines(), 1):
        for found in _PLACEHOLDER.finditer(line):
            if found[1] not in words:
                near = nearest(found[1], words)
                remedy = f"did you mean {{{{{near}}}}}?" if near else f"use one of {', '.join(words)}"
                raise problem.fault(f"unknown placeholder {found[0]}", remedy, number, file)
        lines.append(_PLACEHOLDER.sub(lambda found: words[found[1]], line))
    return lines


def _words(problem: Problem, raw: Mapping[str, Any]) -> dict[str, str]:
    """What the placeholders of texts stand for: each number as the file writes it, or a parameter's type."""
    tables = {}
    for each in problem.parameters:
        inner = lasting(each.type)
        own = inner if isinstance(inner, TextType) else each
        bounds = {"low": own.low, "high": own.high, "smallest": 0, "letters": each.type.letters}
        tables[each.name] = bounds | raw["parameters"].get(each.name, {})
    tables["limits"] = to_builtins(GroupLimits()) | raw.get("limits", {})
    if tolerance := raw.get("tolerance"):
        tables["tolerance"] = dict.fromkeys(Tolerance.__struct_fields__, 0) | tolerance
    words = {name: str(raw.get(name, "")) for name in ("entry", "title", "answer")}
    return words | {
        f"{table}.{key}": _written(value) for table, row in tables.items() for key, value in row.items()
    }


def _written(number: Any) -> str:
    small = isinstance(number, Decimal) and 0 < abs(number) < Decimal("1e-4")  # 1e-6, as well as 1e-7
    return (f"{number:e}" if small else str(number)).replace("E", "e").replace("e+", "e")


def _case(text: str, problem: Problem, line: int) -> Case:
    """The arguments of an example's call."""
    taken = problem.parameters
    try:
        match ast.parse(text, mode="eval").body:
            case ast.Call(ast.Name(problem.entry), given, []) if len(given) == len(taken):
                case = problem.kept(tuple(tupled(ast.literal_eval(each)) for each in given))
            case _:
                raise ValueError
    except _UNREADABLE:
        what = f"the example {cut(text, _BRIEF)!r} is not a call of {problem.entry} with plain values"
        remedy = f"write {problem.entry}({', '.join(each.name for each in taken)})"
        raise problem.fault(what, remedy, line, "statement.md") from None
    check_example(problem, case, line)
    return case


def _wanted(text: str, problem: Problem, line: int) -> Any:
    """The answer that an example shows."""
    try:
        answer = parameters.kept(problem.answer, tupled(ast.literal_eval(text)))
    except _UNREADABLE:
        what = f"the example's answer {cut(text, _BRIEF)!r} is not a plain value"
        remedy = "write numbers, texts, True, False, tuples, lists, dicts or None"
        if not text:
            what, remedy = "the example shows no answer", "write it on the next line (None as None)"
    else:
        fault = parameters.fault(problem.answer, "it", answer)
        if not fault:
            return parameters.listed(problem.answer, answer)
        what = f"the example's answer {cut(text, _BRIEF)!r} is none: {fault}"
        remedy = "correct it, or the answer that problem.toml declares"
    raise problem.fault(what, remedy, line, "statement.md")


# -- hints -------------------------------------------------------------------------------------------------


class Hint(Struct, frozen=True):
    """One step; `number` counts from 1."""

    number: int
    title: str
    text: str


def read_hints(problem: Problem) -> tuple[Hint, ...]:
    """The steps of a problem; none where there is no hints.md. Raises ProblemError where it is wrong."""
    if not problem.has_hints:
        return ()
    raw = TomlFile(problem.folder / "problem.toml", exact=True).raw
    steps: list[tuple[int, str, list[str]]] = []
    fenced = False  # in a code block, where a comment begins no step
    for line_number, line in enumerate(_filled(problem, "hints.md", raw), 1):
        fenced ^= line.startswith("```")
        if not fenced and f"{line} ".startswith("## "):
            steps.append((line_number, line[3:].strip(), []))
        elif steps:
            steps[-1][2].append(line)
        elif line.strip() and not line.startswith("# "):
            raise problem.fault("this text belongs to no step", _STEP, line_number, "hints.md")
    if not steps:
        raise problem.fault("it has no step", _STEP, file="hints.md")
    hints = []
    for number, (line_number, title, lines) in enumerate(steps, 1):
        text = "\n".join(lines).strip("\n")
        if not title or not text.strip():
            what = f"the step {title!r} has no title or says nothing"
            raise problem.fault(what, _STEP, line_number, "hints.md")
        hints.append(Hint(number, title, text))
    return tuple(hints)
