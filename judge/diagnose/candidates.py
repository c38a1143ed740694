"""Simple cases of any problem, and how simple a case is for a person.

A case's numbers come from a small pool, so that many of them are equal: what is special in a problem is
most often that two of its numbers are the same. The pool's numbers are small integers m, or m·10^k, or
m·10^k + n, and all may be multiplied by 10^-u. Each candidate set fixes k and u; the first levels are the
simplest. In a lone set one coordinate of one point is m·10^k and all other numbers are small: what only
just happens, far from all the rest, is found in no other way.

Where there are texts or lists, the first level also has the least cases that the bounds leave, in order: what
depends on a length and an int, or on two texts, is small only where both are.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from heapq import nsmallest
from itertools import count, islice, product
from operator import or_
from typing import Any

from msgspec import Struct

from judge.data.draw import Draw, seeded
from judge.problem import Case, Group, Problem
from judge.values import parameters
from judge.values.atoms import Atom, Number, NumberType, Type, Value
from judge.values.letters import TextType, rank
from judge.values.types import ListType, atoms, is_pair, lasting

Simplicity = tuple[int, int, tuple[float, ...]]

_NUMBERS = (int, float)
_FLOAT = 2  # a float weighs as much as an integer of so many digits more
_POOL = 3
_LEAST = 600  # of the least cases, of so many that are looked at
_LOOKED_AT = 20_000
_FEW = 3  # letters of a least text, items of a list, values of an item: beyond the least, or in all


class CandidateSet(Struct, frozen=True):
    """One kind of simple numbers: up to `reach`, with tens of 10^`tens`, in units of 10^-`unit`.

    With `lone`, a single coordinate has the tens. The cases need not keep the bounds or the promise.
    """

    reach: int
    count: int
    tens: int = 0
    unit: int = 0
    floats: bool = False
    lone: bool = False

    def cases(self, problem: Problem) -> Iterator[Case]:
        """As many cases as it has, the same every time."""
        numbers = f"reach={self.reach}, tens={self.tens}, unit={self.unit}"
        seed = f"Rung({numbers}, floats={self.floats}, lone={self.lone})"  # of another there are other cases
        for number in range(self.count):
            draw = Draw(seeded(f"{seed}/{number}"))
            yield self._lone(draw, problem) if self.lone else self._pooled(draw, problem)

    def _pooled(self, draw: Draw, problem: Problem) -> Case:
        pool = [self._number(draw) for _ in range(_POOL)]

        def number(positive: bool) -> Number:
            place = draw.integer(0, 2 * _POOL)
            if place > _POOL:
                value = pool[place - _POOL - 1]
            else:
                value = draw.integer(0, 1) * draw.integer(0, self.reach)
            return self._typed(value if positive else value * draw.sign())

        return tuple(
            parameters.simple(parameter.type, draw.integer, number, positive=parameter.low >= 0)
            for parameter in problem.parameters
        )

    def _lone(self, draw: Draw, problem: Problem) -> Case:
        points = [is_pair(parameter.type) for parameter in problem.parameters]
        far = draw.integer(0, 2 * sum(points) - 1)  # the coordinate that is far away
        coordinates = iter(range(2 * sum(points)))

        def coordinate() -> Number:
            size = 10**self.tens if next(coordinates) == far else 1
            return self._typed(draw.integer(size > 1, self.reach) * size * draw.sign())

        return tuple(
            (coordinate(), coordinate())
            if is_point
            else self._typed(draw.integer(0, self.reach) * (parameter.low >= 0))
            for is_point, parameter in zip(points, problem.parameters, strict=True)
        )

    def _number(self, draw: Draw) -> int:
        near = draw.integer(0, self.reach)
        if not self.tens:
            return near
        kind = draw.integer(0, 2)
        far: int = draw.integer(1, self.reach) * 10**self.tens
        return (near, far, far + near * draw.sign())[kind]

    def _typed(self, value: int) -> Number:
        if self.unit:
            return value / int(10**self.unit)
        return float(value) if self.floats else value


class LeastCases(Struct, frozen=True):
    """The cases of which all parameters have the shortest and smallest values that the bounds leave."""

    def cases(self, problem: Problem) -> Iterator[Case]:
        """The simplest ones, each once; none where the values of a type cannot be listed."""
        most = max(2, int(_LOOKED_AT ** (1 / max(1, len(problem.parameters)))))
        bounds = ((each.type, math.ceil(each.low), math.floor(each.high)) for each in problem.parameters)
        values = [list(islice(_least(*each), most)) for each in bounds]
        yield from nsmallest(_LEAST, islice(product(*values), _LOOKED_AT), key=measure)


def _least(type_: Type, low: int, high: int) -> Iterator[Value]:
    """The values of a type, the shortest and smallest first, all its numbers within the bounds."""
    inner = lasting(type_)
    if inner is not type_:
        yield None
    if isinstance(inner, NumberType):
        low = low if inner.low is None else max(low, inner.low)
        high = high if inner.high is None else min(high, inner.high)
        first = min(max(0, low), high)
        near = (value for by in count() for value in dict.fromkeys((first + by, first - by)))
        yield from (value for value in islice(near, 100) if low <= value <= high)
    elif isinstance(inner, TextType):
        for length in range(inner.low, min(inner.high, inner.low + _FEW) + 1):
            yield from map("".join, islice(product(inner.signs[:2], repeat=length), 2**_FEW))
    elif isinstance(inner, Atom):
        yield from inner.samples
    else:
        some = [list(islice(_least(each, low, high), _FEW)) for each in inner.made_of]
        lengths = [len(some)]
        if isinstance(inner, ListType):
            most = inner.low + _FEW
            lengths = [*range(inner.low, 1 + min(most, most if inner.high is None else inner.high))]
        for length in lengths:
            parts = islice(product(*(some if inner.kind is tuple else some * length)), _FEW**_FEW)
            yield from filter(lambda value: value is not None, map(inner.arranged, parts))


def sized(problem: Problem) -> bool:
    """Whether there are texts or lists, and no real numbers: every case is made of few simple pieces."""
    types = [parameter.type for parameter in problem.parameters]
    texts = any(isinstance(atom, TextType) for type_ in types for atom in atoms(type_))
    lists = any(isinstance(lasting(type_), ListType) for type_ in types)
    return (texts or lists) and not any(type_.measured for type_ in types)


def candidates(problem: Problem) -> Iterator[Sequence[CandidateSet | LeastCases]]:
    """The levels for a problem, the simplest first."""
    least = [LeastCases()] if sized(problem) else []
    yield [CandidateSet(1, 100), CandidateSet(3, 400), *least]
    yield [CandidateSet(9, 400)]
    if not any(parameter.type.measured for parameter in problem.parameters):
        yield from ([CandidateSet(3, 250, tens)] for tens in (1, 2, 3, 4, 5, 6, 8, 10, 16, 20, 30))
        return
    points = [is_pair(parameter.type) for parameter in problem.parameters]
    plain = [parameter.type.width == 1 for parameter in problem.parameters]
    has_lone = any(points) and all(map(or_, points, plain))  # beside points there are only numbers
    yield [CandidateSet(3, 150, floats=True), CandidateSet(3, 100, unit=1)]
    for tens in (2, 4, 6, 8):
        yield [CandidateSet(3, 150, tens), CandidateSet(3, 150, tens, floats=True)]
        if tens < 6 and has_lone:
            yield [CandidateSet(2, 150, lone, lone=True) for lone in (tens, tens + 1)]
    yield from ([CandidateSet(3, 150, unit=unit)] for unit in (9, 7, 11, 13, 5, 3))
    yield from ([CandidateSet(3, 150, unit, unit)] for unit in (3, 6))


def usual_group(problem: Problem) -> Group:
    """The group whose tolerance is the problem's usual one: its grid, or the first of that tolerance."""
    usual, _ = Counter(group.tolerance for group in problem.groups).most_common(1)[0]
    groups = [group for group in problem.groups if group.tolerance == usual]
    return next((group for group in groups if group.name == "grid"), groups[0])


