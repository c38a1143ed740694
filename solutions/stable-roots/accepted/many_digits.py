"""sixty-digits

Everything in decimals of so many digits that a cancellation is no matter: products of doubles have 34, so
60 leave 26 of what remains. Even −b + √Δ may subtract then, but where Δ is nearly b² it has to be the
stable way: a·c may be 2**1200 times smaller.
"""

from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal, localcontext

PLENTY = Context(prec=400, Emin=MIN_EMIN, Emax=MAX_EMAX)
SIXTY = Context(prec=60, Emin=MIN_EMIN, Emax=MAX_EMAX)


def quadratic_roots(a, b, c):
    if a == 0 == b:
        return None if c == 0 else []
    if a == 0:
        return [-c / b / 2]
    with localcontext(SIXTY):
        # A double of 2**-600 has hundreds of digits: products of the leading 60 are too few for Δ = 0.
        with localcontext(PLENTY):
            delta = Decimal(b) * Decimal(b) - Decimal(a) * Decimal(c)
        if delta < 0:
            return []
        if delta == 0:
            return [float(Decimal(-b) / Decimal(a))]
        q = -(Decimal(b) + delta.sqrt().copy_sign(Decimal(b)))
        return sorted((float(q / Decimal(a)), float(Decimal(c) / q)))
