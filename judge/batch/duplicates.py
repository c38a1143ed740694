"""Submissions of different students to one problem that are one program but for names, spacing and comments.

Nothing but equality is told: no likeness, no share, no verdict. Short solutions of a kata are often alike, so
that programs of fewer than `LEAST` words are left out.

What is compared is a normal form. Python is parsed, never run, and loses the author's own names. Other
languages are read word by word, and keep them.
"""

from __future__ import annotations

import ast
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from pathlib import PurePath
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.batch.model import Submission
from judge.cache import digest
from judge.errors import JudgeError, ProblemError
from judge.languages import SUFFIX, language_of
from judge.languages.scan import reading, unsaid
from judge.practice.stub import make_stub
from judge.problem import Problem
from judge.problem.solutions import LONGEST, tree_of_stranger
from judge.report.published_klass import Alike

if TYPE_CHECKING:
    from judge.languages.model import Language

# Of 339 functions in independent accepted programs equal pairs have at most 41 words, such as the dot product
# of two points. No two such programs are equal; a whole one of twice that is no accident any more.
LEAST = 80


def equal_files(
    submissions: Iterable[Submission], problems: Mapping[str, Problem], least: int = LEAST
) -> list[Alike]:
    """The sets of equal files, by problem and then by the first student's name.

    `problems` are those submitted to, by id: the name of the entry function is nobody's own choice, and a
    stub is nobody's own work. Submissions that are not judged, or without a source, take no part.
    """
    stubs = {name: _stub(problem) for name, problem in problems.items()}
    forms: dict[tuple[str, str, bytes], NormalForm] = {}
    found: dict[tuple[str, str], list[Submission]] = defaultdict(list)
    for each in submissions:
        if each.why or not each.source:
            continue
        problem, text = problems.get(each.problem), (each.problem, PurePath(each.file).suffix, each.source)
        if text not in forms:
            forms[text] = normal_form(each.source, each.file, problem.entry if problem else "")
        form = forms[text]
        if form.words >= least and form.text != stubs.get(each.problem):
            found[each.problem, form.text].append(each)
    sets = [_alike(group) for group in found.values() if _several(group)]
    return sorted(sets, key=lambda each: (each.problem, each.students, each.files))


def _stub(problem: Problem) -> str:
    """The normal form of the file that the kata begins with, for Python."""
    try:
        return normal_form(make_stub(problem).encode(), f"stub{SUFFIX}", problem.entry).text
    except ProblemError:  # then nobody has been given one
        return ""


def _several(group: Iterable[Submission]) -> bool:
    """Whether several students have submitted them, and not one file as a group."""
    members: dict[str, set[str]] = defaultdict(set)
    for each in group:
        members[each.file].add(each.student)
    return len({*map(frozenset, members.values())}) > 1


def _alike(group: list[Submission]) -> Alike:
    group = sorted(group, key=lambda each: (each.student, each.file))
    same_bytes = len({each.source for each in group}) == 1
    gone = "names, spacing and comments" if group[0].file.endswith(SUFFIX) else "spacing and comments"
    return Alike(
        problem=group[0].problem,
        what="identical files" if same_bytes else f"identical after removing {gone}",
        students=tuple(dict.fromkeys(each.student for each in group)),
        files=tuple(each.file for each in group),
    )


# -- normal forms ------------------------------------------------------------------------------------------


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
                    words = list(_words(language, source.decode()))
                return NormalForm(f"{language.id} " + "\x00".join(words), len(words))
        except (SyntaxError, ValueError, RecursionError, JudgeError):  # not to be read, so itself
            pass
    return NormalForm(digest(source), len(source.split()))


# -- Python ------------------------------------------------------------------------------------------------


def _of_python(source: bytes, entry: str) -> NormalForm:
    tree = tree_of_stranger(source)
    nodes = list(ast.walk(tree))
    names = [(node, field) for node in nodes for field in _name_fields(node)]
    bound = {
        getattr(node, field) for node, field in names if not isinstance(getattr(node, "ctx", None), ast.Load)
    }
    aliases = (node for node in nodes if isinstance(node, ast.alias))
    own = bound - {each.asname or each.name.partition(".")[0] for each in aliases} - {entry}
    numbers: dict[str, str] = {}  # in the order of appearance

    def numbered(name: str) -> str:
        return numbers.setdefault(name, f"_{len(numbers)}") if name in own else name

    for node in nodes:
        for field in ("body", "orelse", "finalbody"):
            block = getattr(node, field, None)
            if block and isinstance(block, list):
                setattr(node, field, [each for each in block if not _is_remark(each)] or [ast.Pass()])
        # The name of an argument in a call stays, unless the function called is the author's own.
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in own:
            for keyword in node.keywords:
                keyword.arg = numbered(keyword.arg) if keyword.arg else None
    for node, field in names:
        setattr(node, field, numbered(getattr(node, field)))
    for node in nodes:
        if isinstance(node, ast.Global | ast.Nonlocal):
            node.names = [numbered(name) for name in node.names]
        if isinstance(node, ast.Constant):
            node.kind = None
    counted = (ast.expr, ast.stmt, ast.arg, ast.operator, ast.cmpop)
    words = sum(isinstance(node, counted) for node in ast.walk(tree))
    return NormalForm("py " + ast.dump(tree, annotate_fields=False), words)


def _name_fields(node: ast.AST) -> list[str]:
    """The fields of a node that hold a name of the file's own: of a variable, a parameter, a function."""
    if isinstance(node, ast.keyword | ast.alias):
        return []
    return [field for field in ("id", "arg", "name", "rest") if isinstance(getattr(node, field, None), str)]


def _is_remark(node: ast.AST) -> bool:
    """Whether it is a docstring, or another string that stands for itself."""
    value = node.value if isinstance(node, ast.Expr) else None
    return isinstance(value, ast.Constant) and isinstance(value.value, str)


# -- the judge's own other languages ----------------------------------------------------------------

_WORD = re.compile(r"[^\W\d]\w*+|\.?\d(?>(?:[eEpP][+-]|[\w.])*)|:=|::|->|=>|==|[^\w\s]")


def _words(language: Language, text: str) -> Iterator[str]:
    """The words of a text; comments are none, a string is one."""
    start = 0
    for begin, end in (*unsaid(text, language.tokens), (len(text), len(text))):
        yield from _WORD.findall(text, start, begin)
        if begin < end and not text.startswith(("//", "/*"), begin):
            yield text[begin:end]
        start = end
