"""What stands in the box: the submission's text, its edits, and its answers with each of them.

`ask` is called with what is wanted, the text first. Standard library only, and no import of judge but of what
stands beside it: this file is handed to the contained process together with those.
"""

from __future__ import annotations

import ast
import builtins
import decimal
import sys
import warnings
import zlib
from array import array
from decimal import Decimal

from judge.repair.edits import KINDS, listed
from judge.repair.exact import Foreign, context, lifted, lowered, mathematics, names, raised
from judge.repair.features import LIBRARY, features
from judge.repair.trees import Edit, Facts, counted, shrunk, undo, unrounded, watched

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence
    from typing import Any

MOST_TURNS = 20_000  # of loops and calls in one call
_MOST_STATEMENTS = 80
_WATCHED = 30  # calls in which it is seen what names stand for
_FILE = "<submission>"


class Endless(BaseException):
    """A call that does not come to an end."""


class _Submission:
    """One text, its cases, and the tree as the steps so far have left it."""

    def __init__(self, text: str, entry: str, about: Sequence[Any], cases: Sequence[Any], sizes: Any) -> None:
        self.entry, self.cases, self.sizes = entry, cases, sizes
        self.parameters, self.guards, self.several, self.digits, self.whole = about
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.tree: Any = counted(ast.parse(text))
        self.edits: list[Edit] = []
        self.turns = 0

    def follow(self, chain: Sequence[int]) -> None:
        """Make the edits of the chain, and list those that can be made after them."""
        self.edits = self._listed()
        for place in chain:
            self.edits[place].apply()
            self.edits = self._listed(first=False)

    def _listed(self, *, first: bool = True) -> list[Edit]:
        facts = Facts(self.entry, self.parameters, self.guards, self.several, self._kinds(), first)
        return listed(self.tree, facts)

    def _kinds(self) -> dict[tuple[int, str], str]:
        """What names stand for while it runs, by the line of their function: a number, or something else."""
        found: dict[tuple[int, str], str] = {}

        def note(frame: Any, event: str, _: Any) -> None:
            if event == "return" and frame.f_code.co_filename == _FILE:
                for name, value in frame.f_locals.items():
                    kind = "number" if isinstance(value, int | float) else type(value).__name__
                    found[frame.f_code.co_firstlineno, name] = kind

        _while_noting(note, self.answers, range(0, len(self.cases), max(1, len(self.cases) // _WATCHED)))
        return found

    def leaving(self, places: Sequence[int]) -> list[int]:
        """The line where the entry function returns each one's answer; 0 where it never does."""
        found: list[int] = []

        def note(frame: Any, event: str, _: Any) -> None:
            code = frame.f_code
            if event == "return" and (code.co_filename, code.co_name) == (_FILE, self.entry):
                found[-1] = frame.f_lineno

        space = self._space(vars(builtins), self.tree)
        for place in places:
            found.append(0)
            _while_noting(note, self._answer, space, place)
        return found

    def answers(self, places: Sequence[int], number: int | None = None) -> list[list[Any]]:
        """Each one's answer in a list of one, with that edit if any; an empty list where it raises."""
        before = [] if number is None else self.edits[number].apply()
        try:
            space = self._space(vars(builtins), self.tree)
            return [self._answer(space, place) for place in places]
        finally:
            undo(before)

    def work(self, places: Sequence[int]) -> int:
        """The turns of a call on the way, in the mean."""
        space, turns = self._space(vars(builtins), self.tree), 0
        for place in places:
            self._answer(space, place)
            turns += self.turns
        return turns // len(places)

    def _space(self, built_in: Any, tree: Any) -> dict[str, Any]:
        """The names of the program, once it was run."""
        space: dict[str, Any] = {"__name__": "submission", "__builtins__": built_in, "_turn_": self._turn}
        self.turns = 0
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                exec(compile(tree, _FILE, "exec", dont_inherit=True), space)
            except Foreign:
                raise
            except BaseException:
                space.pop(self.entry, None)
        return space

    def _turn(self) -> None:
        self.turns += 1
        if self.turns > MOST_TURNS:
            raise Endless

    def _answer(
        self, space: dict[str, Any], place: int, change: Callable[[Any], Any] = lambda x: x
    ) -> list[Any]:
        space["_size_"], space["_way_"] = self.sizes[place]
        space["_case_"] = self.cases[place]
        self.turns = 0
        try:
            return [space[self.entry](*[change(_fresh(each)) for each in self.cases[place]])]
        except (Foreign, KeyboardInterrupt):
            raise
        except BaseException:
            return []

    def exactly(self, factor: str, places: Sequence[int]) -> list[list[Any]] | None:
        """The same without rounding, tolerances times that factor; None where it cannot be run so."""
        try:
            with decimal.localcontext(context(self.digits)):
                space = self._space(names(factor), self.tree if factor == "1" else shrunk(self.tree))
                found = [self._answer(space, place, lifted) for place in places]
                return [[lowered(each[0], self.whole)] if each else [] for each in found]
        except Foreign:
            return None

    def unrounded(self, some: Sequence[int], places: Sequence[int]) -> list[Any]:
        """The answers with one statement worked out without rounding, after its line: of some, or of each."""
        found = []
        made = unrounded(self.tree)[:_MOST_STATEMENTS]
        with decimal.localcontext(context(self.digits)):
            numbers = mathematics(Decimal(1))
            given = {
                **vars(builtins),
                "_lowered_": lambda x: lowered(x, self.whole),
                "_raised_": lambda x: raised(x, numbers),
            }
            for line, tree in [made[at] for at in some] or made:
                space = self._space(given, tree)
                found.append([line, [self._answer(space, place) for place in places]])
        return found

    def turning(self, factors: Sequence[str], places: Sequence[int]) -> list[list[int]] | None:
        """The lines of each one's comparisons that come out differently in two runs, the first of them first.

        A run without rounding has a factor of its tolerances, the usual one has "". None where there is none.
        """
        try:
            one, other = (self._compared(factor, places) for factor in factors)
        except Foreign:
            return None
        return [_turned(*pair) for pair in zip(one, other, strict=True)]

    def decided(self, factor: str, line: int, places: Sequence[int]) -> list[list[Any]] | None:
        """The answers where that line's comparisons come out as without rounding; None where it cannot."""
        try:
            exact = self._compared(factor, places)
        except Foreign:
            return None
        tree, lines = watched(self.tree)
        held: Iterator[bool] = iter(())

        def take(place: int, value: Any) -> Any:
            return next(held, value) if lines[place] == line else value

        space, found = self._space({**vars(builtins), "_told_": take}, tree), []
        for place, told in zip(places, exact, strict=True):
            held = (holds for at, holds in told if at == line)
            found.append(self._answer(space, place))
        return found

    def _compared(self, factor: str, places: Sequence[int]) -> list[list[tuple[int, bool]]]:
        """Each one's comparisons in order: the line, and whether it holds."""
        tree, lines = watched(self.tree if factor in ("", "1") else shrunk(self.tree))
        told: list[tuple[int, bool]] = []

        def tell(place: int, value: Any) -> Any:
            told.append((lines[place], bool(value)))
            return value

        def heard(space: dict[str, Any], place: int, change: Callable[[Any], Any]) -> list[tuple[int, bool]]:
            told.clear()
            self._answer(space, place, change)
            return told[:MOST_TURNS]

        if not factor:
            plain = self._space({**vars(builtins), "_told_": tell}, tree)
            return [heard(plain, place, lambda x: x) for place in places]
        with decimal.localcontext(context(self.digits)):
            exact = self._space({**names(factor), "_told_": tell}, tree)
            return [heard(exact, place, lifted) for place in places]


def _turned(one: Sequence[tuple[int, bool]], other: Sequence[tuple[int, bool]]) -> list[int]:
    first = [a[0] for a, b in zip(one, other, strict=False) if a != b][:1]
    every = dict.fromkeys(line for line, _ in (*one, *other))
    held = ([[holds for at, holds in some if at == line] for some in (one, other)] for line in every)
    turned = [line for line, (here, there) in zip(every, held, strict=True) if here != there]
    return [*first, *(line for line in turned if line not in first)]


def _while_noting(note: Any, function: Callable[..., Any], *given: Any) -> None:
    sys.setprofile(note)
    try:
        function(*given)
    finally:
        sys.setprofile(None)


def _fresh(value: Any) -> Any:
    if type(value) is bytes:
        return array("d", value)
    return list(map(_fresh, value)) if type(value) is list else value


_opened: list[_Submission] = []


def ask(what: str, *given: Any) -> Any:
    """What is wanted: `open` first, then `table` or a method of `_Submission`.

    Opening says whether the program may be changed, and lists its edits where it is given a chain of them.
    """
    if what == "open":
        *text, chain = given
        _opened[:] = [_Submission(*text)]
        if chain is not None:
            _opened[0].follow(chain)
        return int(LIBRARY not in features(text[0]))
    one = _opened[0]
    if what == "table":
        return [[KINDS.index(each.kind), each.line, _hash(each), each.lines] for each in one.edits]
    return getattr(one, what)(*given)


def _hash(edit: Edit) -> int:
    return zlib.crc32(f"{edit.column} {edit.what}".encode())
