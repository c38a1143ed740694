"""The numbers a tolerance accepts around an exact one: an interval, exactly, and its doubles.

|y − x| <= α accepts L <= y <= U with L = x − α and U = x + α, numbers of the same kind as x. Rounded inward
to doubles once, they decide every double by two comparisons; any other number is compared with L and U.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import copysign, frexp, inf, isinf, isqrt, ldexp, nextafter, ulp
from typing import NamedTuple

from judge.errors import ProblemError
from judge.exact import Surd, root_sign, rounding
from judge.exact.surd import make
from judge.values.tolerance import Tolerance

_ATTEMPTS = 3  # enclosures tried before the general path, each 64 bits finer
_TOTAL_BITS = 128  # of the first enclosure: a double's 53, 30 for a tolerance of 1e-9, and as many to spare
_HUGE = 900  # in bits: numbers so large go the general way, which knows about overflow


class Measure(NamedTuple):
    """What is known of an exact x in doubles: its interval, the nearest one, and how far x is from it."""

    lo: float
    hi: float
    nearest: float
    residual: float  # (x − nearest)/ulp(x)
    ulp: float  # ulp(x), of the exact x


Roots = Callable[[int, int], tuple[int, int]]  # (d, k) -> (j, floor(√d·2**j)) for some j >= k


def shared_roots() -> Roots:
    """A source of fixed-point square roots that remembers the last: one isqrt serves a whole answer."""
    known_d, known_k, known_root = -1, -1, 0

    def root(d: int, k: int) -> tuple[int, int]:
        nonlocal known_d, known_k, known_root
        if d != known_d or k > known_k:
            known_d, known_k, known_root = d, k, isqrt(d << 2 * k)
        return known_k, known_root

    return root


def exact_ends(x: Surd, tolerance: Tolerance, unit: Surd) -> tuple[Surd, Surd]:
    """L and U as `Tolerance` defines them; `unit` >= 0 in the units of x.

    Raises ProblemError where an `extent` is asked of an irrational unit: the sum of two different roots
    is no Surd, and no problem needs it.
    """
    slack_n, slack_d = _slack(x, tolerance)
    side = x.sign()
    if side == 0:
        reach = unit * max(tolerance.extent, tolerance.zero) + Fraction(slack_n, slack_d)
        return -reach, reach
    reach_n, reach_d = _reach(tolerance, unit)
    rel_n, rel_d = tolerance.relative.as_integer_ratio()
    p, q, d, s = x.p, x.q, x.d, x.s
    # Which of the two is the wider, relative·|x| or extent·unit?
    scale = side * rel_n * reach_d
    if root_sign(scale * p - reach_n * rel_d * s, scale * q, d) > 0:
        low_n, high_n = rel_d - side * rel_n, rel_d + side * rel_n
        s *= rel_d
        low, high = (p * low_n, q * low_n), (p * high_n, q * high_n)
    else:
        low, high = (p * reach_d - reach_n * s, q * reach_d), (p * reach_d + reach_n * s, q * reach_d)
        s *= reach_d
    shift = slack_n * s
    bottom = s * slack_d
    return (
        make(low[0] * slack_d - shift, low[1] * slack_d, d, bottom),
        make(high[0] * slack_d + shift, high[1] * slack_d, d, bottom),
    )


def measure(x: Surd, tolerance: Tolerance, unit: Surd, roots: Roots | None = None) -> Measure:
    """Everything a comparison needs of x, all of it finite; raises ProblemError as `exact_ends` does.

    An interval beyond the largest double is the empty one from the largest double to its negative.
    """
    if x.q:
        roots = roots or shared_roots()
        for attempt in range(_ATTEMPTS):
            enclosed = _enclosed(x, tolerance, unit, roots, 64 * attempt)
            if enclosed is not None:
                return enclosed
    elif x.p:
        rational = _rational(x.p, x.s, tolerance, unit)
        if rational is not None:
            return rational
    low, high = exact_ends(x, tolerance, unit)
    lo, hi = low.round_up(), high.round_down()
    if lo == inf or hi == -inf:
        lo, hi = rounding.LARGEST, -rounding.LARGEST
    nearest = float(x)
    if isinf(nearest):
        return Measure(lo, hi, copysign(rounding.LARGEST, nearest), 0.0, ulp(rounding.LARGEST))
    return Measure(lo, hi, nearest, _residual(x, nearest), ldexp(1.0, x.ulp_exponent()))


def _rational(p: int, s: int, tolerance: Tolerance, unit: Surd) -> Measure | None:
    """`measure` of p/s, not 0, by whole-number arithmetic; None for a size where doubles end or begin."""
    try:
        nearest = p / s  # int / int is correctly rounded
    except OverflowError:
        return None
    mantissa, exponent = frexp(nearest)
    if not nearest or abs(exponent) > _HUGE:
        return None
    top, bottom = nearest.as_integer_ratio()
    away = p * bottom - top * s
    if away and abs(mantissa) == 0.5:  # a power of two may be the nearest from either side
        return None
    exponent -= 53  # ulp(x) = 2**exponent
    ulp_n, ulp_d = (1 << exponent, 1) if exponent >= 0 else (1, 1 << -exponent)
    reach_n, reach_d = _reach(tolerance, unit)
    rel_n, rel_d = tolerance.relative.as_integer_ratio()
    if rel_n * abs(p) * reach_d > reach_n * rel_d * s:
        reach_n, reach_d = rel_n * abs(p), rel_d * s
    ulps_n, ulps_d = tolerance.ulps.as_integer_ratio()
    slack_n, slack_d = ulps_n * ulp_n, ulps_d * ulp_d
    alpha = (reach_n * slack_d + slack_n * reach_d) * s
    bottom_of_ends = s * reach_d * slack_d
    middle = p * reach_d * slack_d
    try:
        lo = _toward(middle - alpha, bottom_of_ends, inf)
        hi = _toward(middle + alpha, bottom_of_ends, -inf)
    except OverflowError:  # so wide that an end lies beyond the largest double
        return None
    return Measure(lo, hi, nearest, away * ulp_d / (s * bottom * ulp_n), ldexp(1.0, exponent))


def _toward(top: int, bottom: int, end: float) -> float:
    """The ratio as a double, rounded towards `end`, which is infinite."""
    double = top / bottom
    n, d = double.as_integer_ratio()
    short = n * bottom < top * d if end > 0 else n * bottom > top * d
    return nextafter(double, end) if short else double


def _slack(x: Surd, tolerance: Tolerance) -> tuple[int, int]:
    """ulps·ulp(x) as a ratio."""
    n, d = tolerance.ulps.as_integer_ratio()
    if n == 0:
        return 0, 1
    exponent = x.ulp_exponent()
    return (n << exponent, d) if exponent >= 0 else (n, d << -exponent)


def _reach(tolerance: Tolerance, unit: Surd) -> tuple[int, int]:
    """extent·unit as a ratio."""
    n, d = tolerance.extent.as_integer_ratio()
    if n and unit.q:
        raise ProblemError(
            "the tolerance extent needs an exact answer with a rational unit",
            remedy="give such a unit, or the tolerance as relative, zero and ulps",
        )
    return n * unit.p, d * unit.s


def _residual(x: Surd, nearest: float) -> float:
    """(x − nearest)/ulp(x), correctly rounded."""
    n, d = nearest.as_integer_ratio()
    if x.q == 0 and x.p * d == n * x.s:
        return 0.0
    return float((x - Fraction(n, d)) / x.ulp())


def _enclosed(x: Surd, tolerance: Tolerance, unit: Surd, roots: Roots, extra: int) -> Measure | None:
    """`measure` of an irrational x from one fixed-point enclosure, or None where that is not fine enough.

    All quantities are integers that count units of 2**-k; each pair encloses its exact value. A double
    comes out only where both ends of the enclosure round to it.
    """
    p, q, d, s = x.p, x.q, x.d, x.s
    reach = max(p.bit_length(), q.bit_length() + d.bit_length() // 2) - s.bit_length()
    wanted = _TOTAL_BITS + extra - reach
    if wanted < 0 or reach > _HUGE:
        return None
    k, root = roots(d, (wanted | 31) + 1)
    low, high = rounding.enclose(p, q, s, k, root)
    if low > 0:
        side, near, far = 1, low, high
    elif high < 0:
        side, near, far = -1, -high, -low
    else:
        return None
    exponent = near.bit_length() - 53  # ulp(x) = 2**exponent units
    if exponent <= 0 or far.bit_length() - 53 != exponent or exponent - k < rounding.LEAST_EXPONENT:
        return None
    half = 1 << exponent - 1
    top = near + half >> exponent
    if far + half >> exponent != top:
        return None
    inner, outer = widths(tolerance, unit, near, far, exponent, k)
    lo = rounding.range_up(low - outer, high - inner, k)
    hi = rounding.range_down(low + inner, high + outer, k)
    if lo is None or hi is None or isinf(lo) or isinf(hi):  # beyond the largest double
        return None
    residual = side * ((near - (top << exponent)) / (1 << exponent))
    return Measure(lo, hi, side * ldexp(top, exponent - k), residual, ldexp(1.0, exponent - k))


def widths(tolerance: Tolerance, unit: Surd, near: int, far: int, exponent: int, k: int) -> tuple[int, int]:
    """Integers below and above α in units of 2**-k, for an |x| between `near` and `far` units."""
    reach_n, reach_d = _reach(tolerance, unit)
    reach = (reach_n << k) // reach_d
    rel_n, rel_d = tolerance.relative.as_integer_ratio()
    ulps_n, ulps_d = tolerance.ulps.as_integer_ratio()
    slack = (ulps_n << exponent) // ulps_d
    return max(reach, near * rel_n // rel_d) + slack, max(reach, far * rel_n // rel_d) + slack + 2
