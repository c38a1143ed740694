"""equality-tangency

k²/a is compared with r² by ==. After a division it is hardly ever the same double. Compare within a small
fraction of the extent.
"""

def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    square = (dx * fy - dy * fx) ** 2 / (dx * dx + dy * dy)
    if square == r * r:
        return 1
    return 2 if square < r * r else 0
