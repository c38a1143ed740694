"""The programs that are changed, and asking hundreds of changed ones in one box."""

from __future__ import annotations

import ast
import marshal
import warnings
from array import array
from collections.abc import Iterator, Sequence
from functools import cache, cached_property
from pathlib import Path

from msgspec import Struct

from judge.cache import digest
from judge.errors import ProblemError
from judge.holes import inside
from judge.holes.mutants import Mutant, mutants
from judge.mistakes.family import Family
from judge.problem import Case, Problem
from judge.problem.solutions import SolutionKind, read_solutions, tree_of
from judge.sandbox.boundary import Box, Limits, Reply, Stop
from judge.values.letters import texts_of
from judge.values.types import atoms
from judge.values.wire import items

SOURCE = Path(inside.__file__).read_bytes()
_SLOW = {"fractions", "decimal"}  # programs with them are too slow to be changed by the thousand
_MOST = 200_000  # calls at once
_LEAST = 50
_MUTANTS = 64  # at once
_SECONDS = 1.0  # of CPU that they should take
_PATIENCE = 5.0  # … and may take
_WAITING = 300.0  # on a busy machine
_OUTPUT = 64 << 20
GIVEN_UP = Reply(Stop.EXITED)


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
        for each in mutants(self.source):
            if each.was not in self.shared:
                yield Candidate(self, each)
        for name, number in inside.ladders(measured) if self.whole else ():
            yield Candidate(
                self, Mutant("numbers", 0, "", name.format(number), self.source, name, (name, number))
            )
        for name in inside.TEXTS:
            for place, what in self.texts:
                yield Candidate(
                    self, Mutant("text", 0, "", name.format(what), self.source, "", (name, place))
                )


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
    found = [each for each in found if _defines(each.source, problem.entry)]
    found += [] if only else _routes(problem)
    return [each for each in found if not _imports(each.source) & _SLOW] or found


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


def _defines(source: str, entry: str) -> bool:
    nodes = tree_of(source).body
    return any(isinstance(node, ast.FunctionDef | ast.ClassDef) and node.name == entry for node in nodes)


def _imports(source: str) -> set[str]:
    found = [node for node in ast.walk(tree_of(source)) if isinstance(node, ast.Import | ast.ImportFrom)]
    return {getattr(node, "module", None) or each.name for node in found for each in node.names}


class Candidates:
    """Candidates in a box that was opened on `SOURCE`: what each answers to cases."""

    def __init__(self, problem: Problem, box: Box) -> None:
        self._problem, self._box = problem, box
        self.most = _LEAST  # calls at once, as fast as they turn out to be

    def differing(self, some: Sequence[Candidate], cases: Sequence[Case]) -> Iterator[list[int]]:
        """Of each the places of the cases that it answers otherwise than its base, to the last bit.

        Where that cannot be found out they are all there. Raises JudgeError.
        """
        given = [tuple(each) for each in self._problem.calls(cases)]
        if any(isinstance(value, array) for value in (given or [()])[0]):
            yield from ([*range(len(cases))] for _ in some)
            return
        at = alone = 0  # those before `alone` are asked alone: one of them ends all others
        while at < len(some):
            size = 1 if at < alone else max(1, min(_MUTANTS, self.most // max(1, len(cases))))
            part = some[at : at + size]
            found = self._differing(part, given)
            if found is None and len(part) > 1:
                alone = at + len(part)
                continue
            wrong = [[*range(len(cases))]] if found is None else [[] for _ in part]
            for place in found or ():
                wrong[place // len(cases)].append(place % len(cases))
            yield from wrong
            at += len(part)

    def _differing(
        self, some: Sequence[Candidate], given: Sequence[Sequence[object]]
    ) -> Sequence[int] | None:
        right = {each.base.source: original(each.base).made for each in some}
        order = {source: place for place, source in enumerate(right)}
        mutants = [(order[each.base.source], each.made) for each in some]
        call = self._problem.called, [*right.values()], mutants, given
        found = self._box.call("differ", [call], self._limits(len(some), len(some) * len(given)))
        reply = found.replies[0]
        if reply.stop is not Stop.ANSWERED:
            return None
        self._learn((len(some) + len(right)) * len(given), found.usage.cpu_seconds)
        return items(reply.answer)

    def answers(self, work: Sequence[tuple[Candidate, Sequence[Case]]]) -> Iterator[list[Reply]]:
        """The replies to each one's cases, in order; after one that ends its process there are no more.

        Raises JudgeError.
        """
        at = 0
        while at < len(work):
            end, calls = at, list[tuple[object, ...]]()
            while end < len(work) and (end == at or len(calls) + len(work[end][1]) <= self.most):
                calls += self._calls(end, *work[end])
                end += 1
            replies = list[Reply]()
            if calls:
                found = self._box.call("ask", calls, self._limits(end - at))
                self._learn(len(found.replies), found.usage.cpu_seconds)
                replies += found.replies
            for place in range(at, end):
                size = len(work[place][1])
                own, replies = replies[:size], replies[size:]
                ended = bool(own) and own[-1].stop not in (Stop.ANSWERED, Stop.EXCEPTION)
                if len(own) < size and not ended and place > at:
                    break  # there was no room for all of them
                yield own if len(own) == size else [*own, GIVEN_UP]
                at = place + 1
                if len(own) < size:
                    break

    def _calls(self, place: int, candidate: Candidate, cases: Sequence[Case]) -> Iterator[tuple[object, ...]]:
        for number, given in enumerate(self._problem.calls(cases)):
            yield place, self._problem.called, None if number else candidate.made, *given

    def _limits(self, mutants: int, places: int = 0) -> Limits:
        seconds, most = _PATIENCE + mutants * inside.SECONDS, max(places, self._problem.answer.items)
        return Limits(seconds, _WAITING, self._problem.limits.memory_bytes, _OUTPUT, _WAITING, most)

    def _learn(self, calls: int, seconds: float) -> None:
        if calls >= _LEAST // 2:
            able = int(calls * _SECONDS / max(seconds, 1e-4))
            self.most = max(_LEAST, min(_MOST, 4 * self.most, able))
