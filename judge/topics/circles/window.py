"""Whether a case is off by so much and no more: a range of shares of the extent, held against it in integers.

A window is open to one side of what a problem decides: a line that crosses the circle ("hit") or misses it
("miss"), a root before or beyond a point of the line, a point "inside" or "outside" the circle.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from judge.topics.circles.bands import Width, beyond
from judge.topics.circles.line import CircleLine


@dataclass(frozen=True, slots=True)
class Window:
    """Shares of the extent from `low` to `high`, both included."""

    low: Width
    high: Width

    @classmethod
    def of(cls, low: Fraction, high: Fraction) -> Window:
        """The window of these shares."""
        return cls(Width.of(low), Width.of(high))

    def has_tangent(self, line: CircleLine, side: str) -> bool:
        """Whether |d − r| is in the window, the line being a "hit" or a "miss"."""
        here = line.delta > 0 if side == "hit" else line.delta < 0
        return here and self.high.touches(line) and not self.low.nearly_touches(line)

    def has_root(self, line: CircleLine, t: int, sign: int) -> bool:
        """Whether some root is in the window beyond (sign 1) or before (sign −1) the point of t = 0 or 1."""
        if line.delta <= 0 or line.a == 0:
            return False
        return any(
            beyond(line, which, t) == sign
            and self.high.within(line, which, t)
            and not self.low.within(line, which, t, strictly=True)
            for which in (-1, 1)
        )

    def has_share(self, square: int, radius: int, extent: int) -> bool:
        """Whether |√square − radius| is in the window, in parts of the extent."""
        return self.high.close(square, radius, extent) and not self.low.close(
            square, radius, extent, strictly=True
        )

    def has_point(self, line: CircleLine, side: str) -> bool:
        """Whether ||A − C| − r| is in the window, A being "inside" or "outside"."""
        square = (line.ax - line.cx) ** 2 + (line.ay - line.cy) ** 2
        here = square < line.r**2 if side == "inside" else square > line.r**2
        return here and self.high.starts_on_circle(line) and not self.low.starts_near_circle(line)
