"""zero-radius

A circle of radius 0 has no tangents here: a line through its centre gets 2. It is a single point: one point
in common.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    reach = r * r * (dx * dx + dy * dy)
    if k * k > reach:
        return 0
    return 1 if r > 0 and k * k == reach else 2
