"""Signs of sums of square roots over the integers, by squaring only: nothing here rounds."""

from __future__ import annotations


def sign(value: int) -> int:
    """-1, 0 or +1."""
    return (value > 0) - (value < 0)


def root_sign(p: int, q: int, d: int) -> int:
    """The sign of p + q·√d, d >= 0: equal signs decide, else that of p² − q²d does."""
    if q == 0 or d == 0:
        return (p > 0) - (p < 0)
    if p == 0:
        return 1 if q > 0 else -1
    if (p > 0) == (q > 0):
        return 1 if p > 0 else -1
    difference = p * p - q * q * d
    outcome = (difference > 0) - (difference < 0)
    return outcome if p > 0 else -outcome


def two_root_sign(p: int, q: int, d: int, u: int, e: int) -> int:
    """The sign of p + q·√d + u·√e, d and e >= 0, by one more squaring."""
    if d == e:
        return root_sign(p, q + u, d)
    left = root_sign(p, q, d)
    right = sign(u) if e else 0
    if left == right or right == 0:
        return left
    if left == 0:
        return right
    # Opposite signs: compare (p + q√d)² with u²e, again a number with the one root √d.
    return left * root_sign(p * p + q * q * d - u * u * e, 2 * p * q, d)
