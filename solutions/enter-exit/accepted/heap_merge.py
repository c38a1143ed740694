"""heap merge

Every circle's hits are in order already: a heap holds the next one of each, and the least of them comes out first.
"""

from heapq import merge
from math import sqrt


def hits_of(index, circle, O, D, near):
    """The hits of one circle in order, by the quadratic in units of |D|², about the foot."""
    x, y, r = circle
    fx, fy = O[0] - x, O[1] - y
    a = D[0] * D[0] + D[1] * D[1]
    length = sqrt(a)
    k = (D[0] * fy - D[1] * fx) / length
    middle = -(fx * (D[0] / length) + fy * (D[1] / length)) / length
    if abs(k) - r > near:
        return
    if abs(abs(k) - r) <= near:
        yield middle, index, "touch"
        return
    half = sqrt((r - k) * (r + k)) / length
    yield middle - half, index, "enter"
    yield middle + half, index, "exit"


def all_hits(circles, O, D):
    near = 5e-11 * max(max(r, abs(x - O[0]), abs(y - O[1])) for x, y, r in circles)
    least = -near / max(abs(D[0]), abs(D[1]))
    streams = [hits_of(index, circle, O, D, near) for index, circle in enumerate(circles)]
    merged = merge(*streams, key=lambda hit: hit[0])
    return [(t if t > 0 else 0.0, index, tag) for t, index, tag in merged if t >= least]
