"""fractions

What doubles can tell by a millionth of a circle's size is told in arrays; the few other circles are asked in fractions,
where Δ = r²·|D|² − k² is exact.
"""

from fractions import Fraction

import numpy as np


def exactly(x, y, r, A, B):
    x, y, r, ax, ay, bx, by = map(Fraction, (x, y, r, *A, *B))
    dx, dy = bx - ax, by - ay
    delta = r * r * (dx * dx + dy * dy) - (dx * (ay - y) - dy * (ax - x)) ** 2
    return 1 + (delta > 0) - (delta < 0)


def count_many(cx, cy, r, A, B):
    cx, cy, r = (np.asarray(column, dtype=float) for column in (cx, cy, r))
    fx, fy, gx, gy = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    dx, dy = float(B[0] - A[0]), float(B[1] - A[1])
    gap = abs(dx * fy - dy * fx) / np.hypot(dx, dy) - r
    answer = np.where(gap < 0, 2, 0).astype(np.int8)
    for i in np.flatnonzero(abs(gap) <= 1e-6 * np.maximum.reduce([r, abs(fx), abs(fy), abs(gx), abs(gy)])):
        answer[i] = exactly(float(cx[i]), float(cy[i]), float(r[i]), A, B)
    return answer
