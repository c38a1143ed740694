"""The file a kata begins with: signature and types, the statement's contract, its examples.

A stub compiles, and fails its problem: its function only says that it is still to be written. In Python the
examples are doctests, which pass once it is. They show numbers rounded, since the judge accepts more than one
double for an irrational number, and an int for a float. In another language all of it is comments.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from functools import partial
from inspect import getsource
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING

from judge.errors import UsageError, unwritable
from judge.files import new_file, read_ordinary, replace_file
from judge.languages import file_name, language_of
from judge.problem import Example, Problem
from judge.problem.find import typed
from judge.problem.transcripts import typed_lines
from judge.values import parameters
from judge.values.atoms import Type
from judge.values.calls import CallType
from judge.values.types import Composite, TupleType, lasting

if TYPE_CHECKING:
    from judge.languages.model import Language

_WIDTH = 88  # of a line, as formatters have it
_INDENT = "    "
_QUOTES = '"""'
_FENCE = "```"
_BLOCK = re.compile(r"^```.*?^```$|^#[^\n]*|(?:^(?!```|#)[^\n]*\S[^\n]*\n?)+", re.MULTILINE | re.DOTALL)
_wrapped = partial(textwrap.wrap, break_long_words=False, break_on_hyphens=False)
_ITEM = re.compile(r"\n(?=(?:[-*+]|\d+[.)])\s)")  # between two of a list


def usual_name(problem: str) -> str:
    """The usual name of the file for the problem of that id: one that Python can import."""
    return file_name(problem.replace("-", "_"))


def write_stub(problem: Problem, path: Path, *, over: bool = False, hidden: bool = False) -> Path | None:
    """Write the problem's stub, in the language that the file's name says; in Python where it says none.

    With `hidden` its folder is made where there is none, and git does not see that.

    Where there is a file, that is written over only with `over`: its text is kept beside it as FILE.bak, and
    that path is returned.

    Raises UsageError: there is a file, or none can be written there.
    """
    text = make_stub(problem, language_of(path), typed(problem)).encode()
    try:
        if hidden and not path.parent.exists():
            path.parent.mkdir()
            new_file(path.parent / ".gitignore", b"*\n")
        if over and path.exists():
            return write_over(path, text)
        new_file(path, text)
    except FileExistsError as fault:
        raise UsageError(f"{path} exists. Start over: add --reset") from fault
    except FileNotFoundError as fault:
        what, remedy = "its folder does not exist", f"make the folder {path.parent} first"
        raise UsageError(what, where=str(path), remedy=remedy) from fault
    except (OSError, ValueError) as fault:  # the latter for a NUL in the name
        raise unwritable(path, fault, "name another file") from fault
    return None


def write_over(path: Path, text: bytes) -> Path | None:
    """Write a file anew. Where it had another text, that is kept beside it, over no other file.

    Returns that file: FILE.bak, FILE.bak-2 and so on. Raises OSError.
    """
    old = read_ordinary(path)
    if old == text:
        return None
    names = (f"{path.name}.bak" + (f"-{number}" if number > 1 else "") for number in count(1))
    for kept in map(path.with_name, names):
        with suppress(FileExistsError):
            new_file(kept, old)
            replace_file(path, text)
            return kept
    raise AssertionError


def make_stub(problem: Problem, language: Language | None = None, name: str = "") -> str:
    """The text of the stub in that language, or in Python; `name` is what commands in it call the problem.

    Raises UsageError: the language has no form of one of the problem's types.
    """
    name = name or problem.id
    about = [
        *_wrapped(f"{problem.id}: {problem.title}.", _WIDTH - len(_QUOTES)),
        "",
        *_wrapped(f"`judge show {name}` shows the whole statement, `judge hint` the next hint.", _WIDTH),
        *_wrapped(f"`judge start {name}` judges this file on every save.", _WIDTH),
    ]
    if not problem.entry:
        return _program(problem, language, about)
    if language is not None:
        return _native(problem, language, about)
    return _class(problem, about) if problem.methods else _python(problem, about)


