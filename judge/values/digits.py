"""Whether a wrong decimal is the right number, printed with too few digits.

C++ streams print 6 significant digits and C's %f 6 decimals unless they are told otherwise. A decimal that is
what the exact number rounds to was computed rightly, as far as it can be seen.
"""

from __future__ import annotations

import re
from fractions import Fraction

from judge.values.decode import Given, Written

_USUAL = 6  # digits that C and C++ print by default; streams leave out zeros at the end
_ENOUGH = 17  # significant digits that tell any double from all others
_LEAST = 4  # digits that are no coincidence
_HALF = Fraction(1, 2) + Fraction(1, 10**6)  # of the last digit's place: what was rounded is itself a double

_PARTS = re.compile(r"[+-]?([0-9]*)(?:\.([0-9]+))?(?:[eE]([+-]?[0-9]+))?", re.ASCII)


def cut_short(given: Given, x: Fraction) -> str:
    """How the digits of a decimal were cut, with the remedy, where that alone keeps it from being `x`."""
    found = _PARTS.fullmatch(given.text) if isinstance(given, Written) else None
    if found is None or not isinstance(given, Written):
        return ""
    places, power = found[2] or "", int(found[3] or 0)
    significant = len((found[1] + places).lstrip("0"))
    last = power - len(places)  # the place of the last digit, as a power of ten
    if significant >= _ENOUGH:
        return ""
    away = abs(x - given.exact())
    if found[3] is None and len(places) == _USUAL != significant and _within(away, last):
        return f"printed with {_USUAL} decimals: print {_ENOUGH} significant digits"
    if significant < _LEAST:
        return ""
    for digits in sorted({significant, max(significant, _USUAL)}, reverse=True):
        if _within(away, last - (digits - significant)):
            return f"printed with {digits} significant digits: print {_ENOUGH}"
    return ""


def _within(away: Fraction, place: int) -> bool:
    return away <= _HALF * Fraction(10) ** place
