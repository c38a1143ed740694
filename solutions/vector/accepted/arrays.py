"""Arrays, not objects: each number of all circles lies in one array, and every step is one operation on all of it.

The cross product, the distance and the size are formed as for one circle, with arrays in place of numbers. There is no
`if`: a comparison of arrays is an array of truths, and the answer is the sum of two of them. A circle counts once where
the line comes up to its touch, and once more where it goes beyond it.
"""

import numpy as np


def count_many(cx, cy, r, A, B):
    cx, cy, r = np.asarray(cx, dtype=float), np.asarray(cy, dtype=float), np.asarray(r, dtype=float)
    (ax, ay), (bx, by) = A, B
    dx, dy = bx - ax, by - ay
    fx, fy = ax - cx, ay - cy
    gap = np.abs(dx * fy - dy * fx)
    gap /= np.hypot(float(dx), float(dy))
    gap -= r
    near = np.maximum(r, np.abs(fx, out=fx))
    np.maximum(near, np.abs(fy, out=fy), out=near)
    np.maximum(near, np.abs(bx - cx), out=near)
    np.maximum(near, np.abs(by - cy), out=near)
    near *= 1e-10
    return (gap <= near).astype(np.int8) + (gap < -near)
