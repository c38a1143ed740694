"""single-precision

All numbers are held in 32-bit floats, with 24 bits each, and the threshold is chosen to match. The
promised gap of 1e-7 of the extent is smaller than what they can tell apart. Use doubles.
"""

from math import hypot
from struct import pack, unpack


def single(x):
    return unpack("f", pack("f", x))[0]


def line_count(cx, cy, r, A, B):
    cx, cy, r, ax, ay, bx, by = map(single, (cx, cy, r, A[0], A[1], B[0], B[1]))
    dx, dy = single(bx - ax), single(by - ay)
    if dx == 0 and dy == 0:
        return None
    fx, fy = single(ax - cx), single(ay - cy)
    cross = single(single(dx * fy) - single(dy * fx))
    d = single(abs(cross) / single(hypot(dx, dy)))
    extent = max(r, abs(fx), abs(fy), abs(single(bx - cx)), abs(single(by - cy)))
    if abs(d - r) <= 4e-7 * extent:
        return 1
    return 2 if d < r else 0
