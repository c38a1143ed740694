"""The box beside a submission's own, in which its text is looked at and changed; no right answer is there."""

from __future__ import annotations

import re
from array import array
from collections import Counter
from collections.abc import Sequence
from contextlib import ExitStack
from functools import cached_property
from itertools import takewhile
from pkgutil import get_data
from typing import Any, NamedTuple

from judge.problem.solutions import LONGEST
from judge.repair import edits
from judge.repair.cases import Cases, numbers
from judge.repair.features import FEATURES, LIBRARY
from judge.sandbox.boundary import Box, BoxFactory, Limits, Reply, Stop
from judge.values.wire import Raw, word

_ARRAYS = re.compile(r"^\s*(?:import|from)\s+numpy\b", re.MULTILINE)
_BESIDE = re.compile(rb"^from (__future__|judge\.repair\.\w+) import (\([^)]*\)|.*)\n", re.MULTILINE)
_FILES = [
    get_data("judge.repair", f"{name}.py") or b""
    for name in ("exact", "trees", "expressions", "edits", "features", "inside")
]
SOURCE = b"from __future__ import annotations\n" + b"".join(_BESIDE.sub(b"", each) for each in _FILES)
NAME = "repair.py"
_ITEMS = 500_000  # of one reply
_OUTPUT = 64 << 20
_SECONDS = 20.0
_SLOW = 0.5
_PLAIN = 40  # turns of loops and functions in a call of a plain program
_SECONDS_ALONE = 5.0
_MOST_ENDS = 12  # of processes before all is answered; one that takes all its time counts as four
_REAL_DIGITS = 80
_MOST_DIGITS = 2_000
_LIMITS = Limits(cpu_seconds=5.0, wall_seconds=15.0, memory_bytes=1 << 29, output_bytes=1 << 16)  # of looking

Call = tuple[Any, ...]
Table = list[tuple[str, int, int, int]]
# of each edit its kind, its line, what tells it from others there, and how many lines it changes


class Beside:
    """Opens the box when it is first asked, and ends it: a context manager.

    `text` is the submission's, None where there is none in Python.
    """

    def __init__(self, boxes: BoxFactory, source: bytes, *, python: bool) -> None:
        self._boxes, self._stack = boxes, ExitStack()
        self.too_long = len(source) > LONGEST
        self.text: str | None = None
        if python and not self.too_long:
            try:
                self.text = source.decode("utf-8-sig")
            except UnicodeDecodeError:
                self.text = source.decode("latin-1")

    def __enter__(self) -> Beside:
        return self

    def __exit__(self, *exc: object) -> None:
        self._stack.close()

    @cached_property
    def box(self) -> Box:
        """Raises JudgeError where none can be opened."""
        return self._stack.enter_context(self._boxes(SOURCE, NAME))

    def features(self) -> frozenset[str] | None:
        """What its syntax tree has, as far as it says so; nothing of what is no Python. Raises JudgeError.

        None where it is longer than what anybody writes. One whose work lies in a library has no text
        any more.
        """
        if self.too_long:
            return None
        if self.text is None:
            return frozenset()
        (reply,) = self.box.call("features", [(self.text,)], _LIMITS).replies[:1]
        said = reply.answer if reply.stop is Stop.ANSWERED and isinstance(reply.answer, list) else []
        found = {*FEATURES, LIBRARY} & {word(each) for each in said}
        self.text = None if LIBRARY in found else self.text
        return frozenset(found)


class LostError(Exception):
    """The contained process died, was silent or answered what nobody asked for."""


class Turning(NamedTuple):
    """Lines of comparisons: those where cases differ first, from the most, and all of them.

    There are none of the first where half of the cases differ nowhere.
    """

    first: list[int]
    lines: frozenset[int]


