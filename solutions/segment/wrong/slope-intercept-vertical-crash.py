"""slope-intercept

The line is written y = m·x + q, which a vertical line cannot be: the division by zero ends the program.
Write it as A + t·(B − A), which knows no special direction.
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
    m = (by - ay) / (bx - ax)
    q = ay - m * ax
    d = abs(q) / sqrt(1 + m * m)
    if d > r + near:
        return []
    root = sqrt((r - d) * (r + d) / (1 + m * m)) if d < r - near else 0.0
    middle = -m * q / (1 + m * m)
    places = [((x - ax) * length) / (bx - ax) for x in sorted({middle - root, middle + root}, reverse=bx < ax)]
    return [(A[0] + s * ux, A[1] + s * uy) for s in places if -near <= s <= length + near]
