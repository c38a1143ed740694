"""Lengths as a person reads them, and the round ones that scale bars have."""

from __future__ import annotations

from fractions import Fraction
from math import floor, log10

from judge.exact import Surd


def short(value: Fraction | Surd, digits: int = 2) -> str:
    """A number in so many digits: `3.2e-9`, `0.25`, `12`, `1e100`."""
    text = Surd.of(value).decimal(digits)
    mantissa, _, power = text.partition("e")
    if not power:
        whole = text.partition(".")[0].lstrip("-")
        if len(whole) <= 5:
            return _thinned(text)
        sign = "-" if text.startswith("-") else ""
        mantissa, power = f"{sign}{whole[0]}.{whole[1:digits]}", str(len(whole) - 1)
    return f"{_thinned(mantissa)}e{int(power)}"


def _thinned(text: str) -> str:
    return text.rstrip("0").rstrip(".") if "." in text else text


def round_below(value: Fraction) -> Fraction:
    """The greatest of 1, 2, 5 times a power of ten that is <= value > 0."""
    near = floor(log10(value.numerator) - log10(value.denominator))
    tens = [Fraction(10) ** power for power in (near - 1, near, near + 1)]
    return max(digit * ten for ten in tens for digit in (1, 2, 5) if digit * ten <= value)
