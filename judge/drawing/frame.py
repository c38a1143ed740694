"""From exact numbers of any size to floats near 1: relative to a panel's centre before they are rounded."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import hypot, sqrt

from judge.drawing.shapes import Dot
from judge.exact import Surd

ExactNumber = Fraction | Surd

FAR = 1e6  # whatever is further away than this, in panels, is drawn as if it were there


def near(value: ExactNumber) -> float:
    """The double next to `value`, at most `FAR` in magnitude."""
    try:
        double = float(value)
    except OverflowError:
        return FAR if value > 0 else -FAR
    return max(-FAR, min(FAR, double))


def over_root(value: Fraction, square: int) -> float:
    """value/√square."""
    size = sqrt(near(value * value / square))
    return size if value >= 0 else -size


def length(x: ExactNumber, y: ExactNumber) -> Fraction:
    """√(x² + y²) to three digits, as a fraction: for scales and for words."""
    return root(rounded(x) ** 2 + rounded(y) ** 2)


def root(square: Fraction) -> Fraction:
    """√square to three digits."""
    return rounded(Surd(0, 1, square.numerator * square.denominator, square.denominator))


def rounded(value: ExactNumber) -> Fraction:
    """`value` to three digits."""
    return Fraction(Surd.of(value).decimal(3))


def direction(x: Fraction | int, y: Fraction | int) -> Dot:
    """(x, y) made one long; (1, 0) for no direction."""
    across, up = Fraction(x), Fraction(y)
    most = max(abs(across), abs(up))
    if not most:
        return 1.0, 0.0
    u, v = float(across / most), float(up / most)
    size = hypot(u, v)
    return u / size, v / size


@dataclass(frozen=True, slots=True)
class Frame:
    """A square window: its centre and half its side, in the units of what is drawn."""

    x: Fraction
    y: Fraction
    unit: Fraction

    def place(self, x: ExactNumber | int, y: ExactNumber | int) -> Dot:
        """An exact point in the panel."""
        return near((x - self.x) / self.unit), near((y - self.y) / self.unit)