class Child:
    """A submission's text, its cases, and the box that was opened on `SOURCE`."""

    def __init__(self, box: Box, text: str, cases: Cases) -> None:
        self._box, self._cases, self._text = box, cases, text
        self._lines = text.count("\n") + 1
        problem = cases.problem
        kinds = [each.type.text for each in problem.parameters]
        whole = any("integer" in kind for kind in kinds)
        digits = _REAL_DIGITS
        if whole:  # exact in so many digits, whatever is made of the numbers
            largest = max((len(str(x)) for each in cases.all for x in numbers(each.case)), default=1)
            digits = min(_MOST_DIGITS, max(_REAL_DIGITS, 12 * largest))
        names = [each.name for each in problem.parameters]
        self._about = names, cases.tests(), cases.several, digits, whole
        self._given = [[*map(_plain, each)] for each in problem.calls([each.case for each in cases.all])]
        self.arrays = bool(_ARRAYS.search(text))  # its calls take longer
        self.calls = self._ends = 0
        self.seconds = 0.0  # that the last process took, of CPU or asleep

    def ask(self, chain: Sequence[int] | None, calls: Sequence[Call]) -> list[Raw]:
        """What it says to the calls, after those edits; of a chain that is None, nothing is to be changed.

        A call that ends its process, even if it is the first one there, costs itself alone: its answer is
        None. Raises LostError.
        """
        entry, sizes = self._cases.problem.entry, self._cases.sizes
        first = ("open", self._text, entry, self._about, self._given, sizes, chain)
        answers: list[Raw] = []
        alone = False
        while left := calls[len(answers) :]:
            seconds = _SECONDS_ALONE if alone else _SECONDS
            done = self._box.call("ask", [first, *left[: 1 if alone else None]], self._limits(seconds))
            found = [each.answer for each in takewhile(_goes_on, done.replies)]
            self.seconds = done.usage.cpu_seconds + done.usage.slept_seconds
            answers += found[1:]
            ended = done.replies[len(found) :]
            self._ends += sum(4 if each.stop in (Stop.CPU, Stop.WALL) else 1 for each in ended)
            if found[:1] != [1] or not (ended or found[1:]) or self._ends > _MOST_ENDS:
                raise LostError
            if ended and len(found) == 1:
                answers.append(None)
            alone = bool(ended) and len(found) > 1  # those before it may have used up what it lacked
        return answers

    def try_out(self, places: Sequence[int]) -> int:
        """Call it unchanged: as how many calls of a plain program one counts.

        Raises LostError, also where it is too slow to be called by the thousand.
        """
        (turns,) = self.ask(None, [("work", places)])
        if type(turns) is not int or self.seconds > _SLOW:
            raise LostError
        return 1 + abs(turns) // _PLAIN

    def _limits(self, seconds: float) -> Limits:
        """As much as many groups: time ends nothing but what would never end."""
        memory = self._cases.problem.limits.memory_bytes
        return Limits(seconds, 3 * seconds, memory, _OUTPUT, items=_ITEMS)

    def table(self, chain: Sequence[int]) -> Table:
        """The edits that can be made after those of the chain. Raises LostError."""
        (rows,) = self.ask(chain, [("table",)])
        found: Table = []
        for row in rows if isinstance(rows, list) else ():
            fits = isinstance(row, list) and len(row) == 4 and all(type(each) is int for each in row)
            if not fits or not 0 <= row[0] < len(edits.KINDS) or not 0 < row[1] <= self._lines:
                raise LostError
            found.append((edits.KINDS[row[0]], *row[1:]))
        return found[: edits.MOST_EDITS]

    def answers(
        self, chain: Sequence[int], places: Sequence[int], numbers: Sequence[int | None] = (None,)
    ) -> list[list[tuple[int, Raw]] | None]:
        """What it answers to the cases with each of these edits after the chain, or none. Raises LostError.

        Pairs of the case's place and the answer; there is none where it raises. None: it ends its process.
        """
        self.calls += len(numbers) * len(places)
        found = self.ask(chain, [("answers", places, number) for number in numbers])
        return [None if each is None else _pairs(each, places) for each in found]

    def exactly(
        self, chain: Sequence[int] | None, factors: Sequence[str], places: Sequence[int]
    ) -> list[list[tuple[int, Raw]] | None]:
        """The same without rounding, tolerances times each factor; None where it cannot be run so.

        Raises LostError.
        """
        self.calls += len(factors) * len(places)
        found = self.ask(chain, [("exactly", factor, places) for factor in factors])
        return [None if each is None else _pairs(each, places) for each in found]

    def turning(
        self, chain: Sequence[int] | None, places: Sequence[int], factors: Sequence[str] = ("", "1")
    ) -> Turning:
        """Which comparisons come out differently in those two runs: see `inside`. Raises LostError."""
        self.calls += 2 * len(places)
        (found,) = self.ask(chain, [("turning", factors, places)])
        each = [self._lines_of(some) for some in found] if isinstance(found, list) else []
        turned = Counter(some[0] for some in each if some)
        first = sorted(turned, key=lambda line: (-turned[line], line))
        return Turning(first if 2 * turned.total() >= len(each) else [], frozenset[int]().union(*each))

    def decided(
        self, chain: Sequence[int] | None, factor: str, line: int, places: Sequence[int]
    ) -> list[tuple[int, Raw]]:
        """The answers where that line's comparisons come out as on paper: see `inside`. Raises LostError."""
        self.calls += 2 * len(places)
        (found,) = self.ask(chain, [("decided", factor, line, places)])
        return [] if found is None else _pairs(found, places)

    def leaving(self, chain: Sequence[int] | None, places: Sequence[int]) -> int:
        """The line where most of the cases are answered, or 0. Raises LostError."""
        self.calls += 2 * len(places)
        (found,) = self.ask(chain, [("leaving", places)])
        return _usual(self._lines_of(found))

    def unrounded(
        self, chain: Sequence[int] | None, some: Sequence[int], places: Sequence[int]
    ) -> list[tuple[int, list[tuple[int, Raw]]]]:
        """Lines, and the answers with one statement without rounding: see `inside`. Raises LostError."""
        (rows,) = self.ask(chain, [("unrounded", some, places)])
        found = []
        for row in rows if isinstance(rows, list) else ():
            if not isinstance(row, list) or len(row) != 2 or not self._lines_of(row[:1]):
                raise LostError
            found.append((int(row[0]), _pairs(row[1], places)))
        self.calls += len(found) * len(places)
        return found

    def _lines_of(self, raw: Raw) -> list[int]:
        some = raw if isinstance(raw, list) else []
        return [each for each in some if type(each) is int and 0 < each <= self._lines]


def _goes_on(reply: Reply) -> bool:
    return reply.stop in (Stop.ANSWERED, Stop.EXCEPTION)


def _usual(lines: Sequence[int]) -> int:
    return max(sorted(set(lines)), key=lines.count, default=0)


def _pairs(raw: Raw, places: Sequence[int]) -> list[tuple[int, Raw]]:
    if not isinstance(raw, list) or len(raw) != len(places):
        raise LostError
    return [(at, each[0]) for at, each in zip(places, raw, strict=True) if isinstance(each, list) and each]


def _plain(argument: Any) -> Any:
    """As it can be sent within others: an array as its bytes."""
    return argument.tobytes() if type(argument) is array else argument
