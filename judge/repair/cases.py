"""The cases that a wrong program is asked, what is known of its figure, and whether an answer is right."""

from __future__ import annotations

import math
import random
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property, partial
from itertools import combinations, permutations
from typing import Any, NamedTuple

from msgspec import Struct

from judge.data import GroupData, ProblemData
from judge.problem import Case
from judge.run.result import Behaviour
from judge.values.answers import Target
from judge.values.check import is_right
from judge.values.types import ListType, lasting
from judge.values.wire import Raw

_ALIKE = 1e-7  # of the figure: two points nearer than that are one
_BEYOND = 1e-9  # of the figure: a point so far beyond an end is still on it
_MOST_ITEMS = 4  # of a list whose orders are tried
_MOST_RIGHT = 500  # of a group's cases, of those that are answered rightly
_MOST_NUMBERS = 650  # of a case: one with more is too long to be called by the thousand
_LEAST_SHARE = 0.3  # of the cases that a guard would catch, so many must fail


class Asked(NamedTuple):
    """One case, with what its answer is held against."""

    group: GroupData
    place: int  # in the group
    case: Case
    target: Target


class Figure(Struct, frozen=True):
    """The numbers of a case by name: what is a point, an end of its line, a direction, a length."""

    points: Mapping[str, tuple[Any, ...]]
    ends: Mapping[str, tuple[Any, ...]]
    ways: Mapping[str, tuple[Any, ...]]
    lengths: Mapping[str, tuple[Any, ...]]

    @property
    def all_points(self) -> dict[str, tuple[Any, ...]]:
        """The ends too."""
        return {**self.points, **self.ends}

    @property
    def along(self) -> tuple[tuple[Any, ...], tuple[Any, ...]] | None:
        """Two points that a line is given by, where there are such."""
        ends = [*self.ends.values()]
        return (ends[0], ends[1]) if len(ends) == 2 else None

    @property
    def size(self) -> float:
        """Its largest extent."""
        axes = [*zip(*self.all_points.values(), strict=False)]
        spread = [float(max(axis)) - float(min(axis)) for axis in axes]
        return max([*spread, *(float(each[0]) for each in self.lengths.values())], default=1.0)

    @property
    def length(self) -> float:
        """How long the line's direction is; the size where there is none."""
        way = next(iter(self.ways.values()), None)
        if way is None and self.along is not None:
            way = tuple(b - a for a, b in zip(*self.along, strict=True))
        return (math.hypot(*map(float, way)) if way else self.size) or 1.0

    def same(self) -> Iterable[str]:
        """What coincides in it: two points as "A=B", a direction or a length that is 0 as "D=0"."""
        some = self.ends if len(self.ends) == 2 and len(self.all_points) > 2 else self.all_points
        for one, other in combinations(some, 2):
            if some[one] == some[other]:
                yield f"{one}={other}"
        for name, numbers in {**self.ways, **self.lengths}.items():
            if not any(numbers):
                yield f"{name}=0"


def figure_of(data: ProblemData, case: Case) -> Figure | None:
    """The case's figure, as far as the kata tells of it."""
    hook = data.module.hooks.figure
    found: dict[str, dict[str, tuple[Any, ...]]] = {"point": {}, "end": {}, "way": {}, "length": {}}

    def note(role: str, name: str, numbers: tuple[Any, ...]) -> tuple[Any, ...]:
        found[role][name] = numbers
        return numbers

    if hook is None or hook(data.problem, case, note) is None:
        return None
    return Figure(found["point"], found["end"], found["way"], found["length"])