def _class(problem: Problem, about: Iterable[str]) -> str:
    """The text of a class that is still to be written."""
    type_, width = problem.parameters[-1].type, _WIDTH - len(_INDENT)
    assert isinstance(type_, CallType)
    lines = [*_wrapped(problem.summary, width - len(_QUOTES)), *_contract(problem, width, _typed)]
    rows = [f"class {problem.entry}:", *textwrap.indent(_docstring(lines), _INDENT).splitlines()]
    own = tuple((each.name, each.type) for each in problem.parameters[:-1])
    for name, takes, answer in (("__init__", own, None), *type_.methods):
        given = "".join(f", {each}: {taken.annotation}" for each, taken in takes)
        what = problem.entry if name == "__init__" else name
        rows += ["", f"{_INDENT}def {name}(self{given}) -> {answer.annotation if answer else None}:"]
        rows += [f'{2 * _INDENT}raise NotImplementedError("{what} is still to be written")']
    return "\n".join([_docstring(about), "", "", *rows]) + "\n"


def _typed(problem: Problem, example: Example) -> list[str]:
    """An example of calls in a row as at Python's prompt."""
    first, *calls = typed_lines(problem, example.case)
    rows = [f">>> {first}"]
    for call, wanted in zip(calls, example.wanted, strict=True):
        rows += [f">>> {call}", *([] if wanted is None else [repr(wanted)])]
    return rows


def _program(problem: Problem, language: Language | None, about: Iterable[str]) -> str:
    """The text of a program that is still to be written: its task, as a comment where it has no docstring."""
    width = _WIDTH if language is None else _WIDTH - len(language.comment) - 1
    lines = [*about, "", *_wrapped(problem.summary, width), *_contract(problem, width, _doctest)]
    if language is not None:
        return _commented(language, lines) + "\n"
    raised = f'raise NotImplementedError("{problem.id} is still to be written")'
    return f"{_docstring(lines)}\n\nimport sys\n\n{raised}\n"


def _python(problem: Problem, about: Iterable[str]) -> str:
    answer, width = problem.answer, _WIDTH - len(_INDENT)
    signature = _signature(problem)
    named = [answer, *(parameter.type for parameter in problem.parameters)]
    meanings = dict(meaning for type_ in named for meaning in _aliases(type_))
    types = [f"{name} = {meant}" for name, meant in sorted(meanings.items())]
    if re.search(r"\barray\b", signature):  # which takes no parameters at run time before Python 3.12
        types = ["from __future__ import annotations", "", "from array import array", "", *types]
    lines = [*_wrapped(problem.summary, width - len(_QUOTES)), *_contract(problem, width, _doctest)]
    body = f'{_docstring(lines)}\nraise NotImplementedError("{problem.entry} is still to be written")'
    parts = ["\n".join([_docstring(about), "", *types]).rstrip()]
    parts.append(f"{signature}\n{textwrap.indent(body, _INDENT)}")
    if answer.measured and problem.examples and _settled(problem):
        parts.append(getsource(rounded).rstrip())
    return "\n\n\n".join(parts) + "\n"


def _signature(problem: Problem) -> str:
    given = ", ".join(f"{each.name}: {each.type.annotation}" for each in problem.parameters)
    head, tail = f"def {problem.entry}(", f") -> {problem.answer.annotation}:"
    if len(head + given + tail) <= _WIDTH:
        return head + given + tail
    return "\n".join([head, *_wrapped(_INDENT + given, _WIDTH, subsequent_indent=_INDENT), tail])


def rounded(answer: object) -> object:
    """Round the answer as the examples show it: a whole number has no point."""
    if isinstance(answer, list | tuple):
        return type(answer)(map(rounded, answer))
    if isinstance(answer, float):
        answer = round(answer, 6)
        return int(answer) if answer.is_integer() else answer
    return answer


