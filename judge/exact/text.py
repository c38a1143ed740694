"""Certified decimal digits of (p + q·√d)/s, and their layout."""

from __future__ import annotations

from judge.exact.rounding import magnitude

MOST_DIGITS = 4000  # Python itself refuses to print integers much longer


def decimal_digits(p: int, q: int, d: int, s: int, digits: int) -> tuple[str, int, bool]:
    """(text, exponent, exact): |x| is 0.text·10**(exponent + 1), rounded half-even to `digits` digits.

    √d must be irrational unless q == 0; zero gives ("0", 0, True). Raises ValueError for digits outside
    1 … MOST_DIGITS.
    """
    if not 1 <= digits <= MOST_DIGITS:
        raise ValueError(f"between 1 and {MOST_DIGITS} digits, not {digits}")
    side, m, k, _ = magnitude(p, q, d, s, 8)
    if side == 0:
        return "0", 0, True
    # 1233/4096 is close to log10(2): the guess errs by one at the magnitudes of doubles, and the loop puts
    # any guess right.
    exponent = (m.bit_length() - 1 - k) * 1233 >> 12
    bound = 10**digits
    while True:
        doubled, whole = _floor(p, q, d, s, digits - 1 - exponent)
        if doubled >= 2 * bound:
            exponent += 1
        elif 10 * doubled < 2 * bound:
            exponent -= 1
        else:
            break
    half = doubled & 1
    number = doubled >> 1
    exact = whole and not half
    if half and not (whole and number % 2 == 0):
        number += 1
    if number == bound:
        number, exponent = bound // 10, exponent + 1
    return str(number), exponent, exact


def _floor(p: int, q: int, d: int, s: int, power: int) -> tuple[int, bool]:
    """(floor(2·|x|·10**power), whether that is exact)."""
    if power >= 0:
        factor = 2 * 10**power
        p, q = p * factor, q * factor
    else:
        p, q, s = 2 * p, 2 * q, s * 10**-power
    _, m, k, exact = magnitude(p, q, d, s, 8)
    if k < 0:
        # m is cut above the point: ask again for all its bits.
        _, m, k, exact = magnitude(p, q, d, s, 8 - k)
    return m >> k, exact and (m >> k) << k == m


def layout(text: str, exponent: int, exact: bool) -> str:
    """Digits as a float's repr would set them: plain from 1e-4 to 1e16, else with an exponent."""
    if exact:
        text = text.rstrip("0") or "0"
    if -5 < exponent < 0:
        return "0." + "0" * (-exponent - 1) + text
    if 0 <= exponent < 16:
        whole = text[: exponent + 1].ljust(exponent + 1, "0")
        part = text[exponent + 1 :]
        return f"{whole}.{part}" if part else whole
    part = f".{text[1:]}" if len(text) > 1 else ""
    return f"{text[0]}{part}e{'-' if exponent < 0 else '+'}{abs(exponent):02d}"
