"""Cases for ever, from all that is known of a kata: what its data do not hold may be among them.

Five ways take turns. A turn depends on the seed, its number and the cases that were found before it, on no
clock.

    edge       along one number of a known case, to the last case that is valid and has as many answers
    rows       a row of problem.py with one literal changed, later with two or three
    near       a case with one of the least gaps, one to three steps away
    changed    the same from any case of the data
    plain      numbers of one kind and size, over the whole of the bounds

Fresh seeds of the kata's own groups are none: what its rows do not draw, no seed draws.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from random import Random
from typing import Any, NamedTuple

from judge.data import ProblemData
from judge.diagnose.candidates import numbers_of, with_numbers
from judge.holes.rows import Rows
from judge.problem import Case, Group
from judge.values import parameters
from judge.values.answers import Exact, Target
from judge.values.atoms import Number
from judge.values.letters import TextType, texts_of

_CASES = 24  # of a turn of the ways that draw
_NEAREST = 400  # cases with the least gaps
_POOL = 3000  # cases of the data that are changed
_STEPS = 110  # of a walk to an edge, of which so many get longer
_GROWING = 48
_SMALL = (2, 3, 5, 10, 20, 100, 1000)


class Tried(NamedTuple):
    """A valid case and what answers to it are held against; of one of the data the hash of its group, too.

    Of any other the exact answer, the least gap of each decision that is not exact, the way that it came by,
    and the changed row that drew it.
    """

    case: Case
    target: Target
    group: Group
    place: str = ""
    exact: Exact = None
    gaps: Mapping[str, float] = {}
    way: str = ""
    row: str = ""

    @property
    def least(self) -> float:
        """The least gap of them all; infinite where nothing was decided."""
        return min(self.gaps.values(), default=math.inf)


class Stream:
    """Cases of one kata; `solve` gives what a valid case comes to, and None for any other.

    `near` are cases that were found worth changing.
    """

    # a turn along an edge tries five times as many cases as one of a row
    ways: Sequence[str] = ("edge", "rows", "near", "rows", "changed", "rows", "plain", "rows")

    def __init__(
        self, data: ProblemData, solve: Callable[[Case], Tried | None], seed: int, near: Sequence[Case]
    ) -> None:
        self._problem, self._solve, self._seed = data.problem, solve, seed
        cases = [case for each in data.groups if each.group.size is None for case in each.cases]
        self._pool = cases[:: len(cases) // _POOL + 1]
        gaps = sorted((found.least, at) for at, case in enumerate(self._pool) if (found := solve(case)))
        self._least = [self._pool[at] for _, at in gaps[:_NEAREST]]
        self.near, self._rows = [*near], Rows(data, seed)
        self._ways: dict[str, Callable[[Random, int], Iterator[Tried | None]]] = {
            "edge": self._edge,
            "rows": self._changed_row,
            "near": lambda random, _: self._steps(random, [*self._least, *self.near]),
            "changed": lambda random, _: self._steps(random, self._pool),
            "plain": self._plain,
        }

    def turn(self, number: int) -> list[Tried]:
        """The valid cases of the turn of that number, of one way."""
        way = self.ways[number % len(self.ways)]
        own = number * self.ways.count(way) // len(self.ways)
        found = self._ways[way](Random(f"{self._seed}/{way}/{own}"), own)
        return [each._replace(way=way) for each in found if each]

    def _changed_row(self, random: Random, number: int) -> Iterator[Tried | None]:
        text, cases = self._rows.turn(random, number)
        found = map(self._solve, cases)
        yield from (each and each._replace(row=text) for each in found)

    def _plain(self, random: Random, _: int) -> Iterator[Tried | None]:
        for _ in range(_CASES):
            number = _plain_number(random)
            values = (
                parameters.simple(
                    each.type, random.randint, partial(number, each.low, each.high), positive=each.low >= 0
                )
                for each in self._problem.parameters
            )
            yield self._solve(tuple(values))

    # -- along one number --------------------------------------------------------------------------------

    def _edge(self, random: Random, _: int) -> Iterator[Tried | None]:
        """To the end of what is valid and has this form of answer, by bisection; then arguments far off."""
        start = random.choice([*self._least, *self.near] if random.random() < 0.7 else self._pool)
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
            else:
                other = inside + step if turn < _GROWING else inside
            if other in (inside, outside):
                break
            case = with_numbers(start, [*numbers[:at], other, *numbers[at + 1 :]])
            found = self._solve(case)
            if found is None or form(found.exact) != form(solved.exact):
                outside = other
                continue
            inside, step, best = other, step * 3, case
            yield found
        if best is not None:
            if len(self.near) < _NEAREST:
                self.near.append(best)
            for place in range(len(best)):
                yield from (self._solve(_scaled(best, power, place)) for power in (-40, -20, 20, 40))

    # -- steps from a case -------------------------------------------------------------------------------

    def _steps(self, random: Random, pool: Sequence[Case]) -> Iterator[Tried | None]:
        for _ in range(_CASES if pool else 0):
            case = random.choice(pool)
            for _ in range(random.choice((1, 1, 2, 3))):
                case = self._step(random, case)
            yield self._solve(case)

    def _step(self, random: Random, case: Case) -> Case:
        """One thing of a case changed: a number, an argument, or all of it."""
        numbers, at = list(numbers_of(case)), random.randrange(len(case))
        way = random.randrange(13)
        if way < 8 and numbers:
            place = random.randrange(len(numbers))
            numbers[place] = _stepped(random, numbers, place, way, self._whole(case)[place])
            return with_numbers(case, numbers)
        changed = [*case]
        if way in (8, 9):
            return tuple(_scaled(case, random.randint(-60, 60), at if way == 8 else None))
        if way == 10:
            changed[at] = random.choice(self._pool)[at]
        elif way == 11:
            to = random.randrange(len(case))
            changed[at], changed[to] = changed[to], changed[at] if random.random() < 0.7 else changed[to]
        else:
            texts = texts_of(self._problem.parameters[at].type)
            changed[at] = _changed(random, case[at], texts[0] if texts else None)
        return tuple(changed)

    def _whole(self, case: Case) -> list[bool]:
        """Which of its numbers are ints by their type."""
        pairs = zip(self._problem.parameters, case, strict=True)
        return [not each.type.measured for each, value in pairs for _ in numbers_of((value,))]


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
    """Another number for that of one place, in eight ways."""
    value, other, size = numbers[at], random.choice(numbers), max(map(abs, numbers))
    sign, power, spread = random.choice((-1, 1)), random.randint(-60, 60), random.randint(1, 9)
    try:
        if way < 4:
            scaled = value * 2 ** (abs(power) % 41) if whole else value * 2.0**power
            return (random.choice((0, 1, -1, 2, 3)), sign * other, -value, scaled)[way]
        if whole:
            most = (1, 9, 10**spread, 10**spread)[way - 4]
            return value + sign * random.randint(1, most)
        near = value * (1 + random.uniform(-1, 1) * 10.0 ** (1 - spread))
        far = value + size * random.uniform(-1, 1) * 10.0 ** (1 - spread)
        return (math.nextafter(value, sign * math.inf), near, far, float(f"{value:.{spread}g}"))[way - 4]
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


def _scaled(value: Any, power: int, only: int | None = None) -> Any:
    """All numbers times a power of two, or those of one place."""
    if isinstance(value, tuple):
        return tuple([_scaled(each, power) if only in (None, at) else each for at, each in enumerate(value)])
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
