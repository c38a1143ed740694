"""Cases for ever, from all that is known of a kata: what its data do not hold may be among them.

Six ways take turns, so that each tries as many cases. A turn depends on the seed, its number and the cases
that were found before it, on no clock.

    edge       along one number of a known case, to the last case that is valid and has as many answers
    rows       a row of problem.py with one literal changed, later with two or three
    near       a case with one of the least gaps, one to three steps away
    changed    the same from any case of the data
    plain      numbers of one kind and size, over the whole of the bounds
    scenes     the kata's own groups, drawn afresh
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from random import Random
from typing import Any, NamedTuple

from msgspec import Struct

from judge.data import ProblemData
from judge.data.build import Fresh
from judge.diagnose.candidates import numbers_of, with_numbers
from judge.holes.rows import Rows
from judge.problem import Case
from judge.problem.model import EXAMPLES
from judge.values import parameters
from judge.values.answers import Exact
from judge.values.atoms import Number, NumberType
from judge.values.letters import TextType, texts_of

_CASES = 24  # of a turn of the ways that draw
_NEAREST = 400  # cases with the least gaps
_POOL = 3000  # cases of the data that are changed
_STEPS = 110  # of a walk to an edge, of which so many get longer
_GROWING = 48
_SMALL = (2, 3, 5, 10, 20, 100, 1000)


class FoundCase(NamedTuple):
    """A case, valid or not, the way that it came by, and the changed row that drew it."""

    case: Case
    way: str
    row: str = ""


class Solved(NamedTuple):
    """The exact answer to a valid case, and the least gap of each decision that is not exact."""

    exact: Exact
    gaps: dict[str, float]

    @property
    def least(self) -> float:
        """The least of them all; infinite where nothing was decided."""
        return min(self.gaps.values(), default=math.inf)


class StreamState(Struct):
    """Where a stream stands: turns and cases of each way, and cases that it found worth changing."""

    turns: dict[str, int] = {}
    tried: dict[str, int] = {}
    near: list[Case] = []


class Stream:
    """Cases of one kata; `solve` gives what a valid case comes to, and None for any other."""

    ways: Sequence[str] = ("edge", "rows", "near", "changed", "plain", "scenes")

    def __init__(
        self, data: ProblemData, solve: Callable[[Case], Solved | None], seed: int, place: StreamState
    ) -> None:
        self._problem, self._module, self._solve = data.problem, data.module, solve
        self._seed, self.place = seed, place
        self._groups = [
            each.group for each in data.groups if each.group.size is None and each.group.name != EXAMPLES
        ]
        cases = [case for each in data.groups if each.group.size is None for case in each.cases]
        self._pool = cases[:: len(cases) // _POOL + 1]
        gaps = sorted((found.least, at) for at, case in enumerate(self._pool) if (found := solve(case)))
        self._near = [self._pool[at] for _, at in gaps[:_NEAREST]]
        self._rows = Rows(data, seed)
        self._ways = {
            "edge": self._edge,
            "rows": self._rows.turn,
            "near": lambda random, _: self._steps(random, self._nearest),
            "changed": lambda random, _: self._steps(random, self._pool),
            "plain": self._plain,
            "scenes": self._scene,
        }

    @property
    def _nearest(self) -> Sequence[Case]:
        return [*self._near, *self.place.near]

    def turn(self) -> Iterator[FoundCase]:
        """The cases of the next turn, of the way that has tried the fewest."""
        place = self.place
        way = min(self.ways, key=lambda each: place.tried.get(each, 0))
        number = place.turns[way] = place.turns.get(way, 0) + 1
        place.tried[way] = place.tried.get(way, 0) + 1
        for case, row in self._ways[way](Random(f"{self._seed}/{way}/{number}"), number):
            place.tried[way] += 1
            yield FoundCase(case, way, row)

    def _plain(self, random: Random, _: int) -> Iterator[tuple[Case, str]]:
        for _ in range(_CASES):
            number = _plain_number(random)
            yield (
                tuple(
                    [
                        parameters.simple(
                            each.type,
                            random.randint,
                            partial(number, each.low, each.high),
                            positive=each.low >= 0,
                        )
                        for each in self._problem.parameters
                    ]
                ),
                "",
            )

    def _scene(self, random: Random, number: int) -> Iterator[tuple[Case, str]]:
        if self._groups:
            group = self._groups[number % len(self._groups)]
            fresh = Fresh(self._problem, self._module, [group], random.getrandbits(60))
            yield from ((case, "") for case in next(fresh.series()).cases)

    # -- along one number --------------------------------------------------------------------------------

    def _edge(self, random: Random, _: int) -> Iterator[tuple[Case, str]]:
        """To the end of what is valid and has this form of answer, by bisection; then arguments far off."""
        start = random.choice(self._nearest if random.random() < 0.7 else self._pool)
        solved, numbers = self._solve(start), list(numbers_of(start))
        if solved is None or not numbers:
            return
        at = random.randrange(len(numbers))
        whole = self._whole(start)[at]
        inside: Number = numbers[at]
        outside: Number | None = None
        size = max(map(abs, numbers)) or 1
        step: Number = int(size) // 10**9 + 1 if whole else size * 1e-9
        step *= random.choice((-1, 1))
        best = None
        for turn in range(_STEPS):
            if outside is not None:
                other = (inside + outside) // 2 if whole else inside + (outside - inside) / 2
            elif turn < _GROWING:
                other = inside + step
            else:
                break
            if other in (inside, outside):
                break
            case = with_numbers(start, [*numbers[:at], other, *numbers[at + 1 :]])
            found = self._solve(case)
            if found is None or form(found.exact) != form(solved.exact):
                outside = other
                continue
            inside, step, best = other, step * 3, case
            yield case, ""
        if best is not None:
            if len(self.place.near) < _NEAREST:
                self.place.near.append(best)
            for place in range(len(best)):
                yield from ((self._scaled(best, power, place), "") for power in (-40, -20, 20, 40))

    # -- steps from a case -------------------------------------------------------------------------------

    def _steps(self, random: Random, pool: Sequence[Case]) -> Iterator[tuple[Case, str]]:
        for _ in range(_CASES if pool else 0):
            case = random.choice(pool)
            for _ in range(random.choice((1, 1, 2, 3))):
                case = self._step(random, case)
            yield case, ""

    def _step(self, random: Random, case: Case) -> Case:
        """One thing of a case changed: a number, an argument, or all of it."""
        numbers, at = list(numbers_of(case)), random.randrange(len(case))
        way = random.randrange(13)
        if way < 8 and numbers:
            place = random.randrange(len(numbers))
            numbers[place] = _stepped(random, numbers, place, way, self._whole(case)[place])
            return with_numbers(case, numbers)
        if way == 8:
            return self._scaled(case, random.randint(-60, 60), at)
        if way == 9:
            return self._scaled(case, random.randint(-60, 60))
        if way == 10:
            return (*case[:at], random.choice(self._pool)[at], *case[at + 1 :])
        changed = [*case]
        if way == 11:
            to = random.randrange(len(case))
            changed[at], changed[to] = changed[to], changed[at] if random.random() < 0.7 else changed[to]
        else:
            texts = texts_of(self._problem.parameters[at].type)
            changed[at] = _changed(random, case[at], texts[0] if texts else None)
        return tuple(changed)

    def _whole(self, case: Case) -> list[bool]:
        """Which of its numbers are ints by their type."""
        pairs = zip(self._problem.parameters, case, strict=True)
        try:
            found = [leaf for each, value in pairs for leaf in parameters.leaves(each.type, value)]
        except (TypeError, ValueError):  # a changed case may be of another shape
            found = []
        kinds = [not atom.measured for atom, _ in found if isinstance(atom, NumberType)]
        return kinds + [True] * (len(list(numbers_of(case))) - len(kinds))

    def _scaled(self, case: Case, power: int, only: int | None = None) -> Case:
        """All numbers times a power of two, or those of one argument."""
        return tuple([_scaled(each, power) if only in (None, at) else each for at, each in enumerate(case)])


def _plain_number(random: Random) -> Callable[[Any, Any, bool], Number]:
    """What draws numbers of one kind and size between two bounds, perhaps none below 0."""
    kind, small = random.choice(("small", "bound", "log", "uniform", "mixed")), random.choice(_SMALL)
    reach = 2.0 ** random.uniform(-30, 40)

    def number(low: Any, high: Any, positive: bool) -> Number:
        value: Number
        if kind == "small":
            value = random.randint(-small, small)
        elif kind == "bound" and math.ceil(low) <= high:
            value = random.randint(math.ceil(low), math.floor(high))
        elif kind == "log":
            most = min(300.0, math.log10(max(1, high)))
            value = 10.0 ** random.uniform(-9, most) * random.choice((-1, 1))
        else:
            value = random.uniform(-reach, reach)
            value *= 10.0 ** random.randint(-6, 6) if kind == "mixed" else 1
        return abs(value) if positive else value

    return number


def _stepped(random: Random, numbers: Sequence[Number], at: int, way: int, whole: bool) -> Number:
    """Another number for that of one place: seven ways, and as it is."""
    value, other, size = numbers[at], random.choice(numbers), max(map(abs, numbers))
    try:
        if way == 0:
            return random.choice((0, 1, -1, 2, 3))
        if way == 1:
            return random.choice((other, -other))
        if way == 2:
            return -value
        if way == 3:
            return value * 2 ** random.randint(1, 40) if whole else value * 2.0 ** random.randint(-60, 60)
        if whole:
            spread = 9 if way < 6 else 10 ** random.randint(1, 9)
            return value + (random.choice((-1, 1)) if way == 4 else random.randint(-spread, spread))
        if way == 4:
            return math.nextafter(value, random.choice((-math.inf, math.inf)))
        if way == 5:
            return value * (1 + random.uniform(-1, 1) * 10.0 ** random.randint(-10, 0))
        if way == 6:
            return value + size * random.uniform(-1, 1) * 10.0 ** random.randint(-8, 0)
        return float(f"{value:.{random.randint(1, 6)}g}")
    except OverflowError:
        return value


def _changed(random: Random, value: Any, type_: TextType | None) -> Any:
    """A list with an item dropped, doubled or exchanged, or a text changed; the other bool."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, str) and type_ is not None:
        return _other_text(random, value, type_.signs)[: type_.high]
    if not isinstance(value, tuple) or not value:
        return value
    items, place = [*value], random.randrange(len(value))
    some = [[], [items[place]] * 2, [random.choice(items)]]
    if isinstance(items[place], str | bool):
        some += [[_changed(random, items[place], type_)]] * 3
    items[place : place + 1] = random.choice(some)
    return tuple(items)


def _other_text(random: Random, text: str, signs: str) -> str:
    """A piece of it dropped, doubled, turned or replaced; or a letter many times."""
    start, end = sorted(random.randint(0, len(text)) for _ in range(2))
    if random.random() < 0.5:
        end = min(start + 1, len(text))
    piece, sign = text[start:end], random.choice(text + signs)
    times = random.choice((1, 1, 2, 9, 10, 11))
    return text[:start] + random.choice(("", piece * 2, piece[::-1], sign, sign * times + piece)) + text[end:]


def _scaled(value: Any, power: int) -> Any:
    if isinstance(value, tuple):
        return tuple([_scaled(each, power) for each in value])
    if type(value) is float:
        return value * 2.0**power
    if type(value) is int:
        return value << power if power > 0 else value >> -power
    return value


def form(exact: Any) -> Any:
    """What of an answer is decided and not measured: how many, which words, which ints."""
    if isinstance(exact, tuple | list):
        return tuple(map(form, exact))
    return exact if exact is None or isinstance(exact, int | str) else "x"
