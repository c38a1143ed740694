"""Calls in a row as at Python's prompt: the worked examples of a statement, and how a case is written.

>>> cache = LRUCache(1)
>>> cache.put(1, 10)
>>> cache.get(1)
10
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Sequence
from typing import Any

from msgspec.structs import replace

from judge.problem.model import Case, Example, Problem, tupled
from judge.values import parameters
from judge.values.atoms import Type
from judge.values.calls import CallType, ReturnType, shown_call

_BRIEF = 80  # characters of what is wrong


def read_transcripts(problem: Problem, text: str, prompt: str) -> tuple[Example, ...]:
    """The worked examples in a statement; `prompt` finds each line that is typed, and what follows it.

    Raises ProblemError.
    """
    found: list[Example] = []
    name = ""  # of the object
    for each in re.finditer(prompt, text):
        line = text.count("\n", 0, each.start()) + 1
        typed = re.sub(r"\n[ \t]*\.\.\.", "", each[1]).strip()
        try:
            match ast.parse(typed).body:
                case [ast.Assign([ast.Name(name)], ast.Call(ast.Name(problem.entry), given, []))]:
                    found.append(Example((*map(_literal, given), ()), [], line))
                case [ast.Expr(ast.Call(ast.Attribute(ast.Name(own), method), given, []))] if own == name:
                    *made, calls = found[-1].case
                    wanted = [*found[-1].wanted, _answer(each[2])]
                    case = (*made, (*calls, (method, *map(_literal, given))))
                    found[-1] = Example(case, wanted, found[-1].line)
                case _:
                    raise ValueError
        except (SyntaxError, ValueError, TypeError, RecursionError, MemoryError):
            what = f"the example {typed[:_BRIEF]!r} is no call with plain values"
            remedy = f"begin with {var_of(problem)} = {problem.entry}(…), then call its methods"
            raise problem.fault(what, remedy, line, "statement.md") from None
    for at, read in enumerate(found):
        example = replace(read, case=problem.kept(read.case))
        if len(example.case) != len(problem.parameters):
            takes = ", ".join(each.name for each in problem.parameters[:-1])
            what = f"the example makes {problem.entry} of other arguments"
            raise problem.fault(what, f"write {problem.entry}({takes})", example.line, "statement.md")
        for parameter, value in zip(problem.parameters, example.case, strict=True):
            if fault := parameters.fault(parameter.type, parameter.name, value):
                what = f"the example is invalid: {fault}"
                raise problem.fault(what, "correct the example", example.line, "statement.md")
        pairs = zip(_answer_types(problem, example.case), example.wanted, strict=True)
        wanted = [parameters.kept(type_, value) if type_ else value for type_, value in pairs]
        found[at] = replace(example, wanted=listed_answers(problem, example.case, wanted))
    return tuple(found)


def _answer_types(problem: Problem, case: Case) -> list[Type | None]:
    type_ = problem.answer
    assert isinstance(type_, ReturnType)
    return [type_.of(call).answer for call in case[-1]]


def listed_answers(problem: Problem, case: Case, wanted: Sequence[Any]) -> list[Any]:
    """What an example's calls return, as their types have it; also where JSON has lost it."""
    return [
        parameters.listed(type_, each) if type_ and not parameters.fault(type_, "it", each) else each
        for type_, each in zip(_answer_types(problem, case), wanted, strict=True)
    ]


def _literal(node: ast.expr) -> Any:
    return tupled(ast.literal_eval(node))


def _answer(text: str) -> Any:
    """What is written below a call; nothing stands for None."""
    written = re.sub(r"\s*\n\s*", " ", text).strip()
    return tupled(ast.literal_eval(written)) if written else None


def var_of(problem: Problem) -> str:
    """What an object is called: `cache` of LRUCache."""
    words = re.findall(r"[A-Z]+(?![a-z])|[A-Z][a-z0-9]*|[a-z0-9]+", problem.entry)
    name = words[-1].lower() if words else "made"
    return name if name != problem.entry else f"a_{name}"


def typed_lines(problem: Problem, case: Case) -> Iterator[str]:
    """What is typed for a case, a line for the object and one for each call."""
    *own, calls = case
    given = ", ".join(
        parameters.literal(each.type, value) for each, value in zip(problem.parameters, own, strict=False)
    )
    name = var_of(problem)
    yield f"{name} = {problem.entry}({given})"
    type_ = problem.parameters[-1].type
    assert isinstance(type_, CallType)
    yield from (f"{name}.{shown_call(call)}" for call in type_.listed(calls))
