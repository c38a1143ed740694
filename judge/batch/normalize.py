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
    bound = {
        getattr(node, field)
        for node in nodes
        for field in _name_fields(node)
        if not isinstance(getattr(node, "ctx", None), ast.Load)
    }
    own = bound - _imported(nodes) - {entry}
    for node in nodes:
        _drop_remarks(node)
    nodes = list(ast.walk(tree))
    _number(nodes, own)
    words = sum(isinstance(node, ast.expr | ast.stmt | ast.arg | ast.operator | ast.cmpop) for node in nodes)
    return NormalForm("py " + ast.dump(tree, annotate_fields=False), words)


def _name_fields(node: ast.AST) -> list[str]:
    """The fields of a node that hold a name of the file's own: of a variable, a parameter, a function."""
    if isinstance(node, ast.keyword | ast.alias):
        return []
    return [field for field in ("id", "arg", "name", "rest") if isinstance(getattr(node, field, None), str)]


def _imported(nodes: list[ast.AST]) -> set[str]:
    aliases = [node for node in nodes if isinstance(node, ast.alias)]
    return {each.asname or each.name.partition(".")[0] for each in aliases}


def _drop_remarks(node: ast.AST) -> None:
    """Take away docstrings and other strings that stand for themselves."""
    for field in ("body", "orelse", "finalbody"):
        body = getattr(node, field, None)
        if body and isinstance(body, list):
            setattr(node, field, [each for each in body if not _is_remark(each)] or [ast.Pass()])


def _is_remark(node: ast.AST) -> bool:
    value = node.value if isinstance(node, ast.Expr) else None
    return isinstance(value, ast.Constant) and isinstance(value.value, str)


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
        for field in _name_fields(node):
            setattr(node, field, numbered(getattr(node, field)))
        if isinstance(node, ast.Global | ast.Nonlocal):
            node.names = [numbered(name) for name in node.names]
        if isinstance(node, ast.Constant):
            node.kind = None


# -- the judge's own other languages ----------------------------------------------------------------

_WORD = re.compile(r"[^\W\d]\w*+|\.?\d(?>(?:[eEpP][+-]|[\w.])*)|:=|::|->|=>|==|[^\w\s]")
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
    plain = [
        numbers.setdefault(word, f"_{len(numbers)}") if word in own and before not in _KEEPS else word
        for before, word in zip(["", *words], words, strict=False)
    ]
    return NormalForm(f"{language.id} " + "\x00".join(plain), len(words))


def _words(language: Language, text: str) -> Iterator[str]:
    """The words of a text; comments are none, a string is one."""
    start = 0
    for begin, end in (*unsaid(text, language.tokens), (len(text), len(text))):
        yield from _WORD.findall(text, start, begin)
        if begin < end and not text.startswith(("//", "/*"), begin):
            yield text[begin:end]
        start = end


def _declared(words: list[str]) -> set[str]:
    """The names that stand after a type or another word that declares, or before what gives them a value."""
    return {
        word
        for before, word, after in zip(["", *words], words, [*words[1:], ""], strict=False)
        if _is_name(word) and before not in _KEEPS and (_is_name(before) or after in _GIVES)
    }


def _is_name(word: str) -> bool:
    return word.isidentifier() and not _USES.fullmatch(word)
