"""absolute-epsilon

d² and r² are compared within a fixed 1e-9, which is an area. Compare lengths, and with a small part of the
extent.
"""

def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    square = (dx * fy - dy * fx) ** 2 / (dx * dx + dy * dy)
    if abs(square - r * r) < 1e-9:
        return 1
    return 2 if square < r * r else 0
