"""Right ways through a problem, with mistakes beside the lines that they spoil: solutions/<id>/mistakes.py.

    def crossing(a, b):
        "right"
        middle = (a + b) / 2
        # ? floor-division: middle = (a + b) // 2      a mistake: its name, and what stands there instead
        # : Whole division drops the half.             said of this one, not what mistakes.toml says
        # = middle = a + (b - a) / 2                   another right way: a style
    # ? tight-epsilon: near = {1e-16..1e-13}       one for every power of ten; {1e-9..1e-3/2} is for
                                                   every second one
        # ? signs@a: middle = a - b                    mistakes of one tag are made together
        # + zero: if a == 0: return 0                  a mistake that adds a line here
        # |     a further line of the same one
        # ! it may start anywhere                      why no case can tell it, where none can
        # @ half-way between both                      words of the rule of the statement that it ignores

A change replaces the statement that ends just above it, at its own indentation. Every function with a
docstring is a route; one whose docstring is not "right" makes the mistake of that name whatever is changed in
it. All else of the file stands before each route: imports and small functions that they share.

Reading runs nothing.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Sequence
from itertools import groupby

from msgspec import Struct

from judge.errors import ProblemError

RIGHT = "right"  # the docstring of a right way

_MARK = re.compile(r"^(\s*)#\s?([?=+|:!@])(?:\s(.*))?$")
_NAMED = re.compile(r"^([a-z][\w-]*)(?:@(\w+))?:\s(.*)$")
_DECADES = re.compile(r"\{1e(-?\d+)\.\.1e(-?\d+)(?:/(\d+))?\}")


class Piece(Struct, frozen=True):
    """New lines for those from `start` up to `end` of a route, counted from 0; for none, where both agree."""

    start: int
    end: int
    lines: tuple[str, ...]


class Change(Struct, frozen=True):
    """One thing done otherwise: a mistake by its name, or a style, which has none.

    `text` is said of it instead of what mistakes.toml says; `equal` is the reason why no case can tell it;
    `rules` are words of the rules that it ignores.
    """

    name: str
    pieces: tuple[Piece, ...]
    line: int  # of the file, from 1
    text: str = ""
    equal: str = ""
    rules: tuple[str, ...] = ()


class Route(Struct, frozen=True):
    """One way through the problem; `mistake` is empty for a right one, `code` has None for lines of marks."""

    name: str
    mistake: str
    text: str
    changes: tuple[Change, ...]
    code: tuple[str | None, ...]

    def source(self, change: Change | None = None) -> str:
        """The function's text with that change, and without marks."""
        lines = list(self.code)
        pieces = sorted(change.pieces if change else (), key=lambda p: (p.start, p.end))
        for piece in reversed(pieces):
            lines[piece.start : piece.end] = piece.lines
        return "\n".join(line for line in lines if line is not None)


class Routes(Struct, frozen=True):
    """A file that was read: what stands before every route, and the routes."""

    prelude: str
    routes: tuple[Route, ...]


def read_routes(text: str, where: str) -> Routes:
    """The routes of a file's text; `where` is what a fault calls the file. Raises ProblemError."""
    try:
        tree = ast.parse(text)
    except SyntaxError as fault:
        place = f"{where}:{fault.lineno or 1}"
        raise ProblemError(f"not Python: {fault.msg}", where=place, remedy="repair this line") from None
    if not tree.body:
        remedy = f'write a function with the docstring "{RIGHT}", or remove the file'
        raise ProblemError("there is no code in it", where=where, remedy=remedy)
    lines = text.splitlines()
    nodes = [node for node in tree.body if isinstance(node, ast.FunctionDef) and ast.get_docstring(node)]
    begun = [_first_line(node) for node in tree.body]
    ends = {first: after - 1 for first, after in zip(begun, [*begun[1:], len(lines) + 1], strict=True)}
    routes = [_Reader(node, lines, ends[_first_line(node)], where).route() for node in nodes]
    if not any(not route.mistake for route in routes):
        remedy = f'begin a function of it with the docstring "{RIGHT}"'
        raise ProblemError("it has no right way", where=where, remedy=remedy)
    taken = {number for node in nodes for number in range(_first_line(node), ends[_first_line(node)] + 1)}
    rest = [line for number, line in enumerate(lines, 1) if number not in taken]
    doc = tree.body[0].end_lineno if ast.get_docstring(tree) else 0
    return Routes("\n".join(rest[doc or 0 :]).strip("\n"), tuple(routes))


def _first_line(node: ast.stmt) -> int:
    decorators = getattr(node, "decorator_list", [])
    lines: list[int] = [node.lineno, *(each.lineno for each in decorators)]
    return min(lines)


