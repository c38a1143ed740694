"""The file that a kata begins with in another language: types, the contract as comments, the head."""

from __future__ import annotations

from collections.abc import Iterator

from judge.errors import UsageError
from judge.kata.contract import contract_lines
from judge.languages.draft import draft_of, driver_of
from judge.languages.model import Language
from judge.languages.shapes import Unsupported
from judge.languages.signature import signature_of
from judge.problem import Example, Problem
from judge.values import parameters

_WIDTH = 88


def make_native_stub(problem: Problem, language: Language) -> str:
    """The text of the stub: it compiles, and its function only says that it is still to be written.

    Raises:
        UsageError: the language has no form of one of the problem's types.
    """
    try:
        maker = driver_of(language)
        draft = draft_of(language, signature_of(problem))
        head = maker.declared(draft)
    except Unsupported as why:
        what = f"{problem.id} has a type that functions in {language.name} are not called with: {why}"
        remedy = f"write a program that reads standard input; see 'judge show {problem.id}'"
        raise UsageError(what, remedy=remedy) from None
    before, body = maker.frame(draft, f"{draft.entry} is still to be written")
    indent = "    " if head.startswith("static") else ""

    def told(example: Example) -> list[str]:
        return [_example(problem, draft.entry, example)]

    width = _WIDTH - len(indent) - len(language.comment) - 1
    lines = [problem.summary, "", *contract_lines(problem, width, told)]
    about = [
        f"{problem.id}: {problem.title}.",
        "",
        f"`judge show {problem.id}` shows the whole statement, `judge hint` the next hint.",
        "`judge watch` judges this file on every save.",
    ]
    parts = ["\n".join(_comments(about, language)), before]
    function = "\n".join([*(indent + each for each in _comments(lines, language)), indent + head + body])
    return "\n\n".join([*filter(None, parts), function]) + "\n"


def _comments(lines: list[str], language: Language) -> Iterator[str]:
    for line in lines:
        yield f"{language.comment} {line}".rstrip()


def _example(problem: Problem, entry: str, example: Example) -> str:
    values = zip(problem.parameters, example.case, strict=True)
    arguments = ", ".join(
        f"{parameter.name} = {parameters.literal(parameter.type, value)}" for parameter, value in values
    )
    return f"    {entry}: {arguments}  gives  {example.wanted!r}"
