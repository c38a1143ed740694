"""signs-of-the-ends-and-the-discriminant

Four signs decide: whether A is inside, whether B is, whether the line meets the circle, and whether the
foot of the perpendicular is on the segment.

Why it is exact: all four are signs of integers, sums and products of what is given. No root is taken
and nothing is divided, so no digit is lost at any size.

Why it is complete: along the segment the distance from C falls up to the foot and rises after it. If an
end is inside, a root lies on each side of that end, and the other end says whether the segment reaches
one. If no end is inside, the segment meets the inside only around the foot: so it has both roots if the
foot is on it, and otherwise none but an end that is on the circle itself.
"""


def exact_segment(cx, cy, r, A, B):
    fx, fy, gx, gy = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    dx, dy = gx - fx, gy - fy
    a = dx * dx + dy * dy
    end_a, end_b = fx * fx + fy * fy - r * r, gx * gx + gy * gy - r * r
    if a == 0:
        return int(end_a == 0)
    k = dx * fy - dy * fx
    delta = r * r * a - k * k
    if delta < 0:
        return 0
    between = 0 <= -(fx * dx + fy * dy) <= a
    if delta == 0:
        return int(between)
    if end_a < 0 or end_b < 0:
        return int(end_a >= 0) + int(end_b >= 0)
    if between:
        return 2
    return int(end_a == 0) + int(end_b == 0)
