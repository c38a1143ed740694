"""inside-ends

The circle is taken for a disc: an end that lies inside it is returned as a point of the answer.
The circle is the curve; an end inside it is nothing.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    bx, by = B[0] - cx, B[1] - cy
    near = 1e-10 * max(r, abs(ax), abs(ay), abs(bx), abs(by))
    n = hypot(bx - ax, by - ay)
    if n == 0:
        return [A] if hypot(ax, ay) <= r + near else []
    ux, uy = (bx - ax) / n, (by - ay) / n
    d = abs(ux * ay - uy * ax)
    if d > r + near:
        return []
    mid = -(ux * ax + uy * ay)
    half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
    first, last = max(0.0, mid - half), min(n, mid + half)
    if first > last + near:
        return []
    ends = [first] if last - first <= near else [first, last]
    return [(A[0] + s * ux, A[1] + s * uy) for s in ends]
