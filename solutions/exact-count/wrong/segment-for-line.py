"""segment-for-line

Points beyond A or B are left out. The question is about the infinite line, so nothing but the
discriminant matters.
"""


def exact_count(cx, cy, r, A, B):
    ax, ay, bx, by = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    dx, dy = bx - ax, by - ay
    a, b = dx * dx + dy * dy, ax * dx + ay * dy
    if a == 0:
        return None
    start, end = ax * ax + ay * ay - r * r, bx * bx + by * by - r * r
    delta = b * b - a * start
    if delta < 0 or (start < 0 and end < 0):
        return 0
    if start * end < 0:
        return 1
    if not 0 <= -b <= a:
        return int(start == 0) + int(end == 0)
    return 2 if delta else 1
