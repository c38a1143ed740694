"""All that is known to be wrong in a problem: what mistakes.py makes, and the programs of wrong/.

Of mistakes.py that are right routes, each change of them, and changes of input and answer: every single
mistake exists without having been written. It is rendered as the text of a program, and what it answers is
what that program answers.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Sequence

from msgspec import Struct
from msgspec.structs import replace

from judge.errors import ProblemError
from judge.mistakes.catalogue import EXAMPLE, Catalogue, MistakeText, read_catalogue
from judge.mistakes.computed import ComputedProgram
from judge.mistakes.routes import Change, Route, read_routes
from judge.mistakes.transforms import ANSWER, HELPERS, INNER, KEPT_BETWEEN_CALLS, Transform, transforms
from judge.problem import Problem
from judge.problem.solutions import MISTAKES, Solution, SolutionKind, read_solutions, usual_first
from judge.problem.toml import read_text

_KEPT = MistakeText(state=True)  # where mistakes.toml says nothing of it
SHARED = "shared-by-all-objects"
_CHANGEABLE = (ast.List, ast.Dict, ast.Set, ast.ListComp, ast.DictComp, ast.SetComp, ast.Call)


class Maker(Struct, frozen=True):
    """A program that makes a known mistake; a right one has no `name`.

    `file` is where it stands, as `count/mistakes.py:12`, or what it does to input and answer; `text` is what
    is said of whoever makes it, `words` what mistakes.toml says of the mistake, `line` the line that it
    spoils, where that says something by itself. `equal` is the reason why no case can tell it from a right
    program. One that is `general` changes input or answer as in any problem; one that is `offered` comes from
    the types alone: it may be no mistake of this kata, and is a name where no other is nearly as like.
    """

    name: str
    file: str
    text: str
    words: MistakeText
    program: ComputedProgram
    line: str = ""
    equal: str = ""
    general: bool = False
    offered: bool = False

    @property
    def seen(self) -> str:
        """What is seen in the answers."""
        seen = self.words.seen
        return seen if seen and self.text.startswith(seen) else _first(self.text)

    @property
    def wrong(self) -> str:
        """What is seen, and an example of it, without what to do instead: that is for the hints."""
        rest = self.text.removeprefix(self.seen)
        return self.seen + (_first(rest) if rest.startswith(f" {EXAMPLE}") else "")


class Family:
    """All programs of one problem's mistakes.py. Raises ProblemError where its files cannot be read."""

    def __init__(self, problem: Problem, catalogue: Catalogue | None = None) -> None:
        self.problem = problem
        self._catalogue = read_catalogue(problem) if catalogue is None else catalogue
        path = problem.solutions / MISTAKES
        self.where = f"{path.parent.name}/{MISTAKES}"
        read = read_routes(read_text(path), self.where)
        self.routes: Sequence[Route] = read.routes
        self._prelude = read.prelude
        self._transforms = transforms(problem, self._catalogue)

    @staticmethod
    def of(problem: Problem, catalogue: Catalogue | None = None) -> Family | None:
        """The family of a problem; None where it has no mistakes.py."""
        return Family(problem, catalogue) if (problem.solutions / MISTAKES).is_file() else None

    def right_ways(self) -> Iterator[Maker]:
        """What must be accepted: every right route, plain and with each of its styles."""
        for route in self.routes:
            if not route.mistake:
                yield self._of_route(route)
                yield from (self._of_route(route, each) for each in route.changes if not each.name)

    def mistakes(self) -> Iterator[Maker]:
        """Every mistake alone: on the plain route, and on routes that are one, in each of their styles."""
        for route in self.routes:
            if route.mistake:
                yield self._of_route(route)
            yield from (self._of_route(route, each) for each in route.changes if each.name or route.mistake)
        yield from map(self._of_transform, self._transforms)

    def _of_route(self, route: Route, change: Change | None = None) -> Maker:
        own = change is not None and bool(change.name or not route.mistake)
        file = f"{self.where}:{change.line}" if change and own else f"{self.where}, {route.name}"
        made = self._made(
            route.mistake or (change.name if change else ""),
            file,
            (change and change.text) or route.text,
            self._program(route, change, self.problem.entry),
        )
        if change is None:
            return made
        return replace(made, line=_spoiled(route, change) if change.name else "", equal=change.equal)

    def _of_transform(self, each: Transform) -> Maker:
        given = ", ".join(each.name for each in self.problem.parameters)
        rows = [f"{ANSWER} = {INNER}({given})", f"return {ANSWER}"]
        rows.insert(1 if each.after else 0, each.line)
        outer = "\n    ".join([f"def {self.problem.entry}({given}):", *rows])
        source = "\n\n\n".join([self._program(self.routes[0], None, INNER).rstrip(), HELPERS, outer]) + "\n"
        return replace(
            self._made(each.name, each.line, each.text, source), general=True, offered=each.offered
        )

    def _made(self, name: str, file: str, own: str, source: str) -> Maker:
        """`own` is what fits this very change: what is wrong and what to do instead."""
        words = self._catalogue.get(name, _KEPT if name == KEPT_BETWEEN_CALLS else MistakeText())
        text = f"{words.seen} {own}" if own.startswith(EXAMPLE) else own or words.told
        return Maker(name, file, text, words, ComputedProgram(source.encode(), file, trusted=True))

    def _program(self, route: Route, change: Change | None, entry: str) -> str:
        """The text of a whole program, in which the route bears that name."""
        source = route.source(change)
        source = re.sub(rf"^def {route.name}\(", f"def {entry}(", source, count=1, flags=re.MULTILINE)
        return "\n\n\n".join(filter(None, (self._prelude, source.rstrip()))) + "\n"


