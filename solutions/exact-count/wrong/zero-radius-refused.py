"""zero-radius

A radius of 0 raises an error. The statement allows it: the circle is the point C, and a line through C has
one point in common with it.
"""

def exact_count(cx, cy, r, A, B):
    if r <= 0:
        raise ValueError("the radius must be positive")
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    reach = r * r * (dx * dx + dy * dy)
    if k * k == reach:
        return 1
    return 2 if k * k < reach else 0
