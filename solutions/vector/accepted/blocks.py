"""Blocks: the arrays are taken in pieces that fit into the cache, and the size is computed for those only that need it.

A quick look in single precision, about the line's first point, decides what is clear by a thousandth of the size (taken
too large, from sums). Only the circles near a touch, few in most scenes, are looked at once more in double precision.
"""

import numpy as np

BLOCK = 1 << 15


def count_many(cx, cy, r, A, B):
    n = len(cx)
    cx, cy, r = (np.asarray(v, dtype=np.float64) for v in (cx, cy, r))
    out = np.empty(n, dtype=np.int8)
    for start in range(0, n, BLOCK):
        part = slice(start, start + BLOCK)
        out[part] = block(cx[part], cy[part], r[part], A, B)
    return out


def block(cx, cy, r, A, B):
    (ax, ay), (bx, by) = A, B
    dx, dy = float(bx - ax), float(by - ay)
    length = float(np.hypot(dx, dy))
    ux, uy = np.float32(dx / length), np.float32(dy / length)
    fx, fy, radius = ((v.astype(np.float32)) for v in (ax - cx, ay - cy, r))
    gap = np.abs(ux * fy - uy * fx) - radius
    coarse = (np.abs(fx) + np.abs(fy) + np.float32(length)) * np.float32(1e-5)
    answer = np.where(gap < 0, np.int8(2), np.int8(0))
    close = np.flatnonzero(np.abs(gap) <= coarse)
    if close.size:
        answer[close] = exactly(cx[close], cy[close], r[close], A, B, length)
    return answer


def exactly(cx, cy, r, A, B, length):
    (ax, ay), (bx, by) = A, B
    fx, fy = ax - cx, ay - cy
    gap = np.abs((bx - ax) * fy - (by - ay) * fx) / length - r
    near = 1e-10 * np.max([r, np.abs(fx), np.abs(fy), np.abs(bx - cx), np.abs(by - cy)], axis=0)
    return np.where(gap > near, 0, np.where(gap < -near, 2, 1))
