"""single-precision

The input is stored in an array of 32-bit floats, with a threshold of a millionth to match; what comes
after is computed in doubles, but the digits are gone. Use an array of doubles, or none.
"""

from array import array
from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    cx, cy, r, ax, ay, bx, by = array("f", [cx, cy, r, *A, *B])
    fx, fy = ax - cx, ay - cy
    dx, dy = bx - ax, by - ay
    eps = 1e-6 * max(r, abs(fx), abs(fy), abs(bx - cx), abs(by - cy))
    n = hypot(dx, dy)
    if n == 0:
        return [(ax, ay)] if abs(hypot(fx, fy) - r) <= eps else []
    ux, uy = dx / n, dy / n
    d = abs(ux * fy - uy * fx)
    mid = -(ux * fx + uy * fy)
    if d > r + eps:
        return []
    half = sqrt((r - d) * (r + d)) if d < r - eps else 0
    steps = [mid - half, mid + half] if half else [mid]
    return [(ax + s * ux, ay + s * uy) for s in steps if -eps <= s <= n + eps]
