"""Numbers and arguments as a person reads them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from typing import Any

from judge.problem.model import FULL_SCORE

_ITEMS = 40  # of a list that are shown


def arguments(values: Mapping[str, Any]) -> str:
    """The arguments of a call by name, `cx=0, A=(3, 4)`; numbers in full, as `repr` writes them."""
    return ", ".join(f"{name}={argument(value)}" for name, value in values.items())


def argument(value: Any) -> str:
    """One argument as Python writes it, its lists cut where they are long."""
    if isinstance(value, list):
        parts = [argument(part) for part in value[:_ITEMS]]
        more = f", …] ({len(value):,} items)" if len(value) > _ITEMS else "]"
        return f"[{', '.join(parts)}{more}"
    if isinstance(value, tuple):
        return f"({', '.join(argument(part) for part in value)})"
    return repr(value)


def with_points(values: Mapping[str, Any]) -> dict[str, Any]:
    """Arguments that JSON has kept: two or three numbers in a list were a tuple, most likely a point."""
    return {name: _with_points(value) for name, value in values.items()}


def _with_points(value: Any) -> Any:
    if not isinstance(value, list):
        return value
    if 2 <= len(value) <= 3 and all(isinstance(each, int | float) for each in value):
        return tuple(value)
    return [_with_points(each) for each in value]


def counted(number: int, noun: str) -> str:
    """`1 case`, `1,240 cases`."""
    return f"{number:,} {noun}" if number == 1 else f"{number:,} {noun}s"


def score_text(score: int, *, accepted: bool) -> str:
    """The points of a run, or that with all of them it fails groups that are worth none."""
    return str(score) if accepted or score < FULL_SCORE else "extra fails"


def seconds(duration: float) -> str:
    """A duration in the unit that suits it."""
    if duration < 0.0095:
        return f"{duration * 1e3:.1f} ms"
    return f"{duration * 1e3:.0f} ms" if duration < 0.9995 else f"{duration:.2f} s"


def times(factor: float) -> str:
    """A multiple with as many digits as it deserves: `0.97`, `1.3`, `12`, `1,117`."""
    if factor >= 9.95:
        return f"{factor:,.0f}"
    return f"{factor:.1f}" if factor >= 0.995 else f"{factor:.2f}"


def size(amount: int) -> str:
    """A number of bytes in megabytes (of 2**20), as limits are given."""
    return f"{amount / 2**20:,.0f} MB"


def bound(value: Fraction) -> str:
    """A bound or a width, shortest of its exact forms: `1000`, `2^30`, `-10^100`, `1e-12`, `1/3`."""
    if value.denominator == 1:
        return _whole(value.numerator)
    short = re.sub("e-0+", "e-", f"{float(value):g}")
    return short if Fraction(short) == value else str(value)


def _whole(value: int) -> str:
    sign, magnitude = ("-" if value < 0 else ""), abs(value)
    if magnitude < 100_000:
        return str(value)
    if magnitude & (magnitude - 1) == 0:
        return f"{sign}2^{magnitude.bit_length() - 1}"
    number = Decimal(magnitude)  # whose text, unlike an int's, may have any length
    if magnitude == 10 ** number.adjusted():
        return f"{sign}10^{number.adjusted()}"
    return f"{sign}{number:,}" if number.adjusted() < 15 else f"{sign}{number}"
