"""two-products-in-doubles

Doubles only. a, b and c are scaled by powers of two, each product is kept as a sum of two doubles (Veltkamp
and Dekker), and the difference of the leading parts is exact wherever it cancels (Kahan).
"""

from math import frexp, ldexp, sqrt


def halves(x):
    """x as a sum of two doubles of 26 bits."""
    big = 134217729.0 * x
    high = big - (big - x)
    return high, x - high


def product(x, y):
    """x·y as a double and what it rounds off."""
    p = x * y
    (a, b), (c, d) = halves(x), halves(y)
    return p, ((a * c - p) + a * d + b * c) + b * d


def quadratic_roots(a, b, c):
    a, b, c = float(a), float(b), float(c)
    if a == 0.0:
        if b == 0.0:
            return None if c == 0.0 else []
        return [-c / b / 2]
    (ma, ea), (mb, eb) = frexp(a), frexp(b)
    if c == 0.0:
        return sorted({0.0, -(mb / ma) * 2.0 * 2.0 ** (eb - ea)})
    mc, ec = frexp(c)
    if (ea + ec) % 2:  # t = 2**half · u makes a and c alike in size
        mc, ec = mc / 2, ec + 1
    half, level = (ec - ea) // 2, (ea + ec) // 2
    if b == 0.0 or eb - level < -200:
        mb = 0.0 if b == 0.0 else ldexp(mb, -200)
    elif eb - level > 200:  # a·c is nothing beside b²
        return sorted((-2.0 * (mb / ma) * 2.0 ** (eb - ea), -(mc / mb) / 2.0 * 2.0 ** (ec - eb)))
    else:
        mb = ldexp(mb, eb - level)
    p, low_p = product(mb, mb)
    q, low_q = product(ma, mc)
    delta = (p - q) + (low_p - low_q)
    if delta < 0.0:
        return []
    if delta == 0.0:
        return [ldexp(-mb / ma, half)]
    s = sqrt(delta)
    total = -(mb + s) if mb >= 0.0 else s - mb
    return sorted((ldexp(total / ma, half), ldexp(mc / total, half)))
