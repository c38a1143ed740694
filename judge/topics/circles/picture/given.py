"""The numbers in a submission's answer, JSON of any shape whatever: what of it can be drawn."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import islice

from judge.values.decode import Fault, Raw, Written, number

_MOST = 4  # points that are drawn
_DEPTH = 3  # levels of lists that are looked into


@dataclass(frozen=True, slots=True)
class Drawable:
    """The numbers in an answer, in the caller's units: its points, its one number, or the three it is."""

    points: tuple[tuple[Fraction, Fraction], ...] = ()
    number: Fraction | None = None
    triple: tuple[Fraction, Fraction, Fraction] | None = None


def read_given(raw: Raw) -> Drawable:
    """What `raw` holds: every two numbers in a list of their own are a point."""
    if type(raw) in (list, tuple):
        return Drawable(tuple(islice(_points(raw, _DEPTH), _MOST)), triple=_triple(raw))
    return Drawable(number=read_number(raw))


def _points(items: Raw, depth: int) -> Iterator[tuple[Fraction, Fraction]]:
    if len(items) == 2:
        x, y = map(read_number, items)
        if x is not None and y is not None:
            yield x, y
            return
    if depth:
        for item in items[:_MOST]:
            if type(item) in (list, tuple):
                yield from _points(item, depth - 1)


def _triple(items: Raw) -> tuple[Fraction, Fraction, Fraction] | None:
    if len(items) != 3:
        return None
    x, y, z = map(read_number, items)
    return None if x is None or y is None or z is None else (x, y, z)


def read_number(raw: Raw) -> Fraction | None:
    """A number as it was given, exactly; None for anything else."""
    read = number(raw)
    if isinstance(read, Fault):
        return None
    return read.exact() if isinstance(read, Written) else Fraction(read)
