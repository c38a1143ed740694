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
_PROMPT = r"(?m)^[ \t]*>>>(.*(?:\n[ \t]*\.\.\..*)*)((?:\n(?![ \t]*(?:>>>|```|$)).+)*)"


def prompts(text: str) -> Iterator[tuple[int, str, str]]:
    """Each prompt in a statement: on which line, what is typed there, and what stands below it."""
    for found in re.finditer(_PROMPT, text):
        line = text.count("\n", 0, found.start()) + 1
        typed, below = re.sub(r"\n[ \t]*\.\.\.", "", found[1]), re.sub(r"\s*\n\s*", " ", found[2])
        yield line, typed.strip(), below.strip()


def check_example(problem: Problem, case: Case, line: int) -> None:
    """Hold a worked example's arguments against the types of the parameters. Raises ProblemError."""
    for parameter, value in zip(problem.parameters, case, strict=True):
        if fault := parameters.fault(parameter.type, parameter.name, value):
            what = f"the example is invalid: {fault}"
            raise problem.fault(what, "correct the example", line, "statement.md")


def read_transcripts(problem: Problem, text: str) -> tuple[Example, ...]:
    """The worked examples in a statement. Raises ProblemError."""
    found: list[Example] = []
    name = ""  # of the object
    for line, typed, below in prompts(text):
        try:
            match ast.parse(typed).body:
                case [ast.Assign([ast.Name(name)], ast.Call(ast.Name(problem.entry), given, []))]:
                    found.append(Example((*map(_literal, given), ()), [], line))
                case [ast.Expr(ast.Call(ast.Attribute(ast.Name(own), method), given, []))] if own == name:
                    *made, calls = found[-1].case
                    answer = tupled(ast.literal_eval(below)) if below else None
                    wanted = [*found[-1].wanted, answer]
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
        check_example(problem, example.case, example.line)
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
