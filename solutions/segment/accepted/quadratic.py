"""quadratic

The quadratic in t with the discriminant r²a - k² and the roots that do not cancel.

First the infinite line, then the segment. Whether the line touches is decided by the distance
|k| / |D| from the centre, within 1e-10 of the size: there it is one root, the foot of the
perpendicular, and never two equal ones.

Why r²a - k²: it equals b² - a·c by Lagrange's identity, but keeps its digits when the circle is small
and A far away. Why q: of the two textbook roots one subtracts nearly equal numbers; q adds them and
the other root is c / q.

Then the ends. The slack is a length along the line, and t counts in lengths of the segment, so the
slack on t is that length divided by |D|. It holds for the foot of a tangent as well, which may lie
beyond an end. The roots come in order of t, which is the order that is wanted.
"""

import math


def roots(a, b, c, half):
    """The two roots of a·t² + 2b·t + c, the lesser first; `half` is the root of the quarter discriminant."""
    q = -(b + math.copysign(half, b))
    first, second = q / a, c / q
    return (first, second) if first <= second else (second, first)


def circle_segment(cx, cy, r, A, B):
    fx, fy = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    size = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    near = size * 1e-10

    a = dx * dx + dy * dy
    if a == 0:
        gap = math.sqrt(fx * fx + fy * fy) - r
        return [A] if abs(gap) <= near else []
    b = fx * dx + fy * dy
    k = dx * fy - dy * fx
    length = math.sqrt(a)
    gap = abs(k) / length - r
    if gap > near:
        return []
    if gap >= -near:
        parameters = (-b / a,)
    else:
        parameters = roots(a, b, fx * fx + fy * fy - r * r, math.sqrt(r * r * a - k * k))

    slack = near / length
    inside = [t for t in parameters if -slack <= t <= 1 + slack]
    return [(A[0] + t * dx, A[1] + t * dy) for t in inside]
