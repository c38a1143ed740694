"""slope-intercept

The line is written y = m·x + q, which a vertical line cannot be; a vertical one is nudged by 1e-9.
Write it as A + t·(B - A), which knows no special direction.
"""

from math import sqrt


def circle_segment(cx, cy, r, A, B):
    x1, y1, x2, y2 = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    near = 1e-10 * max(r, abs(x1), abs(y1), abs(x2), abs(y2))
    if x1 == x2 and y1 == y2:
        return [A] if abs(sqrt(x1 * x1 + y1 * y1) - r) <= near else []
    if x1 == x2:
        x2 += 1e-9
    m = (y2 - y1) / (x2 - x1)
    q = y1 - m * x1
    gap = abs(q) / sqrt(1 + m * m) - r
    if gap > near:
        return []
    if gap >= -near:
        xs = [-m * q / (1 + m * m)]
    else:
        root = sqrt(r * r * (1 + m * m) - q * q)
        xs = [(-m * q - root) / (1 + m * m), (-m * q + root) / (1 + m * m)]
        if x2 < x1:
            xs.reverse()
    points = []
    for x in xs:
        y = m * x + q
        if min(x1, x2) - near <= x <= max(x1, x2) + near and min(y1, y2) - near <= y <= max(y1, y2) + near:
            points.append((cx + x, cy + y))
    return points
