"""Mistakes made before a right way begins, with its input, or after it has ended, with its answer.

They are written once for all problems, as Python; a problem has those that its groups' `kills` name.
What they may touch follows from the types of parameters and answer.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import Struct

from judge.problem import Problem

HELPERS = '''\
def each(value, change):
    """The value with every number in it changed."""
    if isinstance(value, (list, tuple)):
        return type(value)([each(item, change) for item in value])
    if value is None or isinstance(value, (bool, str)):
        return value
    return change(value)


def single(x):
    """The nearest 32-bit float."""
    import struct

    try:
        return struct.unpack("f", struct.pack("f", x))[0]
    except OverflowError:
        return float("inf") if x > 0 else float("-inf")


def wrapped(x, bits):
    """A whole number as an integer of so many bits holds it."""
    return (int(x) + (1 << bits - 1)) % (1 << bits) - (1 << bits - 1)'''

_PLACES = (2, 3, 4, 6, 8, 9, 12)
_DIGITS = (6, 8)


class Transform(Struct, frozen=True):
    """A mistake by its name, and the expression of `given` or of `answer` that makes it."""

    name: str
    expression: str
    after: bool = False

    @property
    def line(self) -> str:
        """The line of a program that does it."""
        return f"answer = {self.expression}" if self.after else f"given = {self.expression}"


def transforms(problem: Problem) -> tuple[Transform, ...]:
    """Those that make sense for a problem's types."""
    return (*_before(problem), *_after(problem))


def _before(problem: Problem) -> Iterator[Transform]:
    yield Transform("whole-numbers", "[each(value, int) for value in given]")
    yield Transform("whole-numbers", "[each(value, round) for value in given]")
    for places in _PLACES:
        yield Transform("rounded-input", f"[each(value, lambda x: round(x, {places})) for value in given]")
    yield Transform("single-precision", "[each(value, single) for value in given]")
    yield Transform("float-coordinates", "[each(value, lambda x: int(float(x))) for value in given]")
    for place, name in _pairs(problem):
        kept = f"*given[:{place}], " if place else ""
        rest = f", *given[{place + 1} :]" if place + 1 < len(problem.parameters) else ""
        yield Transform("swapped-coordinates", f"[{kept}given[{place}][::-1]{rest}]  # {name} as (y, x)")


def _pairs(problem: Problem) -> Sequence[tuple[int, str]]:
    """The parameters that are pairs of numbers, with their places."""
    return [(i, each.name) for i, each in enumerate(problem.parameters) if each.type.width == 2]


def _after(problem: Problem) -> Iterator[Transform]:
    answer = problem.answer
    if answer.measured:
        for places in _PLACES:
            yield _answered("rounded-output", f"each(answer, lambda x: round(x, {places}))")
        for digits in _DIGITS:
            yield _answered("rounded-output", f'each(answer, lambda x: float(f"{{x:.{digits}g}}"))')
        yield _answered("single-precision", "each(answer, single)")
        yield _answered("whole-numbers", "each(answer, int)")
    if answer.lengths > 1:
        several = "answer if answer is None else"
        yield _answered("reversed-order", f"{several} answer[::-1]")
        yield _answered("none-for-empty", "answer or None")
        if answer.width is None:
            yield _answered("swapped-coordinates", f"{several} [item[::-1] for item in answer]")


def _answered(name: str, expression: str) -> Transform:
    return Transform(name, expression, after=True)
