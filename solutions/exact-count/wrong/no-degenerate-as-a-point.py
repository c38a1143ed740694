"""no-degenerate

A == B is treated as a point that is on the circle, or not. There is no line then: return None first.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return 1 if (A[0] - cx) ** 2 + (A[1] - cy) ** 2 == r * r else 0
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    reach = r * r * (dx * dx + dy * dy)
    if k * k == reach:
        return 1
    return 2 if k * k < reach else 0
