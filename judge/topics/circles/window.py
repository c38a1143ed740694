"""Whether a case is off by so much and no more: a range of shares of the extent, held against it in integers.

A window is open to one side of what a problem decides: a line that crosses the circle ("hit") or misses it
("miss"), a root before or beyond a point of the line, a point "inside" or "outside" the circle.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from judge.topics.circles.bands import Width


@dataclass(frozen=True, slots=True)
class Window:
    """Shares of the extent from `low` to `high`, both included."""

    low: Width
    high: Width

    @classmethod
    def of(cls, low: Fraction, high: Fraction) -> Window:
        """The window of these shares."""
        return cls(Width.of(low), Width.of(high))
