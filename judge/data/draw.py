"""Where a builder gets its choices from.

A builder draws small numbers and never sees where they come from, so one description serves the seeded data
and the search for a failing case (judge.diagnose.search). Draw the parameters of a construction, not
raw coordinates.

Every choice comes down to an integer, whatever the source: the number itself, an option's place, 0 or 1 for a
sign (plus, minus) and for False or True. Those integers, in order, are a case's choices.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from random import Random
from typing import Never, TypeVar

from judge.errors import ProblemError

T = TypeVar("T")

_BLOCK_BITS = 512  # of one SHA-512 digest


class Rejected(Exception):  # noqa: N818 - a signal, not a fault
    """These choices make no case; the builder is asked again with others."""


class BuilderError(ProblemError):
    """A builder made something else than it says: a mistake in it or in its parameters."""


def require(condition: bool, what: str) -> None:
    """Raise BuilderError unless `condition` holds; `what` says what should have been true."""
    if not condition:
        raise BuilderError(f"its check fails: {what}", remedy="correct what it draws")


class Draw:
    """A source of choices: all of them come from `integer`."""

    __slots__ = ()

    def integer(self, low: int, high: int) -> int:
        """An int from low to high, both included; ValueError if there is none."""
        raise NotImplementedError

    def choice(self, options: Sequence[T]) -> T:
        """One of `options`; ValueError if there is none."""
        if not options:
            raise ValueError("nothing to choose from")
        return options[self.integer(0, len(options) - 1)]

    def sign(self) -> int:
        """One or minus one."""
        return -1 if self.integer(0, 1) else 1

    def boolean(self) -> bool:
        """False or True."""
        return bool(self.integer(0, 1))

    def reject(self) -> Never:
        """Give these choices up: nothing can be built from them."""
        raise Rejected


class SeededDraw(Draw):
    """Choices that depend on a seed text alone, all equally likely.

    The bits are SHA-512 of the seed and a block number, not those of `random`: pinned data must be the same
    on every version of Python.
    """

    __slots__ = ("_bits", "_block", "_left", "_seed")

    def __init__(self, seed: str) -> None:
        self._seed = hashlib.sha512(seed.encode())
        self._block = 0
        self._bits = 0
        self._left = 0

    def integer(self, low: int, high: int) -> int:
        """An int from low to high, both included; ValueError if there is none."""
        return _from_bits(self._take, low, high)

    def sign(self) -> int:
        """Minus one or one."""
        return 1 if self._take(1) else -1

    def _take(self, width: int) -> int:
        """The next `width` bits."""
        while self._left < width:
            digest = self._seed.copy()
            digest.update(b"/%d" % self._block)
            self._block += 1
            self._bits |= int.from_bytes(digest.digest(), "big") << self._left
            self._left += _BLOCK_BITS
        taken = self._bits & ((1 << width) - 1)
        self._bits >>= width
        self._left -= width
        return taken


class QuickDraw(Draw):
    """Choices of a `random.Random`, several times as quick: for data that nobody pins."""

    __slots__ = ("_bits",)

    def __init__(self, seed: str) -> None:
        self._bits = Random(seed).getrandbits

    def integer(self, low: int, high: int) -> int:
        """An int from low to high, both included; ValueError if there is none."""
        return _from_bits(self._bits, low, high)


def _from_bits(take: Callable[[int], int], low: int, high: int) -> int:
    span = high - low
    if span < 0:
        raise ValueError(f"no integer from {low} to {high}")
    width = span.bit_length()
    offset = take(width)
    while offset > span:  # each round succeeds with a chance above one half
        offset = take(width)
    return low + offset


class RecordedDraw(Draw):
    """Another draw's choices, remembered."""

    __slots__ = ("_source", "choices")

    def __init__(self, source: Draw) -> None:
        self._source = source
        self.choices: list[int] = []

    def integer(self, low: int, high: int) -> int:
        """As the source has it."""
        self.choices.append(self._source.integer(low, high))
        return self.choices[-1]

    def sign(self) -> int:
        """As the source has it."""
        sign = self._source.sign()
        self.choices.append(int(sign < 0))
        return sign
