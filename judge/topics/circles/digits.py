"""Numbers of few digits, for simpler cases."""

from __future__ import annotations

from decimal import Decimal


def few(value: Decimal, digits: int) -> Decimal:
    """The number rounded to so many digits."""
    if not value:
        return value
    return value.quantize(Decimal((0, (1,), value.adjusted() + 1 - digits)))


def plain(value: Decimal, *, floats: bool) -> int | float:
    """The number as an argument: an int where it is whole, unless it is to be a float; 0 is an int always."""
    if value == 0 or (value == value.to_integral_value() and not floats):
        return int(value)
    return float(value)
