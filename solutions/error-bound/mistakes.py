"""How an error bound goes wrong: right ways to one, and mistakes beside the lines that they spoil."""

from fractions import Fraction
from math import inf, nextafter

U = 2.0**-53


def running(cx, cy, r, ax, ay, bx, by):
    "right"
    cx, cy, r, ax, ay, bx, by = map(float, (cx, cy, r, ax, ay, bx, by))
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    p, q = dx * fy, dy * fx
    # ? global-frame: p, q = dx * ay + dy * cx, dy * ax + dx * cy
    # : The products are those of the plane's own coordinates, and far from the origin they are all rounding.
    # : Subtract C from A first.
    k, m = p - q, abs(p) + abs(q)
    reach = r * r * (dx * dx + dy * dy)
    delta = reach - k * k
    # ? b2ac-form: delta = (fx * dx + fy * dy) ** 2 - (dx * dx + dy * dy) * (fx * fx + fy * fy - r * r)
    # ? wrong-sign: delta = k * k - reach
    # @ says how often they meet
    # : The sign of Δ is flipped: it is r²·a − k².
    bound = U * (12 * reach + 16 * m * abs(k)) + 64 * U * U * m * m
    # = bound = U * (20 * reach + 18 * m * abs(k)) + 70 * U * U * m * m
    # ? no-bound: bound = 0.0 if reach == m == 0 else 1e-300
    # ? one-ulp: bound = abs(delta) * 2 * U
    # ? absolute-bound: bound = {1e-15..1e-9/6}
    # @ nor does a constant
    # ? relative-to-result: bound = 1e-11 * abs(delta)
    # ? relative-to-result: bound = 32 * U * abs(delta)
    # ? ignores-cancellation: bound = U * (12 * reach + 16 * k * k)
    # ? too-wide: bound = 1e-9 * (reach + m * abs(k)) + 1e-9 * m * m
    # ? squared-terms: bound = U * (12 * reach + 16 * m * m)
    # : M² stands where M·|k| belongs: where the products cancel, k is much smaller than M.
    # ? no-square: bound = U * (12 * reach + 16 * m * abs(k))
    # ? b2ac-bound: bound = 8 * U * ((fx * dx + fy * dy) ** 2 + (dx * dx + dy * dy) * (fx * fx + fy * fy + r * r))
    if bound == 0:
        return 0.0, 0.0
        # ? no-degenerate: return nextafter(0.0, -inf), nextafter(0.0, inf)
        # @ If A and B are equal
    return nextafter(delta - bound, -inf), nextafter(delta + bound, inf)
    # ? inward: return nextafter(delta + bound, inf), nextafter(delta - bound, -inf)
    # ? one-sided-bound: return delta, nextafter(delta + bound, inf)
    # @ lo ≤ Δ ≤ hi
    # ? one-sided-bound: return nextafter(delta - bound, -inf), delta
    # : The bound is put on one side only. A rounding may go either way.


def exact(cx, cy, r, ax, ay, bx, by):
    "right"
    cx, cy, r, ax, ay, bx, by = map(Fraction, (cx, cy, r, ax, ay, bx, by))
    dx, dy = bx - ax, by - ay
    k = dx * (ay - cy) - dy * (ax - cx)
    delta = r * r * (dx * dx + dy * dy) - k * k
    near = float(delta)
    if near == delta:
        return near, near
    return nextafter(near, -inf), nextafter(near, inf)
    # ? no-bound: return near, near
    # : Δ is exact, and is then rounded to one double for both ends. It lies beside that: round one end down,
    # : the other one up.
    # ? inward: return nextafter(near, inf), nextafter(near, -inf)
