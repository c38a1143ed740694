"""global-frame

The centre is not moved to the origin: cx² + cy² and the like drown r² when the figure is far away.
Subtract C from A and B first, and compute with the differences.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    (x1, y1), (x2, y2) = A, B
    near = 1e-10 * max(r, abs(x1 - cx), abs(y1 - cy), abs(x2 - cx), abs(y2 - cy))
    if x1 == x2 and y1 == y2:
        return [A] if abs(hypot(x1 - cx, y1 - cy) - r) <= near else []
    # p·x + q·y = s with p² + q² = 1
    n = hypot(x2 - x1, y2 - y1)
    p, q = (y2 - y1) / n, (x1 - x2) / n
    s = p * x1 + q * y1
    d = s - p * cx - q * cy
    if abs(d) > r + near:
        return []
    foot_x, foot_y = cx + p * d, cy + q * d
    if abs(d) >= r - near:
        steps = [0]
    else:
        steps = [-sqrt(r * r - d * d), sqrt(r * r - d * d)]
    answer = []
    for h in steps:
        x, y = foot_x - q * h, foot_y + p * h
        t = ((x - x1) * (x2 - x1) + (y - y1) * (y2 - y1)) / n
        if -near <= t <= n + near:
            answer.append((x, y))
    return answer