def _native(problem: Problem, language: Language, about: Iterable[str]) -> str:
    from judge.languages.shapes import Unsupported
    from judge.languages.signature import signature_of
    from judge.languages.sources import why_no_class
    from judge.languages.spec import spec_of
    from judge.languages.spell import Writer

    try:
        spec = spec_of(language, signature_of(problem))
        writer = Writer(language, spec)
        head, before, body = map(writer.text, ("head", "before", "body"))
        before = before.rstrip()
    except Unsupported as why:
        what = f"{problem.id} has a type that functions in {language.name} are not called with: {why}"
        remedy = f"write a program that reads standard input; see 'judge show {problem.id}'"
        if problem.methods and not language.classes:
            what, remedy = why_no_class(language, problem.entry), ""
        raise UsageError(what, remedy=remedy) from None
    indent = _INDENT if head.startswith("static") else ""

    def told(problem: Problem, example: Example) -> list[str]:
        if problem.methods:
            return [_INDENT + row for row in _typed(problem, example)]
        literals = zip(problem.parameters, _literals(problem, example), strict=True)
        given = ", ".join(f"{each.name} = {literal}" for each, literal in literals)
        return [f"{_INDENT}{spec.entry}: {given}  gives  {example.wanted!r}"]

    lines = [problem.summary, *_contract(problem, _WIDTH - len(indent + language.comment) - 1, told)]
    function = f"{_commented(language, lines, indent)}\n{indent}{head}{body}"
    return "\n\n".join(filter(None, (_commented(language, about), before, function))) + "\n"


def _commented(language: Language, lines: Iterable[str], indent: str = "") -> str:
    return "\n".join(f"{indent}{language.comment} {line}".rstrip() for line in lines)


def _aliases(type_: Type) -> Iterator[tuple[str, str]]:
    """The names that an annotation uses beside Python's own, with what they stand for."""
    type_ = lasting(type_)
    for part in type_.parts(1) if isinstance(type_, Composite) else ():
        yield from _aliases(part)
    if isinstance(type_, TupleType) and type_.alias:
        yield type_.alias, type_.spelled


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
    wanted, room = example.wanted, _WIDTH - 2 * len(_INDENT)
    given = _literals(problem, example)
    literals = [each.replace(" ", "\0") if len(each) < room - 4 else each for each in given]
    call = f"{problem.entry}({', '.join(literals)})"
    if not _settled(problem):
        return _wrapped(f"{call} may return {wanted!r}".replace("\0", " "), _WIDTH - len(_INDENT))
    if problem.answer.measured:
        call, wanted = f"rounded({call})", rounded(wanted)
    call = f"print({call})" if wanted is None else call
    rows = enumerate(_wrapped(call, room, subsequent_indent=_INDENT))
    lines = [f"{'...' if at else '>>>'} {row}".replace("\0", " ") for at, row in rows]
    return [*lines, repr(wanted)]


def _literals(problem: Problem, example: Example) -> list[str]:
    values = zip(problem.parameters, example.case, strict=True)
    return [parameters.literal(each.type, value) for each, value in values]


# -- the statement without what the stub has or cannot use ---------------------------------------------------


def _contract(problem: Problem, width: int, prompt: Callable[[Problem, Example], list[str]]) -> Iterator[str]:
    """The statement in lines of at most `width` columns where it is prose, each part after a blank line.

    Without the title, the task and figures, which the stub has or cannot show, and without what concerns
    programs that read standard input. `prompt` writes an example.
    """
    examples = {example.line: example for example in problem.examples}
    heading, skipped = "", False  # of a section: one that has said nothing yet; whether it is left out
    for block in _BLOCK.finditer(problem.statement):
        text, lines = block[0], block[0].splitlines()
        start = problem.statement.count("\n", 0, block.start()) + 1
        told = [examples[line] for line in range(start, start + len(lines)) if line in examples]
        rows: list[str] = []
        if text.startswith("#"):
            heading = text if text.startswith("##") else ""
            skipped = "program" in heading.lower() and problem.entry not in heading
        elif told:
            rows = [row for example in told for row in prompt(problem, example)]
        elif text.startswith(_FENCE):
            rows = [_INDENT + line for line in lines[1:-1]]
        elif text.startswith(("|", _INDENT)):
            rows = lines
        elif not text.startswith(("![", f"Write `{problem.entry}(")):
            for item in _ITEM.split(text):
                said = " ".join(item.split())
                if "is run as a program" not in said:
                    hanging = " " * (said.index(" ") + 1) if _ITEM.match(f"\n{said}") else ""
                    rows += _wrapped(said, width, subsequent_indent=hanging)
        if rows and not skipped:
            yield from ("", heading, "", *rows) if heading else ("", *rows)
            heading = ""
