"""Python's numbers taken as the exact rationals they are."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from math import isfinite

Rational = int | float | Fraction | Decimal


def ratio(value: object) -> tuple[int, int]:
    """`value` (int, float, Fraction or Decimal) as numerator and denominator > 0.

    Raises ValueError for nan and infinities, TypeError for a bool or anything else.
    """
    if isinstance(value, bool) or not isinstance(value, (int, float, Fraction, Decimal)):
        raise TypeError(f"{type(value).__name__} is not a number that can be taken exactly")
    if isinstance(value, (float, Decimal)) and not isfinite(value):
        raise ValueError(f"{value} is not a finite number")
    return value.as_integer_ratio()


def integers(*values: int | float) -> tuple[list[int], int]:
    """All `values` over one power of two: value i is result[i] / 2**shift, exactly, shift >= 0 least.

    Every finite double is a dyadic rational, so that a geometric case is integral after scaling.
    Raises ValueError for nan and infinities, TypeError for a bool or anything but int and float.
    """
    for value in values:
        if type(value) is not int:
            return _scaled(values)
    return list(values), 0  # type: ignore[arg-type]  # all are ints here


def _scaled(values: tuple[int | float, ...]) -> tuple[list[int], int]:
    ratios = []
    for value in values:
        kind = type(value)
        if kind is not float and kind is not int and (kind is bool or not isinstance(value, (int, float))):
            raise TypeError(f"{kind.__name__} is not an int or a float")
        try:
            ratios.append(value.as_integer_ratio())
        except (ValueError, OverflowError):
            raise ValueError(f"{value} is not a finite number") from None
    bits = max([bottom for _, bottom in ratios]).bit_length()
    return [top << (bits - bottom.bit_length()) for top, bottom in ratios], bits - 1
