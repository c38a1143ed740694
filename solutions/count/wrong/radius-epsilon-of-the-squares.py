"""radius-epsilon

d² and r² are compared within 1e-10 of r². Rounding errors grow with the distance of A and B, which may be a
million radii away, and r = 0 leaves no room at all. Measure by the extent.
"""

def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    dd = (dx * fy - dy * fx) ** 2 / (dx * dx + dy * dy)
    if abs(dd - r * r) <= 1e-10 * r * r:
        return 1
    return 2 if dd < r * r else 0
