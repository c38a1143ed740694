"""filter-and-integers

Δ in doubles with a bound of all its roundings; only where |Δ| is within the bound, the integers decide.

Why the filter is sound: with u = 2**-53, dx, dy, fx and fy are off by u of themselves, the products p and q
by three u, and k = p − q by less than 4·u·M for M = |p| + |q|. So k² is off by 8·u·M·|k| + 16·u²·M² and
its own rounding, and r²·a by less than 8·u of itself. The bound is twice that and more, for it is rounded
itself. A tiny number is added against a bound of 0.

Why it is fast: a random line is decided by the first comparison or the second. The exact way takes fifty
times as long, and is taken for tangents and what is a few units beside them.
"""


def exact(*numbers):
    ratios = [x.as_integer_ratio() for x in numbers]
    unit = max([bottom for _, bottom in ratios])
    cx, cy, r, ax, ay, bx, by = [top * (unit // bottom) for top, bottom in ratios]
    dx, dy = bx - ax, by - ay
    k = dx * (ay - cy) - dy * (ax - cx)
    delta = r * r * (dx * dx + dy * dy) - k * k
    return (delta > 0) - (delta < 0)


def delta_sign(cx, cy, r, ax, ay, bx, by):
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    p, q = dx * fy, dy * fx
    k, m = p - q, abs(p) + abs(q)
    reach = r * r * (dx * dx + dy * dy)
    delta = reach - k * k
    bound = 1.2e-16 * (16 * reach + 18 * m * abs(k)) + 1.3e-30 * m * m
    if delta > bound:
        return 1
    if delta < -bound:
        return -1
    return exact(cx, cy, r, ax, ay, bx, by)
