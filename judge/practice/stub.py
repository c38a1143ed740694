"""The file a kata begins with: signature and types, the statement's contract, its examples.

A stub compiles, and fails its problem: its function only says that it is still to be written. In Python the
examples are doctests, which pass once it is. They show numbers rounded, since the judge accepts more than one
double for an irrational number, and an int for a float. In another language all of it is comments.
"""

from __future__ import annotations

import ast
import re
import textwrap
from collections.abc import Callable, Iterable, Iterator
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Any

from judge.errors import ProblemError, UsageError
from judge.files import new_file, read_ordinary, replace_file
from judge.languages import file_name as program_name
from judge.languages import language_of
from judge.problem import Example, Problem
from judge.values import parameters
from judge.values.atoms import Type
from judge.values.types import Composite, ListType, OptionalType, TupleType, lasting

if TYPE_CHECKING:
    from judge.languages.model import Language

_DECIMALS = 6  # of a number in a doctest
_WIDTH = 88  # of a line, as formatters have it
_INDENT = "    "
_QUOTES = '"""'
_ITEM = re.compile(r"(?:[-*+]|\d+[.)])\s+")
_HEADING = re.compile(r"(#+)\s")
_FENCE = "```"


def file_name(problem: Problem) -> str:
    """The usual name of a problem's file: one that Python can import."""
    return usual_name(problem.id)


def usual_name(problem: str) -> str:
    """The same by the problem's id."""
    return program_name(problem.replace("-", "_"))


def write_stub(problem: Problem, path: Path, *, over: bool = False) -> Path | None:
    """Write the problem's stub, in the language that the file's name says; in Python where it says none.

    Where there is a file, that is written over only with `over`: its text is kept beside it as FILE.bak, and
    that path is returned.

    Raises:
        UsageError: there is a file, or none can be written there.
        ProblemError: no stub can be made of the problem.
    """
    text = make_stub(problem, language_of(path)).encode()
    where, kept = str(path), None
    try:
        if not path.name or path.is_dir():
            raise UsageError("this is a folder", where=where or "''", remedy="name a file in it")
        if over and path.exists():
            old = read_ordinary(path)
            if old != text:
                kept = _kept_beside(path, old)
                replace_file(path, text)
        else:
            new_file(path, text)
    except FileExistsError as fault:
        raise UsageError(f"{where} exists. Start over: add --reset") from fault
    except FileNotFoundError as fault:
        remedy = f"make the folder {path.parent} first"
        raise UsageError("its folder does not exist", where=where, remedy=remedy) from fault
    except (OSError, ValueError) as fault:  # ValueError: a NUL in the name
        reason = (getattr(fault, "strerror", None) or str(fault)).lower()
        raise UsageError(f"cannot be written ({reason})", where=where, remedy="name another file") from fault
    return kept


def _kept_beside(path: Path, text: bytes) -> Path:
    """Write a file's text beside it, over no other: FILE.bak, FILE.bak-2 and so on. Raises OSError."""
    for number in count(1):
        kept = path.with_name(f"{path.name}.bak" + (f"-{number}" if number > 1 else ""))
        try:
            new_file(kept, text)
        except FileExistsError:
            continue
        return kept
    raise AssertionError


def make_stub(problem: Problem, language: Language | None = None) -> str:
    """The text of the stub in that language, or in Python.

    Raises:
        ProblemError: what the setter wrote makes no Python.
        UsageError: the language has no form of one of the problem's types.
    """
    about = [
        *_wrapped(f"{problem.id}: {problem.title}.", _WIDTH - len(_QUOTES)),
        "",
        f"`judge show {problem.id}` shows the whole statement, `judge hint` the next hint.",
        f"`judge start {problem.id}` judges this file on every save.",
    ]
    return _python(problem, about) if language is None else _native(problem, language, about)


