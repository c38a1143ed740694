"""Where a group's draw gets its choices from.

A draw takes small numbers and never sees where they come from, so one description serves the seeded data and
the search for a failing case (judge.diagnose.search). Draw the parameters of a construction, not raw
coordinates.

Every choice comes down to an integer that a pick gives, whatever the source.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from random import Random
from typing import Never, TypeVar

T = TypeVar("T")
Pick = Callable[[int, int], int]  # an integer from the first to the second, both included

_BLOCK_BITS = 512  # of one SHA-512 digest


class Rejected(Exception):  # noqa: N818 - a signal, not a fault
    """These choices make no case; the draw is asked again with others."""


class Draw:
    """A source of choices: all of them come from `integer`."""

    __slots__ = ("_pick",)

    def __init__(self, pick: Pick) -> None:
        self._pick = pick

    def integer(self, low: int, high: int) -> int:
        """An int from low to high, both included; ValueError if there is none."""
        if low > high:
            raise ValueError(f"no integer from {low} to {high}")
        return self._pick(low, high)

    def choice(self, options: Sequence[T]) -> T:
        """One of `options`; ValueError if there is none."""
        if not options:
            raise ValueError("nothing to choose from")
        return options[self.integer(0, len(options) - 1)]

    def sign(self) -> int:
        """One or minus one."""
        return 1 + 2 * self.integer(-1, 0)  # 0, the simplest choice, is plus

    def boolean(self) -> bool:
        """False or True."""
        return bool(self.integer(0, 1))

    def reject(self) -> Never:
        """Give these choices up: nothing can be built from them."""
        raise Rejected


def seeded(text: str) -> Pick:
    """Choices that depend on a seed text alone, all equally likely.

    The bits are SHA-512 of the text and a block number, not those of `random`: pinned data must be the same
    on every version of Python.
    """
    start = hashlib.sha512(text.encode())
    block = bits = left = 0

    def picked(low: int, high: int) -> int:
        nonlocal block, bits, left
        span = high - low
        width = span.bit_length()
        while True:  # each round succeeds with a chance above one half
            while left < width:
                digest = start.copy()
                digest.update(b"/%d" % block)
                bits |= int.from_bytes(digest.digest(), "big") << left
                block, left = block + 1, left + _BLOCK_BITS
            offset = bits & ((1 << width) - 1)
            bits, left = bits >> width, left - width
            if offset <= span:
                return low + offset

    return picked


def quick(text: str) -> Pick:
    """Others of a `random.Random`, several times as quick: for data that nobody pins."""
    take = Random(text).getrandbits

    def picked(low: int, high: int) -> int:
        span = high - low
        width = span.bit_length()
        while (offset := take(width)) > span:
            pass
        return low + offset

    return picked
