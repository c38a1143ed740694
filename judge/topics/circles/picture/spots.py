"""Points of a picture, and the lengths that they are drawn from."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from judge.drawing.frame import ExactNumber
from judge.exact import Surd

_DIGITS = 30  # of a length that a point is drawn from


@dataclass(frozen=True, slots=True)
class Spot:
    """An exact point in units of the scene, and its label."""

    x: ExactNumber
    y: ExactNumber
    text: str


def digits(value: ExactNumber) -> Fraction:
    """A number to many digits."""
    return Fraction(Surd.of(value).decimal(_DIGITS))


def root(square: Fraction | int) -> Fraction:
    """The root of a positive number, to many digits."""
    square = Fraction(square)
    top, bottom = square.numerator, square.denominator
    return digits(Surd(0, 1, top * bottom, bottom))
