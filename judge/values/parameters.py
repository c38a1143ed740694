"""What a type is asked of a parameter's value: whether it is one, how it is written, what would be simpler.

A value is kept as plain Python: ints, floats, words and None, and tuples of them (points and lists too).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from typing import Any, Protocol

Number = int | float


class Draws(Protocol):
    """Where the search for simple cases takes its choices from; `judge.data.draw.Draw` is one."""

    def integer(self, low: int, high: int) -> int:
        """An int from `low` to `high`."""
        ...


class ParameterValues:
    """The half of `judge.values.type.Type` that deals with the values of parameters."""

    is_plain = True  # whether a submission receives a parameter's value as it is kept here

    def fault(self, name: str, value: Any) -> str | None:
        """What is wrong with the shape of a parameter's value, for a person, or None."""
        raise NotImplementedError

    def outside(self, value: Any, low: Fraction | int, high: Fraction | int) -> tuple[Any, Any, Any] | None:
        """The first number of a well-shaped value beyond the bounds, with these; None if there is none."""
        return None

    def reals(self, value: Any) -> Iterator[Number]:
        """The numbers of a well-shaped value that are of the type `real`."""
        return iter(())

    def tokens(self, value: Any) -> Iterator[str]:
        """The value as a program reads it: numbers as `repr` writes them, a list begins with its length."""
        raise NotImplementedError

    def from_tokens(self, tokens: Iterator[str]) -> Any:
        """The value that `tokens` wrote; raises ValueError or StopIteration for anything else."""
        raise NotImplementedError

    def listed(self, value: Any) -> Any:
        """The value with lists for lists and arrays, as JSON can hold it."""
        return value

    def argument(self, value: Any) -> Any:
        """The value as a submission receives it."""
        return value

    def literal(self, value: Any) -> str:
        """The value as it is written in Python."""
        return repr(value)

    def simpler(self, value: Any) -> Iterator[Any]:
        """Values of the same shape or a smaller one that say less: numbers are left as they are."""
        return iter(())

    def simple(self, draw: Draws, number: Callable[[bool], Number], *, positive: bool) -> Any:
        """A simple value: `number(positive)` gives its numbers, `positive` says that none may be negative."""
        raise NotImplementedError

    def round(self, value: Any) -> Any:
        """What the expression `rounded` makes of a value."""
        return value

    def aliases(self) -> Mapping[str, str]:
        """The names that `annotation` uses beside Python's own, with what they stand for."""
        return {}
