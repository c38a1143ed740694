"""Lengths as a person reads them, and the round ones that scale bars have."""

from __future__ import annotations

from fractions import Fraction

from judge.exact import Surd

_ROUND = (Fraction(1), Fraction(2), Fraction(5))


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
    power = _power(value)
    ten = Fraction(10) ** power
    return max(digit * ten for digit in _ROUND if digit * ten <= value)


def _power(value: Fraction) -> int:
    """floor(log10(value))."""
    text = f"{Surd.of(value).decimal(3)}"
    guess = int(text.partition("e")[2]) if "e" in text else len(text.partition(".")[0]) - 1
    if "e" not in text and value < 1:
        guess = -len(text.partition(".")[2]) + len(text.partition(".")[2].lstrip("0")) - 1
    while Fraction(10) ** guess > value:
        guess -= 1
    while Fraction(10) ** (guess + 1) <= value:
        guess += 1
    return guess