class Cases:
    """Those of which it is known whether the program fails, in the order of the groups."""

    def __init__(self, data: ProblemData, does: Behaviour) -> None:
        self.data, self.problem = data, data.problem
        self.all: list[Asked] = []
        self.wrong: list[int] = []
        for group in data.groups:
            answers = does.get(group.group.name)
            if answers is None or group.group.size is not None:
                continue
            reached = min(answers.reached, len(group.cases))
            for place in range(reached):
                wrong = place in answers.wrong
                if (place >= _MOST_RIGHT and not wrong) or len(numbers(group.cases[place])) > _MOST_NUMBERS:
                    continue
                if wrong:
                    self.wrong.append(len(self.all))
                self.all.append(Asked(group, place, group.cases[place], group.targets[place]))
        self.several = isinstance(lasting(data.problem.answer), ListType)  # not parts of one thing
        self._known: dict[tuple[int, str], bool] = {}

    @cached_property
    def figures(self) -> list[Figure | None]:
        """The figure of each case."""
        return [figure_of(self.data, each.case) for each in self.all]

    @cached_property
    def sizes(self) -> list[tuple[float, float]]:
        """Of each figure its size, and the length of its direction."""
        return [(each.size, each.length) if each else (1.0, 1.0) for each in self.figures]

    @cached_property
    def same(self) -> Mapping[str, frozenset[int]]:
        """What coincides, with the cases where it does."""
        found: dict[str, list[int]] = {}
        for at, figure in enumerate(self.figures):
            for each in figure.same() if figure else ():
                found.setdefault(each, []).append(at)
        return {name: frozenset(some) for name, some in found.items() if "[" not in name}

    def guards(self, wrong: frozenset[int]) -> Iterable[tuple[str, frozenset[int]]]:
        """What coincides in cases that mostly fail."""
        for name, some in self.same.items():
            if len(some & wrong) >= max(1, _LEAST_SHARE * len(some)):
                yield name, some

    def tests(self) -> list[str]:
        """What coincides, as Python asks it of the arguments in `_case_`."""
        names = [each.name for each in self.problem.parameters]

        def value(name: str) -> str:
            parts = [f"_case_[{names.index(each)}]" for each in name.strip("()").split(", ")]
            return parts[0] if len(parts) == 1 else f"({', '.join(parts)})"

        found = []
        for each in self.same:
            one, other = each.split("=")
            way = any(figure and one in figure.ways for figure in self.figures)
            zero = f"not any({value(one)})" if way else f"not {value(one)}"
            found.append(zero if other == "0" else f"tuple({value(one)}) == tuple({value(other)})")
        return found

    def right(self, at: int, raw: Raw, after: Sequence[str] = ()) -> bool:
        """Whether that answer to the case is right, changed as `after` says."""
        key = at, f"{after}{raw!r}"
        if key not in self._known:
            self._known[key] = self._decided(at, raw, after)
        return self._known[key]

    def _decided(self, at: int, raw: Raw, after: Sequence[str]) -> bool:
        asked = self.all[at]
        for change in after:
            raw = self._changed(at, raw, change)
        exact = partial(self.data.exact, asked.case, asked.group.group)
        if "order" in after and isinstance(raw, list) and 2 <= len(raw) <= _MOST_ITEMS:
            orders = [list(each) for each in permutations(raw)]
            return any(is_right(self.problem.answer, each, asked.target, exact) for each in orders)
        return is_right(self.problem.answer, raw, asked.target, exact)

    def _changed(self, at: int, raw: Raw, change: str) -> Raw:
        """The answer with equal items once, or without the points beyond the ends."""
        if not isinstance(raw, list) or not all(map(_is_row, raw)):
            return raw
        size = self.sizes[at][0]
        if change == "once":
            kept: list[Raw] = []
            for each in raw:
                if not any(_near(each, other, _ALIKE * size) for other in kept):
                    kept.append(each)
            return kept
        figure = self.figures[at]
        if change == "filter" and figure is not None and figure.along is not None:
            return [each for each in raw if _within(each, *figure.along, _BEYOND * size)]
        return raw

    def spread(self, places: Iterable[int], most: int) -> list[int]:
        """So many of the places, from as many groups as there are: the same in every run."""
        groups: dict[str, list[int]] = {}
        for at in sorted(places):
            groups.setdefault(self.all[at].group.group.name, []).append(at)
        chance = random.Random(7)
        for some in groups.values():
            some.sort(key=lambda _: chance.random())
        found: list[int] = []
        while groups and len(found) < most:
            found += [some.pop() for some in groups.values()]
            groups = {name: some for name, some in groups.items() if some}
        return found[:most]


def numbers(value: Any) -> list[Any]:
    """Those in a case; an array is one."""
    if isinstance(value, tuple | list):
        return [x for each in value for x in numbers(each)]
    return [] if isinstance(value, str) else [value]


def _is_row(raw: Raw) -> bool:
    row = raw if isinstance(raw, list) else [raw]
    return bool(row) and all(type(each) in (int, float) for each in row)


def _near(one: Raw, other: Raw, width: float) -> bool:
    pair = [each if isinstance(each, list) else [each] for each in (one, other)]
    return len(pair[0]) == len(pair[1]) and all(abs(a - b) <= width for a, b in zip(*pair, strict=True))


def _within(point: Raw, start: Sequence[Any], end: Sequence[Any], width: float) -> bool:
    if not isinstance(point, list) or len(point) != len(start):
        return True
    way = [float(b - a) for a, b in zip(start, end, strict=True)]
    length = math.hypot(*way) or 1.0
    along = math.fsum((p - float(a)) * d for p, a, d in zip(point, start, way, strict=True)) / length
    return -width <= along <= length + width
