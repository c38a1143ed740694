"""A program without what can be changed while it stays the same: the author's own names, spacing, comments.

Two sources of one normal form are the same program under other names; of two that differ, nothing is said.
Python is parsed, never run. Other languages are read word by word: a name is numbered only where the file
declares or assigns it, so that `sqrt` never becomes `fabs`; some renamings are missed that way.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.cache import digest
from judge.errors import JudgeError
from judge.languages import SUFFIX, language_of
from judge.languages.scan import reading, unsaid
from judge.problem.solutions import LONGEST, tree_of_stranger

if TYPE_CHECKING:
    from judge.languages.model import Language


class NormalForm(Struct, frozen=True):
    """What is compared, and of how many words the program is."""

    text: str
    words: int


def normal_form(source: bytes, name: str, entry: str = "") -> NormalForm:
    """The normal form of a file called `name`; `entry` is a name that stays as it is.

    A source that cannot be read, or is longer than any that a person writes, is its own form.
    """
    if len(source) <= LONGEST:
        try:
            if name.endswith(SUFFIX):
                return _of_python(source, entry)
            language = language_of(name)
            if language is not None and language.comment == "//" and language.is_ours:
                with reading():
                    return _of_words(language, source.decode(), language.spelt(entry) if entry else "")
        except (SyntaxError, ValueError, RecursionError, JudgeError):  # not to be read, so itself
            pass
    return NormalForm(digest(source), len(source.split()))


# -- Python ------------------------------------------------------------------------------------------------


def _of_python(source: bytes, entry: str) -> NormalForm:
    tree = tree_of_stranger(source)
    nodes = list(ast.walk(tree))
    own = {name for node in nodes for name in _bound(node)} - _imported(nodes) - {entry}
    for node in nodes:
        _drop_remarks(node)
    nodes = list(ast.walk(tree))
    _number(nodes, own)
    words = sum(isinstance(node, ast.expr | ast.stmt | ast.arg | ast.operator | ast.cmpop) for node in nodes)
    return NormalForm("py " + ast.dump(tree, annotate_fields=False), words)


def _bound(node: ast.AST) -> Iterator[str]:
    """The names that a node gives to something."""
    match node:
        case ast.Name(id=name, ctx=ast.Store() | ast.Del()) | ast.arg(arg=name):
            yield name
        case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
            yield name
        case ast.ExceptHandler(name=str(name)) | ast.MatchAs(name=str(name)) | ast.MatchStar(name=str(name)):
            yield name
        case ast.MatchMapping(rest=str(name)):
            yield name


def _imported(nodes: list[ast.AST]) -> set[str]:
    aliases = [each for node in nodes if isinstance(node, ast.Import | ast.ImportFrom) for each in node.names]
    return {each.asname or each.name.partition(".")[0] for each in aliases}


def _drop_remarks(node: ast.AST) -> None:
    """Take away docstrings and other strings that stand for themselves."""
    for field in ("body", "orelse", "finalbody"):
        body = getattr(node, field, None)
        if isinstance(body, list):
            kept = [each for each in body if not _is_remark(each)]
            setattr(node, field, kept or [ast.Pass()] if body else [])


def _is_remark(node: ast.AST) -> bool:
    match node:
        case ast.Expr(value=ast.Constant(value=str())):
            return True
    return False


def _number(nodes: list[ast.AST], own: set[str]) -> None:
    """Give every name of `own` its number, in the order of appearance.

    The name of an argument in a call stays, unless the function called is the author's own.
    """
    numbers: dict[str, str] = {}

    def numbered(name: str) -> str:
        return numbers.setdefault(name, f"_{len(numbers)}") if name in own else name

    for node in nodes:
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in own:
            for keyword in node.keywords:
                keyword.arg = numbered(keyword.arg) if keyword.arg else None
    for node in nodes:
        for field in ("id", "arg", "name", "rest"):
            value = getattr(node, field, None)
            if isinstance(value, str) and not isinstance(node, ast.keyword | ast.alias):
                setattr(node, field, numbered(value))
        if isinstance(node, ast.Global | ast.Nonlocal):
            node.names = [numbered(name) for name in node.names]
        if isinstance(node, ast.Constant):
            node.kind = None


# -- the judge's own other languages ----------------------------------------------------------------

_WORD = re.compile(
    r"""(?P<name>[^\W\d]\w*+)
    |(?P<number>\.?\d(?>(?:[eEpP][+-]|[\w.])*))
    |(?P<sign>:=|::|->|=>|==|[^\w\s])""",
    re.VERBOSE,
)
# After one of these a name is not a new one, but something used.
_USES = re.compile(
    r"return|else|case|goto|new|throws?|in|of|do|await|yield|typeof|delete|instanceof|sizeof|import|package|use"
    r"|using|namespace|include|define|mod|crate|extern|not|and|or|go|defer|range|if|while|match|loop|move|break"
    r"|continue|extends|implements|operator"
)
_GIVES = frozenset(("=", ":=", ":", "=>"))
_KEEPS = frozenset((".", "::", "->", "#"))


def _of_words(language: Language, text: str, entry: str) -> NormalForm:
    words = list(_words(language, text))
    own = _declared(words) - {entry, "main", "Main", "self", "this"}
    numbers: dict[str, str] = {}
    plain = []
    for place, (kind, word) in enumerate(words):
        part = place > 0 and words[place - 1][1] in _KEEPS
        if kind == "name" and word in own and not part:
            word = numbers.setdefault(word, f"_{len(numbers)}")
        plain.append(word)
    return NormalForm(f"{language.id} " + "\x00".join(plain), len(words))


def _words(language: Language, text: str) -> Iterator[tuple[str, str]]:
    """The words of a text, each with its kind; comments are none, a string is one."""
    start = 0
    for begin, end in unsaid(text, language.tokens):
        yield from _between(text, start, begin)
        if not text.startswith(("//", "/*"), begin):
            yield "text", text[begin:end]
        start = end
    yield from _between(text, start, len(text))


def _between(text: str, start: int, end: int) -> Iterator[tuple[str, str]]:
    return ((found.lastgroup or "", found[0]) for found in _WORD.finditer(text, start, end))


def _declared(words: list[tuple[str, str]]) -> set[str]:
    """The names that stand after a type or another word that declares, or before what gives them a value."""
    found = set()
    for place, (kind, word) in enumerate(words):
        if kind != "name" or _USES.fullmatch(word):
            continue
        before = words[place - 1] if place else ("sign", "")
        after = words[place + 1][1] if place + 1 < len(words) else ""
        if before[1] in _KEEPS:
            continue
        declared = before[0] == "name" and not _USES.fullmatch(before[1])
        if declared or after in _GIVES:
            found.add(word)
    return found
