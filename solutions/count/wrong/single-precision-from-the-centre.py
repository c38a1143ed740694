"""single-precision

The centre is subtracted in doubles, but then everything is kept in 32-bit floats with a threshold to match.
The promised gap of 1e-7 is less than they can tell apart. Use doubles.
"""

from math import hypot, sqrt
from struct import pack, unpack


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    fx, fy, dx, dy, radius = unpack("5f", pack("5f", fx, fy, dx, dy, r))
    e = max(radius, abs(fx), abs(fy), abs(fx + dx), abs(fy + dy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(d - radius) <= 1e-6 * e:
        return 1
    return 2 if d < radius else 0
