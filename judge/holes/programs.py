"""The programs that are changed, and what they are changed into."""

from __future__ import annotations

import ast
import marshal
import re
import warnings
from collections.abc import Iterator
from functools import cache, cached_property

from msgspec import Struct

from judge.cache import digest
from judge.errors import ProblemError
from judge.holes import inside
from judge.holes.mutants import Mutant, mutants
from judge.mistakes.family import Family
from judge.problem import Problem
from judge.problem.solutions import SolutionKind, read_solutions, tree_of
from judge.values.letters import texts_of
from judge.values.types import atoms

_SLOW = re.compile(r"^\s*(from|import) (fractions|decimal)\b", re.MULTILINE)  # to be changed by the thousand


class Base(Struct, frozen=True):
    """A right program: `file` is where it stands, `shared` are lines that another base has, too.

    Of those that were written out, `whole`, the numbers are changed as well: the others work alike. `texts`
    are the parameters that hold texts, by their place, and at -1 the answer, where it does.
    """

    file: str
    source: str
    whole: bool = True
    shared: frozenset[str] = frozenset()
    texts: tuple[tuple[int, str], ...] = ()

    def mutants(self, measured: bool) -> Iterator[Candidate]:
        """All of its mutants."""
        yield from (Candidate(self, each) for each in mutants(self.source) if each.was not in self.shared)
        others = [("numbers", name, number, str(number), name) for name, number in inside.ladders(measured)]
        others = others if self.whole else []
        others += [("text", name, place, what, "") for name in inside.TEXTS for place, what in self.texts]
        for kind, name, number, what, ladder in others:
            made = Mutant(kind, 0, "", name.format(what), self.source, ladder, (name, number))
            yield Candidate(self, made)


class Candidate(Struct, frozen=True, dict=True):
    """A mutant of a base; the base itself, as a mutant that changes nothing."""

    base: Base
    mutant: Mutant

    @cached_property
    def key(self) -> str:
        """What it is known by: two with the same text are one."""
        return digest(repr((self.mutant.source, self.mutant.numbers)).encode())[:24]

    @property
    def ladder(self) -> str:
        """The ladder that it is a rung of; empty where it is none."""
        mutant = self.mutant
        return mutant.ladder and f"{self.base.file}/{mutant.kind}/{mutant.ladder}"

    @property
    def made(self) -> inside.Made:
        """What the box makes it of."""
        return self.code, *self.mutant.numbers

    @cached_property
    def code(self) -> str:
        """Its compiled text; empty where it does not compile."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                made = compile(self.mutant.source, self.base.file, "exec", dont_inherit=True)
            except SyntaxError:
                return ""
        return marshal.dumps(made).decode("latin-1")


@cache
def original(base: Base) -> Candidate:
    """The program as it is."""
    return Candidate(base, Mutant("", 0, "", "", base.source))


def bases(problem: Problem, only: str = "") -> list[Base]:
    """Right Python functions or classes, of accepted/, mistakes.py; `only` is one file, as accepted/exact.py.

    Slow ones are left out where there are others.
    """
    called = not problem.methods
    texts = tuple(_texts(problem)) if called else ()
    found = [
        Base(each.file, each.source.decode("utf-8-sig"), whole=called, texts=texts)
        for each in read_solutions(problem, SolutionKind.ACCEPTED).programs
        if each.language is None and only in ("", each.file)
    ]
    entry = problem.entry
    found = [each for each in found if any(entry in _binds(node) for node in tree_of(each.source).body)]
    found += [] if only else _routes(problem)
    return [each for each in found if not _SLOW.search(each.source)] or found


def _texts(problem: Problem) -> Iterator[tuple[int, str]]:
    """The answer and the parameters that hold texts, and no words beside them."""
    types = [(-1, "the answer", problem.answer)]
    types += [(at, each.name, each.type) for at, each in enumerate(problem.parameters)]
    for place, what, type_ in types:
        strs = [each for each in atoms(type_) if each.annotation == "str"]
        if strs and len(strs) == len(texts_of(type_)):
            yield place, what


def _routes(problem: Problem) -> list[Base]:
    """The right ways of mistakes.py, plain and in each style; a style is changed where it differs."""
    try:
        family = Family.of(problem)
    except ProblemError:  # which `judge verify` tells
        return []
    found, plain = [], frozenset[str]()
    for right in family.right_ways() if family else ():
        source, place = _needed(right.program.source.decode(), problem.entry), right.file.partition("/")[2]
        styled = ":" in place  # what is a route as it stands has no line
        if not styled:
            plain = frozenset(line.strip() for line in source.splitlines())
        shared = plain if styled else frozenset[str]()
        found.append(Base(place, source, whole=False, shared=shared))
    return found


def _needed(source: str, entry: str) -> str:
    """The source without the imports and functions that the entry does not lead to."""
    lines, body = source.splitlines(), tree_of(source).body
    reads = {id(node): {n.id for n in ast.walk(node) if isinstance(n, ast.Name)} for node in body}
    wanted, size = {entry}, 0
    while size != len(wanted):
        size = len(wanted)
        wanted |= {name for node in body if _binds(node) & wanted for name in reads[id(node)]}
    for node in body:
        if not _binds(node) & wanted:
            lines[node.lineno - 1 : node.end_lineno] = [""] * ((node.end_lineno or 0) - node.lineno + 1)
    return "\n".join(lines).strip("\n") + "\n"


def _binds(node: ast.stmt) -> set[str]:
    """The names that a statement of a module binds."""
    match node:
        case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
            return {name}
        case ast.Import(names=names) | ast.ImportFrom(names=names):
            return {each.asname or each.name.partition(".")[0] for each in names}
    return {n.id for n in ast.walk(node) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
