"""kept-between-calls

The ends' signs are remembered by the segment alone: the next circle gets those of the one before. Remember
nothing, or by all arguments.
"""

known = {}


def exact_segment(cx, cy, r, A, B):
    fx, fy, dx, dy = A[0] - cx, A[1] - cy, B[0] - A[0], B[1] - A[1]
    if (A, B) not in known:
        known[A, B] = fx * fx + fy * fy - r * r, (fx + dx) ** 2 + (fy + dy) ** 2 - r * r
    start, end = known[A, B]
    a, b = dx * dx + dy * dy, fx * dx + fy * dy
    if a == 0:
        return int(start == 0)
    delta = r * r * a - (dx * fy - dy * fx) ** 2
    if delta <= 0:
        return int(delta == 0 and 0 <= -b <= a)
    if start < 0 or end < 0:
        return int(start >= 0) + int(end >= 0)
    return 2 if 0 <= -b <= a else int(start == 0) + int(end == 0)
