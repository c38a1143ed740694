"""sqrt-of-negative

Under the root stands max(0, r² − d²), so that a line that misses the circle is a tangent. A negative number
there means that there is no common point: return 0 before taking the root.
"""

from math import hypot, sqrt


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    half = sqrt(max(0.0, (r - d) * (r + d))) if d < r - 1e-10 * e else 0.0
    return 2 if half else 1
