"""Exact answers, what a problem's `solve` returns, and the doubles that a tolerance accepts around one.

An exact answer is a tree of None, ints, words (str), tuples for fixed parts, and lists or tuples for
elements. Its leaves and wrappers:

    Real(x, unit)      a number x, and the size that a tolerance's `extent` counts in
    AnyOf(answers)     any of these
    Judged(why_not)    whatever a function of the problem accepts
    Called(method, answer, call)
                       what one of several calls in a row answers; the engine's own
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from decimal import Decimal
from fractions import Fraction
from math import inf, isinf, nextafter, ulp
from sys import float_info
from typing import TYPE_CHECKING, Any

from msgspec import Struct
from msgspec.structs import replace

from judge.errors import ProblemError
from judge.values.wire import Given, Written, exactly, near

if TYPE_CHECKING:
    from judge.exact import Surd

Exact = Any  # such a tree
Bounds = tuple[float, float, float]  # the least and the greatest double accepted, and the nearest to x
Errors = tuple[float, float | None, float | None]  # of a number: absolute, relative, in ulps
Target = Any  # what answers are held against, made of an exact one (judge.values.check)
_LARGEST = float_info.max


class Real(Struct, frozen=True):
    """An exact real number; `unit` >= 0 is in the units of x.

    Only a problem whose tolerance has no `extent` may have an irrational unit.
    """

    x: Surd | Fraction | int
    unit: Surd | Fraction | int = 0


class AnyOf(Struct, frozen=True):
    """Any of these answers is right; the first of them is the one that is shown."""

    answers: Sequence[Exact]


class Judged(Struct, frozen=True):
    """Any answer of the type that the problem itself accepts, such as one of very many good ones.

    `why_not(value, group)` says in a sentence why it does not accept a value, or None; it raises nothing for
    one. The value is plain: ints, floats, Fractions, words, tuples for fixed parts and lists; a program's
    decimal is the double next to it. `group` is the name of the test group that the
    case is in, empty where it is in none. `sample` is an exact answer that is accepted, and `group` here is
    filled in by who judges.
    """

    why_not: Callable[[Any, str], str | None]
    sample: Exact
    group: str = ""


class Tolerance(Struct, frozen=True, forbid_unknown_fields=True):
    """How far a number may be from the exact one x, exactly: max(extent·unit, relative·|x|) + ulps·ulp(x).

    `unit` belongs to the number and is given with it (`Real`): the size in which `extent` counts. Where x is
    exactly 0 the bound is max(extent, zero)·unit + ulps·ulp(0).
    """

    extent: Fraction = Fraction(0)
    relative: Fraction = Fraction(0)
    zero: Fraction = Fraction(0)
    ulps: Fraction = Fraction(0)


class Words(Struct, frozen=True, forbid_unknown_fields=True):
    """A problem's own words for its answers, the table `[words]` of problem.toml; all of them optional."""

    answer: str = ""  # what the number is called, such as "t"; else "the answer"
    meant: str = ""  # what a line of output holds, such as "0, 1, 2 or none"
    missing: str = ""  # why None is wrong where there is an answer
    negative: str = ""  # why a number below 0 is, where the right one is not below
    order: str = ""  # in which order the elements of a list come
    parts: str = ""  # what those of a tuple are called, such as "a, b, c"
    unit: str = ""  # what a tolerance's `extent` and `zero` count in, such as "the size of the figure"


NO_WORDS = Words()


class Called(Struct, frozen=True):
    """The exact answer to a call: the place of its method, and the call."""

    method: int
    answer: Exact
    call: tuple[Any, ...]


def within(exact: Exact, group: str) -> Exact:
    """The exact answer to a case of that test group."""
    return replace(exact, group=group) if isinstance(exact, Judged) else exact


def vector(coordinates: Sequence[Surd | Fraction | int], unit: Surd | Fraction | int = 0) -> tuple[Real, ...]:
    """A point or a vector of these exact coordinates, all with one unit."""
    return tuple(Real(x, unit) for x in coordinates)


