"""running-error-analysis

Δ in doubles, and beside it a bound of all roundings, each of which is at most u = 2**-53 of its result.

Why it holds: dx, dy, fx and fy are off by u of themselves, so each of the products p and q is off by three
u, and k by those and its own rounding: less than 4·u·M, for M = |p| + |q|. So k² is off by 8·u·M·|k| +
16·u²·M² and one rounding, and r²·a by less than 8·u of itself. The constants below are larger by half, for
the bound is made of rounded numbers itself, and the last difference is rounded as well.

Why it is narrow: no term is larger than what Δ is made of. b² − a·c has terms that are not.
"""

from math import inf, nextafter

U = 2.0**-53


def delta_enclosure(cx, cy, r, ax, ay, bx, by):
    cx, cy, r, ax, ay, bx, by = map(float, (cx, cy, r, ax, ay, bx, by))
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    p, q = dx * fy, dy * fx
    k, m = p - q, abs(p) + abs(q)
    reach = r * r * (dx * dx + dy * dy)
    delta = reach - k * k
    bound = U * (12 * reach + 16 * m * abs(k)) + 64 * U * U * m * m
    if bound == 0:
        return 0.0, 0.0
    return nextafter(delta - bound, -inf), nextafter(delta + bound, inf)
