"""the widest tolerance

d is compared with r within 1e-8 of each circle's own size.
"""

import numpy as np


def count_many(cx, cy, r, A, B):
    cx, cy, r = (np.asarray(column, dtype=float) for column in (cx, cy, r))
    fx, fy, gx, gy = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    dx, dy = float(B[0] - A[0]), float(B[1] - A[1])
    size = np.maximum.reduce([r, abs(fx), abs(fy), abs(gx), abs(gy)])
    gap = abs(dx * fy - dy * fx) / np.hypot(dx, dy) - r
    return (gap <= 1e-8 * size).astype(np.int8) + (gap < -1e-8 * size)
