"""Lists as the values of parameters: tuples of items, written with their length first."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from typing import Any

from judge.values.parameters import Draws, Number, ParameterValues


class ListValues(ParameterValues):
    """The half of `judge.values.lists.ListType` that deals with the values of parameters."""

    item: ParameterValues
    low: int
    high: int | None
    several: str
    most: int

    def bounds(self) -> str:
        """How many items there may be, in words."""
        if self.high is None:
            return f"at least {self.low}"
        if self.low == self.high:
            return str(self.low)
        return f"{self.low} to {self.high}" if self.low else f"at most {self.high}"

    def fault(self, name: str, value: Any) -> str | None:
        """A tuple of as many items as it may have, each as it should be."""
        if type(value) is not tuple:
            return f"{name} must be a tuple of {self.several}, not {value!r}"
        if len(value) < self.low or (self.high is not None and len(value) > self.high):
            return f"{name} has {len(value)} {self.several} where {self.bounds()} are meant"
        return next((wrong for each in value if (wrong := self.item.fault(name, each))), None)

    def outside(self, value: Any, low: Fraction | int, high: Fraction | int) -> tuple[Any, Any, Any] | None:
        """The first item's that is outside."""
        for each in value:
            found = self.item.outside(each, low, high)
            if found is not None:
                return found
        return None

    def reals(self, value: Any) -> Iterator[Number]:
        """Those of the items."""
        for each in value:
            yield from self.item.reals(each)

    def tokens(self, value: Any) -> Iterator[str]:
        """The length and the items' tokens."""
        yield str(len(value))
        for each in value:
            yield from self.item.tokens(each)

    def from_tokens(self, tokens: Iterator[str]) -> Any:
        """What `tokens` wrote."""
        count = int(next(tokens))
        if not 0 <= count <= (self.most if self.high is None else self.high):
            raise ValueError("no such length")
        return tuple([self.item.from_tokens(tokens) for _ in range(count)])

    def listed(self, value: Any) -> Any:
        """A list of the items' values."""
        return [self.item.listed(each) for each in value]

    def argument(self, value: Any) -> Any:
        """A list of the items' arguments."""
        if self.item.is_plain:
            return list(value)
        return [self.item.argument(each) for each in value]

    def literal(self, value: Any) -> str:
        """A list."""
        return f"[{', '.join(map(self.item.literal, value))}]"

    def simpler(self, value: Any) -> Iterator[Any]:
        """Fewer items: half of them, all but one; then one item simpler."""
        count = len(value)
        size = count // 2
        while size:
            if count - size >= self.low:
                for start in range(0, count, size):
                    yield (*value[:start], *value[start + size :])
            size //= 2
        for at, each in enumerate(value):
            for other in self.item.simpler(each):
                yield (*value[:at], other, *value[at + 1 :])

    def round(self, value: Any) -> Any:
        """The items rounded."""
        return [self.item.round(each) for each in value]

    def simple(self, draw: Draws, number: Callable[[bool], Number], *, positive: bool) -> Any:
        """As few items as may be, up to three more."""
        high = self.low + 3 if self.high is None else min(self.high, self.low + 3)
        return tuple(
            [self.item.simple(draw, number, positive=positive) for _ in range(draw.integer(self.low, high))]
        )

    def aliases(self) -> Mapping[str, str]:
        """Those of the items."""
        return self.item.aliases()
