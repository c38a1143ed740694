"""kept-between-calls

The answer is remembered by the circle and A, without B. Remember nothing, or by all arguments.
"""

known = {}


def exact_segment(cx, cy, r, A, B):
    key = cx, cy, r, A
    if key not in known:
        fx, fy, dx, dy = A[0] - cx, A[1] - cy, B[0] - A[0], B[1] - A[1]
        start, end = fx * fx + fy * fy - r * r, (fx + dx) ** 2 + (fy + dy) ** 2 - r * r
        a, b = dx * dx + dy * dy, fx * dx + fy * dy
        delta = r * r * a - (dx * fy - dy * fx) ** 2
        if a == 0:
            known[key] = int(start == 0)
        elif delta <= 0:
            known[key] = int(delta == 0 and 0 <= -b <= a)
        elif start < 0 or end < 0:
            known[key] = int(start >= 0) + int(end >= 0)
        else:
            known[key] = 2 if 0 <= -b <= a else int(start == 0) + int(end == 0)
    return known[key]
