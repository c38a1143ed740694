"""floor-division

`//` stands where `/` is meant, and the points snap to whole numbers.
Divide with `/`, which is exact enough for ints as well.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    fx, fy = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    near = 1e-10 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    a = dx * dx + dy * dy
    if a == 0:
        return [A] if abs(hypot(fx, fy) - r) <= near else []
    b = fx * dx + fy * dy
    k = dx * fy - dy * fx
    gap = r - abs(k) / sqrt(a)
    if gap < -near:
        return []
    root = sqrt(r * r * a - k * k) if gap > near else 0
    foot_x, foot_y = A[0] - b * dx // a, A[1] - b * dy // a
    found = []
    for s in sorted({-root, root}):
        if -near * sqrt(a) <= s - b <= a + near * sqrt(a):
            found.append((foot_x + s * dx / a, foot_y + s * dy / a))
    return found
