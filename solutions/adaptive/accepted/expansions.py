"""filter-and-expansions

Beyond the filter, all is computed in sums of doubles whose terms are the exact rounding errors (Knuth's
TwoSum, Dekker's TwoProduct, Shewchuk's expansions). `fsum` adds them without error but for its last one,
and the sign survives that.
"""

from math import frexp, fsum, ldexp


def two_sum(a, b):
    s = a + b
    t = s - a
    return s, (a - (s - t)) + (b - t)


def two_product(a, b):
    p = a * b
    big = 134217729.0 * a
    ah = big - (big - a)
    big = 134217729.0 * b
    bh = big - (big - b)
    al, bl = a - ah, b - bh
    return p, ((ah * bh - p) + ah * bl + al * bh) + al * bl


def grown(e, b):
    """The expansion e, smallest first, with b added: exact, its terms apart."""
    out = []
    for x in e:
        b, low = two_sum(b, x)
        if low:
            out.append(low)
    return [*out, b] if b or not out else out


def product(e, f):
    out = []
    for x in e:
        for y in f:
            high, low = two_product(x, y)
            out = grown(grown(out, low), high)
    return out or [0.0]


def added(e, f):
    for y in f:
        e = grown(e, y)
    return e


def exact(numbers):
    top = max(frexp(x)[1] for x in numbers if x) if any(numbers) else 0
    cx, cy, r, ax, ay, bx, by = (ldexp(float(x), -top) for x in numbers)  # so that no product underflows
    dx, dy, fx, fy = (list(two_sum(*pair)[::-1]) for pair in ((bx, -ax), (by, -ay), (ax, -cx), (ay, -cy)))
    k = added(product(dx, fy), [-x for x in product(dy, fx)])
    reach = product(product([r], [r]), added(product(dx, dx), product(dy, dy)))
    delta = fsum(added(reach, [-x for x in product(k, k)]))
    return (delta > 0) - (delta < 0)


def delta_sign(cx, cy, r, ax, ay, bx, by):
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    p, q = dx * fy, dy * fx
    k, m = p - q, abs(p) + abs(q)
    reach = r * r * (dx * dx + dy * dy)
    delta = reach - k * k
    bound = 2e-15 * (reach + m * abs(k)) + 2e-30 * m * m
    if delta > bound:
        return 1
    if -delta > bound:
        return -1
    return exact((cx, cy, r, ax, ay, bx, by))