def accepted_doubles(real: Real, tolerance: Tolerance) -> Bounds:
    """The doubles of an exact number, all of them finite.

    An interval beyond the largest double is the empty one from the largest double to its negative. Raises
    ProblemError as `exact_ends` does.
    """
    from judge.exact import Surd

    low, high = exact_ends(real, tolerance)
    lo, hi, nearest = low.round_up(), high.round_down(), float(Surd.of(real.x))
    if lo == inf or hi == -inf:
        lo, hi = _LARGEST, -_LARGEST
    return lo, hi, nearest if not isinf(nearest) else _LARGEST if nearest > 0 else -_LARGEST


def exact_ends(real: Real, tolerance: Tolerance) -> tuple[Surd, Surd]:
    """The ends of what is accepted, exactly.

    Raises ProblemError where an `extent` is asked of an irrational unit: the sum of two different roots is no
    Surd, and no problem needs it.
    """
    from judge.exact import Surd

    x, unit = Surd.of(real.x), Surd.of(real.unit)
    slack = tolerance.ulps * Fraction(2) ** x.ulp_exponent() if tolerance.ulps else 0
    side = x.sign()
    if side == 0:
        reach = unit * max(tolerance.extent, tolerance.zero) + slack
        return -reach, reach
    if tolerance.extent and unit.q:
        raise ProblemError(
            "the tolerance extent needs an exact answer with a rational unit",
            remedy="give such a unit, or the tolerance as relative, zero and ulps",
        )
    wide, share = tolerance.extent * Fraction(unit.p, unit.s), side * tolerance.relative
    if x * share > wide:
        return x * (1 - share) - slack, x * (1 + share) + slack
    return x - (wide + slack), x + (wide + slack)


# -- a number against those doubles ------------------------------------------------------------------------


def accepts(given: Given, bounds: Bounds, leaf: Callable[[], tuple[Real, Tolerance]]) -> bool:
    """Whether it is accepted, exactly; `leaf` is asked only where doubles do not decide."""
    lo, hi, _ = bounds
    if isinstance(given, float):
        return lo <= given <= hi
    rounded = near(given)  # which lies on the same side of a double, unless it is that double
    if lo < rounded < hi:
        return True
    beyond = lo == _LARGEST and hi == -_LARGEST  # an interval of which rounded ends say nothing
    if not beyond and not nextafter(lo, -inf) <= rounded <= nextafter(hi, inf):
        return False
    exact = exactly(given)
    if lo <= exact <= hi:  # Python compares Fractions with floats exactly
        return True
    low, high = exact_ends(*leaf())
    return low <= exact <= high


def errors(given: Given, nearest: float) -> Errors:
    """The absolute, relative and ulp error of any number beside the nearest double; None for 0."""
    away = abs(exactly(given) - Fraction(nearest))
    if nearest == 0:
        return near(away), None, None
    return near(away), near(away / abs(Fraction(nearest))), near(away / Fraction(ulp(nearest)))


_USUAL = 6  # digits that C and C++ print by default; streams leave out zeros at the end
_SURE = 15  # significant digits that a double always keeps, so that people print so many
_ENOUGH = 17  # significant digits that tell any double from all others
_LEAST = 4  # digits that are no coincidence
_HALF = Fraction(1, 2) + Fraction(1, 10**6)  # of the last digit's place: what was rounded is itself a double


_CUT = "printed with"


def is_cut(message: str) -> bool:
    """Whether the message of a wrong answer says that it was printed with too few digits."""
    return f"; {_CUT} " in message


def cut_digits(given: Given, nearest: float) -> str:
    """How a decimal was printed with too few digits, and the remedy, where that alone makes it wrong.

    A decimal that is what the exact number rounds to was computed rightly, as far as it can be seen.
    """
    if not isinstance(given, Written):
        return ""
    _, written, power = Decimal(given.text).as_tuple()
    significant, last = len(written), Fraction(10) ** int(power)  # the place of the last digit
    if significant >= _ENOUGH:
        return ""
    away = abs(Fraction(nearest) - exactly(given)) / last
    fixed = power == -_USUAL != -significant and significant < _SURE
    if fixed and "e" not in given.text.lower() and away <= _HALF:
        return f"{_CUT} {_USUAL} decimals: print {_ENOUGH} significant digits"
    usual = (each for each in (_SURE, _USUAL) if each > significant)  # zeros at the end may be left out
    for digits in (*usual, significant) if significant >= _LEAST else ():
        if away * 10 ** (digits - significant) <= _HALF:
            return f"{_CUT} {digits} significant digits: print {_ENOUGH}"
    return ""
