"""Deciding one number against the five doubles of its target, and saying how far off it is.

A target is (lo, hi, nearest, residual, ulp): a double y is accepted where lo <= y <= hi; `nearest` is the
correctly rounded double of the exact x, `ulp` is ulp(x) and residual = (x − nearest)/ulp(x).
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import inf, nextafter
from sys import float_info
from typing import TYPE_CHECKING

from judge.values.decode import Given, Written, near
from judge.values.tolerance import Tolerance

if TYPE_CHECKING:
    from judge.values.tree import Real

Bounds = tuple[float, float, float, float, float]
LeafOf = Callable[[], "tuple[Real, Tolerance]"]
Errors = tuple[float, float | None, float | None]  # absolute, relative, in ulps


def accepts(given: Given, bounds: Bounds, leaf: LeafOf) -> bool:
    """Whether L <= given <= U, exactly."""
    lo, hi = bounds[0], bounds[1]
    if isinstance(given, Written):
        # A decimal lies on the same side of a double as its own rounding, unless it rounds to that double.
        if lo < given.approx < hi:
            return True
        if given.approx < nextafter(lo, -inf) or given.approx > nextafter(hi, inf):
            return _beyond_doubles(bounds) and _exactly(given.exact(), leaf)
        given = given.exact()
    if lo <= given <= hi:  # Python compares ints and Fractions with floats exactly
        return True
    if isinstance(given, float):
        return False
    between = nextafter(lo, -inf) < given < nextafter(hi, inf)
    return (between or _beyond_doubles(bounds)) and _exactly(given, leaf)


def _beyond_doubles(bounds: Bounds) -> bool:
    """Whether the interval lies beyond the largest double, where its rounded ends say nothing."""
    return bounds[0] == float_info.max and bounds[1] == -float_info.max


def _exactly(given: int | float | Fraction, leaf: LeafOf) -> bool:
    from judge.exact import Surd  # exact numbers are needed about once in 10**15 answers
    from judge.values.interval import exact_ends

    real, tolerance = leaf()
    low, high = exact_ends(Surd.of(real.x), tolerance, Surd.of(real.unit))
    return low <= given <= high


def ulps_off(given: Given, bounds: Bounds) -> float:
    """|given − x|/ulp(x) of an accepted number, taken as its double; 0 where x is 0, which has no scale."""
    _, _, nearest, residual, unit = bounds
    return abs((double(given) - nearest) / unit - residual) if nearest else 0.0


def exactly(bounds: Bounds) -> Fraction:
    """The exact number, to the last bits of `residual`."""
    _, _, nearest, residual, unit = map(Fraction, bounds)
    return nearest + residual * unit


def errors(given: Given, bounds: Bounds) -> Errors:
    """The absolute, relative and ulp error of any number, as doubles; the last two None for x = 0."""
    _, _, nearest, _, unit = map(Fraction, bounds)
    x = exactly(bounds)
    away = abs((given.exact() if isinstance(given, Written) else Fraction(given)) - x)
    if nearest == 0:
        return near(away), None, None
    return near(away), near(away / abs(x)), near(away / unit)


def double(given: Given) -> float:
    """The double next to a number."""
    return given.approx if isinstance(given, Written) else near(given)


def off(where: str, found: Errors) -> str:
    """The sentence that says how far off a number is."""
    absolute, relative, ulps = found
    share = "" if relative is None or ulps is None else f", relative error {relative:.2g} ({ulps:.3g} ulps)"
    return f"{where} is off by {absolute:.2g}{share}"
