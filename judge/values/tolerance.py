"""How far a number may be from the exact one."""

from __future__ import annotations

from fractions import Fraction

from msgspec import Struct


class Tolerance(Struct, frozen=True):
    """How far a number may be from the exact one x, exactly: max(extent·unit, relative·|x|) + ulps·ulp(x).

    `unit` belongs to the number and is given with it (`judge.values.tree.Real`): the size in which `extent`
    counts. Where x is exactly 0 the bound is max(extent, zero)·unit + ulps·ulp(0).
    """

    extent: Fraction = Fraction(0)
    relative: Fraction = Fraction(0)
    zero: Fraction = Fraction(0)
    ulps: Fraction = Fraction(0)
