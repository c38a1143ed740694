"""A moment of a motion beside its start, t = 0, and its end, t = 1.

Moments are told apart by the way between them: |t − m|·‖D‖∞, D being the whole motion, in parts of the
extent.
"""

from __future__ import annotations

from fractions import Fraction

from msgspec import Struct

from judge.exact.signs import root_sign
from judge.exact.surd import Surd, make
from judge.topics.circles.bands import Bands

START = make(0, 0, 0, 1)


class Pace(Struct, frozen=True):
    """The extent e of a case, and how far its motion goes along x or y, whichever is more; in one unit."""

    extent: int
    step: int

    def close(self, t: Surd, moment: int, width: Fraction, *, strictly: bool = False) -> bool:
        """Whether |t − moment|·step is <= (or <) width·e."""
        share = width.denominator * self.step
        bound = width.numerator * self.extent * t.s
        p, q = (t.p - moment * t.s) * share, t.q * share
        least = 1 if strictly else 0
        return root_sign(bound - p, -q, t.d) >= least and root_sign(bound + p, q, t.d) >= least

    def within(self, t: Surd, bands: Bands) -> Surd | None:
        """The moment where it is in the time from 0 to 1, exactly 0 where it counts as the start; or None."""
        if self.close(t, 0, bands.snap):
            return START
        if t.sign() < 0 or (t > 1 and not self.close(t, 1, bands.snap)):
            return None
        return t

    def unit(self) -> Surd:
        """The extent in units of t; 0 where nothing moves."""
        return make(self.extent, 0, 0, self.step) if self.step else START
