"""Select: one row a quantity, the two conditions side by side, and `np.select` for the three cases.

The distance comes from the normal form about A: the line's unit normal by the circles' places, which are taken from A, so
that nothing large is subtracted.
"""

import numpy as np


def count_many(cx, cy, r, A, B):
    x, y = np.array(cx, dtype=float), np.array(cy, dtype=float)
    r = np.array(r, dtype=float)
    x -= A[0]
    y -= A[1]
    dx, dy = B[0] - A[0], B[1] - A[1]
    length = np.hypot(float(dx), float(dy))
    distance = np.abs(y * (dx / length) - x * (dy / length))
    size = np.maximum.reduce([r, np.abs(x), np.abs(y), np.abs(x - dx), np.abs(y - dy)])
    near = 1e-10 * size
    apart = distance - r
    return np.select([apart > near, apart < -near], [0, 2], 1).astype("i1")
