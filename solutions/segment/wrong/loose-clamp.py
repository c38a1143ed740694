"""loose-clamp

A root is kept if -1e-5 <= t <= 1 + 1e-5, so that points clearly beyond an end are called points of the segment.
Use a slack well below the promise's wider band: 1e-10 of the extent.
"""

from math import sqrt


def circle_segment(cx, cy, r, A, B):
    fx, fy = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    near = 1e-10 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    a = dx * dx + dy * dy
    if a == 0:
        return [A] if abs(sqrt(fx * fx + fy * fy) - r) <= near else []
    b = fx * dx + fy * dy
    k = dx * fy - dy * fx
    gap = r - abs(k) / sqrt(a)
    if gap < -near:
        return []
    root = sqrt(r * r * a - k * k) if gap > near else 0.0
    ts = [(-b - root) / a, (-b + root) / a] if root else [-b / a]
    return [(A[0] + t * dx, A[1] + t * dy) for t in ts if -1e-5 <= t <= 1.00001]