def _pieces(case: Case) -> Iterator[Any]:
    """What a case is made of, in order, however deep in it."""
    for argument in case:
        if isinstance(argument, tuple):
            yield from _pieces(argument)
        else:
            yield argument


def numbers_of(case: Case) -> Iterator[Number]:
    """The numbers of a case, in order; texts, bools and None are none."""
    return (each for each in _pieces(case) if type(each) in _NUMBERS)  # no bool


def texts_of(case: Case) -> Iterator[str | bool]:
    """The texts and bools of a case, in order."""
    return (each for each in _pieces(case) if isinstance(each, str | bool))


def items_of(case: Case) -> int:
    """How many items its lists and points have, however deep in it: as many in all cases of one shape."""
    return sum(len(argument) + items_of(argument) for argument in case if isinstance(argument, tuple))


def with_numbers(case: Case, numbers: Iterable[Number]) -> Case:
    """The case with other numbers in their places."""
    left = iter(numbers)

    def renewed(argument: Any) -> Any:
        if isinstance(argument, tuple):
            return with_numbers(argument, left)
        return next(left) if type(argument) in _NUMBERS else argument

    return tuple([renewed(argument) for argument in case])


def _digits(number: Number) -> int:
    """How many characters a person reads: all of an int's digits, what `repr` writes of a float; 0 has none.

    A sign and a float's final `.0` do not count.
    """
    if number == 0:
        return 0
    if isinstance(number, int):
        # Very large ones need not be written to be known as large.
        bits = number.bit_length()
        return len(str(abs(number))) if bits < 2000 else bits * 3 // 10
    return len(repr(abs(number)).removesuffix(".0").replace("e-0", "e-").replace("e+", "e"))


def measure(case: Case) -> Simplicity:
    """What to compare two cases by, the smaller being simpler.

    An item of a list, a letter and True weigh as a digit; of letters the nearer ones to `a` are simpler.
    """
    numbers = list(numbers_of(case))
    total = sum(_digits(number) + (_FLOAT if isinstance(number, float) else 0) for number in numbers)
    magnitudes = [_magnitude(number) for number in numbers]
    negative = sum(number < 0 for number in numbers)
    for each in texts_of(case):
        total += each if isinstance(each, bool) else len(each)
        magnitudes += map(rank, each) if isinstance(each, str) else ()
    return items_of(case) + total, negative, (math.fsum(magnitudes), *magnitudes)


def _magnitude(number: Number) -> float:
    """The distance from 1 as a factor, either way; 0 is the simplest."""
    try:
        size = abs(float(number))
        return size if size >= 1 or size == 0 else 1 / size
    except (OverflowError, ZeroDivisionError):
        return float("inf")