def _spoiled(route: Route, change: Change) -> str:
    """What stands instead of one right line, or of none, if that is little enough."""
    found = []
    for piece in change.pieces:
        old = [line for line in route.code[piece.start : piece.end] if line is not None]
        if len(old) <= 1 and len(piece.lines) <= 2:
            found.append("\n".join(piece.lines).strip())
    return found[0] if len(found) == 1 else ""


def _first(text: str) -> str:
    """Its first sentence."""
    return re.split(r"(?<=[.!?])\s", text, maxsplit=1)[0]


class Makers(Struct, frozen=True):
    """Every maker, and what is wrong with the files; `family` is None where there is no mistakes.py.

    `problem` is the problem with all of its groups' kills.
    """

    problem: Problem
    all: tuple[Maker, ...]
    faults: tuple[ProblemError, ...]
    family: Family | None


def read_makers(problem: Problem) -> Makers:
    """What is known of a problem's mistakes. A file that cannot be read is a fault and no maker."""
    solutions, faults = read_solutions(problem, SolutionKind.WRONG)
    programs = [each for each in solutions if each.language is None]  # the others would be compiled for it
    found: list[Maker] = []
    family = None
    try:
        catalogue = read_catalogue(problem)
        family = Family.of(problem, catalogue)
    except ProblemError as fault:
        catalogue, family, faults = {}, None, (*faults, fault)
    if family is not None:
        found += family.mistakes()
    found += [_of_file(each, catalogue.get(each.name, MistakeText())) for each in usual_first(programs)]
    if problem.methods and SHARED not in {each.name for each in found}:
        found += _of_classes(problem, catalogue.get(SHARED, MistakeText()))
    return Makers(problem, tuple(found), faults, family)


def _of_classes(problem: Problem, words: MistakeText) -> Iterator[Maker]:
    """The right classes of which all objects share their state."""
    for each in read_solutions(problem, SolutionKind.ACCEPTED)[0]:
        source = shared(each.source, problem.entry) if each.language is None else None
        if source is not None:
            program = ComputedProgram(source.encode(), each.path.name)
            yield Maker(SHARED, each.file, words.told, words, program, offered=True)


def shared(source: bytes, entry: str) -> str | None:
    """The class, which has itself what its constructor makes of no argument; None if that is nothing."""
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError):
        return None
    made = next((each for each in tree.body if isinstance(each, ast.ClassDef) and each.name == entry), None)
    body = made.body if made else []
    first = next(
        (each for each in body if isinstance(each, ast.FunctionDef) and each.name == "__init__"), None
    )
    if made is None or first is None:
        return None
    own = {each.arg for each in ast.walk(first.args) if isinstance(each, ast.arg)}
    moved = [each for each in first.body if isinstance(each, ast.Assign) and _is_fresh(each, own)]
    kept = [each for each in first.body if each not in moved]
    first.body = kept or [ast.Pass()]
    for each in moved:
        each.targets = [ast.Name(target.attr) for target in each.targets if isinstance(target, ast.Attribute)]
    made.body[:0] = moved
    return ast.unparse(ast.fix_missing_locations(tree)) if moved else None


def _is_fresh(statement: ast.Assign, own: set[str]) -> bool:
    """Whether it gives attributes an object that is made there, of no argument, and may be changed."""
    nodes = [*ast.walk(statement.value)]
    plain = not own.intersection(each.id for each in nodes if isinstance(each, ast.Name))
    attributes = all(isinstance(target, ast.Attribute) for target in statement.targets)
    return plain and attributes and any(isinstance(each, _CHANGEABLE) for each in nodes)


def _of_file(solution: Solution, words: MistakeText) -> Maker:
    program = ComputedProgram(solution.source, solution.path.name)
    return Maker(solution.name, solution.file, solution.advice or words.told, words, program)
