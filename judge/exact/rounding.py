"""From integers to doubles: to nearest (half to even), down and up, subnormals and overflow included.

A magnitude x >= 0 is given as `(m, k, exact)`: m = floor(x·2**k), `exact` where nothing was cut off, and m at
least 55 bits long unless x = 0.
"""

from __future__ import annotations

import sys
from math import inf, isqrt, ldexp

LARGEST = sys.float_info.max
LEAST_EXPONENT = -1074  # of the least subnormal, and of every double's last bit at least


def magnitude(p: int, q: int, d: int, s: int, bits: int) -> tuple[int, int, int, bool]:
    """(sign, m, k, exact) of x = (p + q·√d)/s with s > 0; m = floor(|x|·2**k) has at least `bits` bits.

    √d must be irrational unless q == 0; x = 0 gives (0, 0, 0, True).
    """
    if q == 0:
        return _rational_magnitude(p, s, bits)
    square = q * q * d
    reach = max(p.bit_length(), (square.bit_length() + 1) // 2)
    if p and (p > 0) != (q > 0):
        # Cancellation: |x| = |p² − q²d| / (s·(|p| + |q|√d)) tells how small x is.
        conjugate = p * p - square
        positive = (conjugate > 0) == (p > 0)
        k = bits + 1 - conjugate.bit_length() + s.bit_length() + reach
    else:
        positive = q > 0
        k = bits - reach + s.bit_length()
    if not positive:
        p, q = -p, -q
    if k >= 0:
        root = isqrt(square << 2 * k)
        p <<= k
    else:
        root = isqrt(square)
        s <<= -k
    # √d is irrational, so that floor(−√…) is −root − 1 and nothing is ever exact.
    m = (p + root) // s if q > 0 else (p - root - 1) // s
    return (1 if positive else -1), m, k, False


def _rational_magnitude(p: int, s: int, bits: int) -> tuple[int, int, int, bool]:
    if p == 0:
        return 0, 0, 0, True
    k = bits - p.bit_length() + s.bit_length()
    m, rest = divmod(abs(p) << k, s) if k >= 0 else divmod(abs(p), s << -k)
    return (1 if p > 0 else -1), m, k, rest == 0


def scaled(m: int, exponent: int) -> float:
    """m·2**exponent for an m of at most 53 bits (or 2**53) that fits a double; inf beyond the largest."""
    try:
        return ldexp(m, exponent)
    except OverflowError:
        return inf


def to_nearest(m: int, k: int, exact: bool) -> float:
    """The double nearest to the magnitude, ties to even; inf where it rounds beyond the largest."""
    if not exact:
        m |= 1  # a sticky bit: m is long enough that its last bit only breaks ties
    if m.bit_length() - k > -1000:
        return scaled(m, -k)
    return m / (1 << k)  # subnormal results: int / int rounds once, correctly


def downward(m: int, k: int) -> float:
    """The greatest double at most the magnitude, exact or not: what was cut off lies above m."""
    cut = max(m.bit_length() - 53, k + LEAST_EXPONENT)
    return min(scaled(m >> cut if cut > 0 else m << -cut, cut - k), LARGEST)


def upward(m: int, k: int, exact: bool) -> float:
    """The least double at least the magnitude; inf beyond the largest."""
    cut = max(m.bit_length() - 53, k + LEAST_EXPONENT)
    if cut <= 0:
        return scaled((m << -cut) + (not exact), cut - k)
    top = -(-m >> cut)
    if not exact and top << cut == m:
        top += 1
    return scaled(top, cut - k)
