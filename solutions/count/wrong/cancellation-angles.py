"""cancellation

The angle at A between the line and the way to C is compared with the arc sine of r/|A − C|. An arc sine near 1 has
half of its digits: a touch next to A is off by 1e-8. Compare the distance |k|/|D| with r, as lengths.
"""

from math import asin, atan2, hypot, isclose


def line_count(cx, cy, r, A, B):
    if tuple(A) == tuple(B):
        return None
    fx, fy = cx - A[0], cy - A[1]
    dx, dy = B[0] - A[0], B[1] - A[1]
    far = hypot(fx, fy)
    size = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    if far < r - 1e-9 * size:
        return 2
    between = atan2(abs(dx * fy - dy * fx), abs(dx * fx + dy * fy))
    if far <= r + 1e-9 * size:  # A is on the circle, or both are one point
        between, reach = (between, asin(1)) if r else (0.0, 0.0)
    else:
        reach = asin(r / far)
    if isclose(between, reach, rel_tol=0, abs_tol=1e-10 * size / far if far else 0):
        return 1
    return 2 if between < reach else 0
