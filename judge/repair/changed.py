"""Question 1: is the program right where it is asked in another way? No source is needed.

Each call in a process of its own; whole numbers as doubles; the figure moved, so that its first point is the
origin; the figure scaled to size 1 by a power of two. The exact answer to the other case is known, so that
nothing need be undone.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from judge.data.build import target_of, validate
from judge.problem import Case
from judge.problem.declare import InvalidCase
from judge.repair.cases import Asked, Cases, figure_of
from judge.run.runner import Runner
from judge.sandbox.boundary import Box, Limits, Stop
from judge.values.answers import Exact
from judge.values.check import Accepted

WAYS = ("fresh", "doubles", "moved", "scaled")
_WRONG, _RIGHT = 24, 12  # cases of each kind that are asked
_FIRST = 3  # of the wrong ones: where all are wrong in a process of their own, no more are asked
_MOST_SECONDS = 4.0  # of all processes, where each takes long
_LEAST = 2  # cases that must have become right

Other = tuple[Asked, Exact]  # another case in place of one that was asked, with its answer


class Changed:
    """The program in its box."""

    def __init__(self, cases: Cases, runner: Runner, box: Box) -> None:
        self._cases, self._runner, self._box = cases, runner, box
        self._seconds = 0.0  # of its processes so far, of CPU or asleep
        most, items = cases.problem.limits, cases.problem.answer.items
        self._limits = Limits(
            most.cpu_seconds, most.wall_seconds, most.memory_bytes, most.output_bytes, items=items
        )
        wrong = frozenset(cases.wrong)
        self._wrong = [cases.all[at] for at in cases.spread(wrong, _WRONG)]
        right = (at for at in range(len(cases.all)) if at not in wrong)
        self._right = [cases.all[at] for at in cases.spread(right, _RIGHT)]

    def ways(self) -> tuple[str, ...]:
        """Those in which all of the wrong cases become right, and the right ones stay so."""
        if self._fresh():
            return ("fresh",)
        return tuple(way for way in WAYS[1:] if self._one(way))

    def _fresh(self) -> bool:
        sample = [*self._wrong[:_FIRST], *self._right[:1], *self._wrong[_FIRST:], *self._right[1:]]
        return bool(self._wrong) and all(
            self._right_in([(each, self._cases.data.exact(each.case, each.group.group)[0])])
            for each in sample
        )

    def _one(self, way: str) -> bool:
        """Whether it is right in that way, as far as there are such cases."""
        for some, least in ((self._wrong, max(_LEAST, len(self._wrong) // 2)), (self._right, 0)):
            others = [other for each in some if (other := self._other(way, each)) is not None]
            if len(others) < min(least, len(some)) or (others and not self._right_in(others)):
                return False
        return bool(self._wrong)

    def _right_in(self, others: Sequence[Other]) -> bool:
        if self._seconds > _MOST_SECONDS:
            return False
        replies = self._runner.ask(self._box, [each.case for each, _ in others], self._limits)
        used = replies.usage + replies.imported
        self._seconds += used.cpu_seconds + used.slept_seconds
        if replies.breakdown is not None or len(replies.replies) < len(others):
            return False
        for reply, (each, exact) in zip(replies.replies, others, strict=True):
            tolerance = each.group.group.tolerance
            if reply.stop is not Stop.ANSWERED:
                return False
            told = self._runner.decide(reply.answer, each.target, lambda: (exact, tolerance))  # noqa: B023
            if not isinstance(told, Accepted):
                return False
        return True

    def _other(self, way: str, asked: Asked) -> Other | None:
        """The case so changed; None where it cannot be, exactly, or that changes nothing."""
        whole = any("integer" in each.type.text for each in self._cases.problem.parameters)
        if way == "doubles":
            case: Case | None = None if whole else _floated(asked.case)
        else:
            case = moved(self._cases, asked.case, scale=way == "scaled")
        if case is None or repr(case) == repr(asked.case):
            return None
        try:
            exact = validate(self._cases.problem, self._cases.data.module, case)
        except InvalidCase:
            return None
        target = target_of(self._cases.problem, exact, asked.group.group.tolerance)
        return asked._replace(case=case, target=target), exact


def _floated(value: Any) -> Any:
    if isinstance(value, tuple):
        return tuple(map(_floated, value))
    return float(value) if type(value) is int and abs(value) <= 2**53 else value


def moved(cases: Cases, case: Case, *, scale: bool) -> Case | None:
    """The case with its first point at the origin, or at size 1; None where floats cannot hold it."""
    figure, hook = figure_of(cases.data, case), cases.data.module.hooks.figure
    if figure is None or hook is None or (scale and not 0 < figure.size < math.inf):
        return None
    unit = Fraction(2) ** -math.frexp(figure.size)[1] if scale else Fraction(1)
    origin: list[Fraction] = []
    exact = True

    def change(role: str, _name: str, numbers: tuple[Any, ...]) -> tuple[Any, ...]:
        nonlocal exact
        wanted = [Fraction(x) * unit for x in numbers]
        if role in ("point", "end") and not scale:
            origin[:] = origin or wanted
            wanted = [x - by for x, by in zip(wanted, origin, strict=True)]
        pairs = zip(numbers, wanted, strict=True)
        made = [int(x) if type(old) is int and x.denominator == 1 else float(x) for old, x in pairs]
        exact = exact and made == wanted
        return tuple(made)

    other = hook(cases.problem, case, change)
    return other if exact else None