def _python(problem: Problem, about: Iterable[str]) -> str:
    entry, answer, width = problem.entry, problem.answer, _WIDTH - len(_INDENT)
    signature = _signature(problem)
    named = [answer, *(parameter.type for parameter in problem.parameters)]
    meanings = dict(meaning for type_ in named for meaning in _aliases(type_))
    types = [f"{name} = {meant}" for name, meant in sorted(meanings.items()) if _names(signature, name)]
    if _names(signature, "array"):  # which takes no parameters at run time before Python 3.12
        types = ["from __future__ import annotations", "", "from array import array", "", *types]
    lines = [*_wrapped(problem.summary, width - len(_QUOTES)), *_contract(problem, width, _doctest)]
    body = [_docstring(lines), f'raise NotImplementedError("{entry} is still to be written")']
    parts = [
        "\n".join([_docstring(about), "", *types]).rstrip(),
        f"{signature}\n{textwrap.indent(chr(10).join(body), _INDENT)}",
    ]
    if answer.measured and problem.examples and _settled(problem):
        name = answer.several if isinstance(lasting(answer), ListType) else "answer"
        name = answer.words.answer if answer.words.answer.isidentifier() else name
        rows = [f"def rounded({name}: {answer.annotation}) -> {answer.annotation}:"]
        rows.append(f'{_INDENT}"""Round the answer as the examples show it; 0.0 stands for -0.0 too."""')
        expression = _rounded(answer, name)
        if expression.startswith("None if "):
            test, _, expression = expression.removeprefix("None if ").partition(" else ")
            rows += [f"{_INDENT}if {test}:", f"{_INDENT * 2}return None"]
        if len(f"{_INDENT}return {expression}") <= _WIDTH:
            rows.append(f"{_INDENT}return {expression}")
        else:
            wrapped = _wrapped(expression, width - len(_INDENT))
            rows += [f"{_INDENT}return (", *(_INDENT * 2 + row for row in wrapped), f"{_INDENT})"]
        parts.append("\n".join(rows))
    text = "\n\n\n".join(parts) + "\n"
    try:
        ast.parse(text)
    except (SyntaxError, ValueError) as fault:
        what = f"no stub can be made of it: {getattr(fault, 'msg', fault)}"
        where = f"{problem.id}/problem.toml"
        raise ProblemError(what, where=where, remedy="write entry and parameters as plain names") from None
    return text


def _native(problem: Problem, language: Language, about: Iterable[str]) -> str:
    from judge.languages.draft import draft_of, driver_of
    from judge.languages.shapes import Unsupported
    from judge.languages.signature import signature_of

    try:
        maker = driver_of(language)
        draft = draft_of(language, signature_of(problem))
        head = maker.declared(draft)
    except Unsupported as why:
        what = f"{problem.id} has a type that functions in {language.name} are not called with: {why}"
        remedy = f"write a program that reads standard input; see 'judge show {problem.id}'"
        raise UsageError(what, remedy=remedy) from None
    before, body = maker.frame(draft, f"{draft.entry} is still to be written")
    indent = _INDENT if head.startswith("static") else ""

    def told(problem: Problem, example: Example) -> list[str]:
        values = zip(problem.parameters, example.case, strict=True)
        given = [f"{each.name} = {parameters.literal(each.type, value)}" for each, value in values]
        return [f"{_INDENT}{draft.entry}: {', '.join(given)}  gives  {example.wanted!r}"]

    def comments(lines: Iterable[str], indent: str = "") -> list[str]:
        return [f"{indent}{language.comment} {line}".rstrip() for line in lines]

    lines = [problem.summary, *_contract(problem, _WIDTH - len(indent + language.comment) - 1, told)]
    function = "\n".join([*comments(lines, indent), indent + head + body])
    return "\n\n".join([*filter(None, ("\n".join(comments(about)), before)), function]) + "\n"


def _signature(problem: Problem) -> str:
    """The `def` line, broken as formatters break it where it is too long."""
    given = [f"{each.name}: {each.type.annotation}" for each in problem.parameters]
    head, tail = f"def {problem.entry}(", f") -> {problem.answer.annotation}:"
    inner = ", ".join(given)
    if len(head + inner + tail) <= _WIDTH:
        return head + inner + tail
    if len(_INDENT + inner) <= _WIDTH:
        return f"{head}\n{_INDENT}{inner}\n{tail}"
    return "\n".join([head, *(f"{_INDENT}{parameter}," for parameter in given), tail])


def _aliases(type_: Type) -> Iterator[tuple[str, str]]:
    """The names that an annotation uses beside Python's own, with what they stand for."""
    type_ = lasting(type_)
    for part in type_.parts(1) if isinstance(type_, Composite) else ():
        yield from _aliases(part)
    if isinstance(type_, TupleType) and type_.alias:
        yield type_.alias, type_.spelled


def _rounded(type_: Type, what: str) -> str:
    """The expression that rounds the numbers of an answer."""
    inner = lasting(type_)
    if not type_.measured:
        return what
    if isinstance(type_, OptionalType):
        return f"None if {what} is None else {_rounded(inner, what)}"
    if isinstance(type_, TupleType):
        parts = (_rounded(part, f"{what}[{at}]") for at, part in enumerate(type_.made_of))
        return f"({', '.join(parts)})"
    if isinstance(type_, ListType):
        item = type_.item
        if isinstance(item, TupleType) and item.is_vector:
            parts = (_rounded(part, name) for part, name in zip(item.made_of, item.names, strict=True))
            return f"[({', '.join(parts)}) for {', '.join(item.names)} in {what}]"
        return f"[{_rounded(item, 'item')} for item in {what}]"
    return f"round({what}, {_DECIMALS}) + 0.0"


