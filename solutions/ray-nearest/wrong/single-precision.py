"""single-precision

The numbers are kept as 32-bit floats, which hold seven digits.
Python's float is a double: keep it.
"""

from math import copysign, hypot, sqrt
from struct import pack, unpack


def ray_nearest(cx, cy, r, O, D):
    cx, cy, r, ox, oy, dx, dy = unpack("7f", pack("7f", cx, cy, r, *O, *D))
    n = hypot(dx, dy)
    if n == 0:
        return None
    fx, fy = ox - cx, oy - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    d = abs(dx * fy - dy * fx) / n
    m = -(fx * dx + fy * dy) / n
    if d > r + near:
        return None
    if d >= r - near:
        roots = [m]
    else:
        outer = m + copysign(sqrt((r - d) * (r + d)), m)
        roots = sorted([outer, (fx * fx + fy * fy - r * r) / outer])
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