class _Mark(Struct):
    """A change as it stands in the file, before tags and powers of ten."""

    name: str
    tag: str
    line: int
    start: int
    end: int
    body: list[str]
    text: str = ""
    equal: str = ""
    rules: tuple[str, ...] = ()


class _Reader:
    """Reads one function; lines of the file are counted from 1."""

    def __init__(self, node: ast.FunctionDef, lines: Sequence[str], last: int, where: str) -> None:
        self._node = node
        self._first = node.lineno
        self._lines = lines[node.lineno - 1 : last]
        self._where = where
        self._statements = [
            each for each in ast.walk(node) if isinstance(each, ast.stmt) and each is not node
        ]

    def route(self) -> Route:
        doc = ast.get_docstring(self._node) or ""
        name, _, text = doc.partition("\n")
        changes = tuple(change for marks in self._grouped() for change in _filled(marks))
        mistake = "" if name.strip() == RIGHT else name.strip().rstrip(".")
        code = tuple(None if _MARK.match(line) else line for line in self._lines)
        return Route(self._node.name, mistake, " ".join(text.split()), changes, code)

    def _grouped(self) -> Iterator[list[_Mark]]:
        """Those of one name and tag together, in the order of their first line."""
        groups: dict[tuple[str, str], list[_Mark]] = {}
        for mark in self._marks():
            groups.setdefault((mark.name, mark.tag or f" {mark.line}"), []).append(mark)
        return iter(groups.values())

    def _marks(self) -> list[_Mark]:
        marks: list[_Mark] = []
        for offset, line in enumerate(self._lines):
            found = _MARK.match(line)
            if not found:
                continue
            indent, kind, rest = found[1], found[2], found[3] or ""
            if kind in "?=+":
                marks.append(self._mark(kind, indent, rest, offset))
                continue
            if not marks or not _MARK.match(self._lines[offset - 1]):
                self._fault(offset, f"'# {kind}' belongs to no change", "put it below one")
            if kind == "|":
                marks[-1].body.append(indent + rest)
            elif kind == ":":
                marks[-1].text = f"{marks[-1].text} {rest}".strip()
            elif kind == "@":
                marks[-1].rules += (rest.strip(),)
            else:
                marks[-1].equal = f"{marks[-1].equal} {rest}".strip()
        return marks

    def _mark(self, kind: str, indent: str, rest: str, offset: int) -> _Mark:
        named = _NAMED.match(rest)
        if kind != "=" and not named:
            self._fault(offset, "a mistake without its name", "write '# ? name: what stands there instead'")
        name, tag, body = (
            ("", "", rest) if kind == "=" or named is None else (named[1], named[2] or "", named[3])
        )
        target = self._above(len(indent), offset)
        end = (target.end_lineno or target.lineno) - self._first + 1
        start = end if kind == "+" else target.lineno - self._first
        return _Mark(name, tag, self._first + offset, start, end, [indent + body])

    def _above(self, column: int, offset: int) -> ast.stmt:
        """The statement at that column that ends just above a line."""
        number = self._first + offset
        fitting = [
            each for each in self._statements if each.col_offset == column and (each.end_lineno or 0) < number
        ]
        if not fitting:
            self._fault(
                offset, "no statement of this indentation above it", "put it below the line it changes"
            )
        return max(fitting, key=lambda each: each.end_lineno or 0)

    def _fault(self, offset: int, what: str, remedy: str) -> None:
        raise ProblemError(what, where=f"{self._where}:{self._first + offset}", remedy=remedy)


def _filled(marks: Sequence[_Mark]) -> Iterator[Change]:
    """One change, or one for each power of ten that `{1e-9..1e-6}` in its lines stands for."""
    ranges = {found.groups() for mark in marks for line in mark.body for found in _DECADES.finditer(line)}
    first = marks[0]
    text = next((mark.text for mark in marks if mark.text), "")
    equal = next((mark.equal for mark in marks if mark.equal), "")
    rules = tuple(rule for mark in marks for rule in mark.rules)
    if not ranges:
        yield Change(first.name, _pieces(marks, ""), first.line, text, equal, rules)
        return
    low = min(int(each[0]) for each in ranges)
    high = max(int(each[1]) for each in ranges)
    step = max(int(each[2] or 1) for each in ranges)
    for power in range(low, high + 1, step):
        yield Change(first.name, _pieces(marks, f"1e{power}"), first.line, text, equal, rules)


def _pieces(marks: Sequence[_Mark], value: str) -> tuple[Piece, ...]:
    """Their lines; several that change one place follow each other in it."""
    found = []
    for (start, end), each in groupby(sorted(marks, key=_place), key=_place):
        lines = [_DECADES.sub(value, line) for mark in each for line in mark.body]
        found.append(Piece(start, end, tuple(lines)))
    return tuple(found)


def _place(mark: _Mark) -> tuple[int, int]:
    return mark.start, mark.end
