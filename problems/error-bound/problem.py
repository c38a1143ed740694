"""An enclosure of Δ = r²·a − k² for doubles as they are, no wider than careful doubles make it."""

from __future__ import annotations

from fractions import Fraction

from judge.topics.circles import builders
from judge.topics.circles.recipes import counting, exact_signs, roundings
from judge.topics.circles.seven import SEVEN, discriminant, seven
from judge.values import Enclosure

BUILDERS = builders({"grid": counting.RECIPES["grid"]}, exact_signs.RECIPES, roundings.RECIPES, adapter=seven)
TOPIC = SEVEN


def solve(cx, cy, r, ax, ay, bx, by):
    """Δ, and the width 2⁻⁴⁶·(r²a + M|k|) + 2⁻⁹⁸·M² for M = |dx·fy| + |dy·fx|."""
    terms = discriminant(cx, cy, r, ax, ay, bx, by)
    width = Fraction(terms.reach + terms.whole * abs(terms.k), 1 << 46) + Fraction(terms.whole**2, 1 << 98)
    return Enclosure(terms.delta * terms.unit, width * terms.unit), None
