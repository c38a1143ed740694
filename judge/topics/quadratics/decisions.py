"""What the roots of a·t² + 2·b·t + c turn on, and where they lose their digits.

discriminant  |Δ| in parts of the larger of b² and |a·c|, for Δ = b² − a·c: two roots or none
cancellation  the lesser root in parts of the greater, b being above 0 or below
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import isqrt

from judge.problem import Case
from judge.problem.topic import Decision

_FINEST = 1e-30  # of products of two doubles
_SMALLEST = 1e-16  # beside the greater root, the lesser one is then all rounding


def _discriminants(case: Case) -> Iterator[tuple[str, float]]:
    a, b, c = map(Fraction, case)
    delta = b * b - a * c
    if a and delta:
        yield ("two" if delta > 0 else "none"), float(abs(delta) / max(b * b, abs(a * c)))


def _cancellations(case: Case) -> Iterator[tuple[str, float]]:
    a, b, c = map(Fraction, case)
    delta = b * b - a * c
    if a and b and delta > 0:
        share = abs(a * c) / b**2  # (|b| − √Δ)/(|b| + √Δ) of it, whatever the signs
        root = Fraction(isqrt(int(delta / b**2 * (1 << 128))), 1 << 64)
        yield ("b above 0" if b > 0 else "b below 0"), float(share / (1 + root) ** 2)


DECISIONS = (
    Decision("discriminant", ("two", "none"), _discriminants, least=_FINEST),
    Decision("cancellation", ("b above 0", "b below 0"), _cancellations, least=_SMALLEST),
)