def _names(signature: str, name: str) -> bool:
    return re.search(rf"\b{name}\b", signature) is not None


def _docstring(lines: Iterable[str]) -> str:
    text = "\n".join(line.rstrip() for line in lines)
    escaped = text.replace("\\", "\\\\").replace(_QUOTES, r"\"\"\"")
    return f"{_QUOTES}{escaped}\n{_QUOTES}"


def _settled(problem: Problem) -> bool:
    """Whether an example shows the right answer: who is asked for nothing has more than one."""
    return problem.answer.settled and bool(problem.parameters)


def _doctest(problem: Problem, example: Example) -> list[str]:
    """An example as at Python's prompt; None, which the prompt does not show, is printed.

    Where an answer of one's own looks different and is right as well, it is told instead.
    """
    wanted: Any = example.wanted
    values = zip(problem.parameters, example.case, strict=True)
    literals = [parameters.literal(each.type, value) for each, value in values]
    room = _WIDTH - len(_INDENT + ">>> " + _INDENT)
    given = ", ".join(each.replace(" ", "\0") if len(each) < room else each for each in literals)
    call = f"{problem.entry}({given})"
    if not _settled(problem):
        told = f"{call} may return {wanted!r}".replace("\0", " ")
        return _wrapped(told, _WIDTH - len(_INDENT))
    if problem.answer.measured:
        call, wanted = f"rounded({call})", eval(_rounded(problem.answer, "wanted"), {"wanted": wanted})
    call = f"print({call})" if wanted is None else call
    rows = [call] if len(call) <= room + len(_INDENT) else _wrapped(call, room + len(_INDENT), _INDENT)
    lines = [f"{'...' if at else '>>>'} {row}".replace("\0", " ") for at, row in enumerate(rows)]
    return [*lines, repr(wanted)]


# -- the statement without what the stub has or cannot use ---------------------------------------------------


def _contract(problem: Problem, width: int, prompt: Callable[[Problem, Example], list[str]]) -> Iterator[str]:
    """The statement in lines of at most `width` columns where it is prose, each part after a blank line.

    Without the title, the task and figures, which the stub has or cannot show, and without what concerns
    programs that read standard input. `prompt` writes an example.
    """
    examples = {example.line: example for example in problem.examples}
    skipped = 0  # the level of the heading whose section is left out
    heading_rows: list[str] = []  # of a section that has said nothing yet
    for start, block in _blocks(problem.statement):
        first = block[0]
        rows: list[str] = []
        if heading := _HEADING.match(first):
            level = len(heading[1])
            if level > 1 and (not skipped or level <= skipped):
                skipped = level if "program" in first.lower() and problem.entry not in first else 0
            heading_rows = block if level > 1 else []
        elif told := [examples[line] for line in range(start, start + len(block)) if line in examples]:
            rows = [row for example in told for row in prompt(problem, example)]
        elif first.startswith(_FENCE):
            rows = textwrap.indent("\n".join(block[1:-1]), _INDENT).splitlines()
        elif first.startswith(("|", _INDENT)):
            rows = block
        elif not first.startswith(("![", f"Write `{problem.entry}(")):
            for item in _items(block):
                marker = _ITEM.match(item)
                if "is run as a program" not in item:
                    rows += _wrapped(item, width, " " * (marker.end() if marker else 0))
        if rows and not skipped:
            for part in (heading_rows, rows):
                yield from ("", *part) if part else ()
            heading_rows = []


def _blocks(text: str) -> Iterator[tuple[int, list[str]]]:
    """What stands between blank lines, headings and fences, each with its first line's number, from 1."""
    block: list[str] = []
    fenced = False
    for number, line in enumerate([*text.splitlines(), ""], 1):
        begins = line.startswith(_FENCE) or _HEADING.match(line) is not None
        if block and not fenced and (begins or not line.strip() or _HEADING.match(block[0])):
            yield number - len(block), block
            block = []
        if fenced or line.strip():
            block = [*block, line]
        if line.startswith(_FENCE):
            if fenced:
                yield number + 1 - len(block), block
                block = []
            fenced = not fenced


def _items(block: Iterable[str]) -> list[str]:
    """The items of a list, or the one paragraph, each in one line."""
    found: list[str] = []
    for line in block:
        if not found or _ITEM.match(line):
            found.append(line.strip())
        else:
            found[-1] += f" {line.strip()}"
    return found


def _wrapped(text: str, width: int, hanging: str = "") -> list[str]:
    return textwrap.wrap(
        text, width, subsequent_indent=hanging, break_long_words=False, break_on_hyphens=False
    )
