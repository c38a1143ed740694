"""loose-epsilon

The threshold is a millionth of the extent, wider than the promise: lines that clearly cross or miss
the circle become tangents. Choose it between the band of the tangents and the promised gap.
"""

from math import hypot, isclose


def line_count(cx, cy, r, A, B):
    if tuple(A) == tuple(B):
        return None
    ux, uy = A[0] - cx, A[1] - cy
    vx, vy = B[0] - cx, B[1] - cy
    scale = max(r, abs(ux), abs(uy), abs(vx), abs(vy))
    d = abs((B[0] - A[0]) * uy - (B[1] - A[1]) * ux) / hypot(B[0] - A[0], B[1] - A[1])
    if isclose(d, r, rel_tol=0, abs_tol=1e-6 * scale):
        return 1
    return 0 if d > r else 2
