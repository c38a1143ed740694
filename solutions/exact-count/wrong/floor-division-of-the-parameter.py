"""floor-division

The parameter of the foot is found with //, so that it is always a whole number, and the foot with it a
corner of the grid. Keep the denominator, or multiply through.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    t = -(fx * dx + fy * dy) // (dx * dx + dy * dy)
    square = (fx + t * dx) ** 2 + (fy + t * dy) ** 2
    if square == r * r:
        return 1
    return 2 if square < r * r else 0
