"""absolute-epsilon

r²·a − k², which is a fourth power of a length, is compared with 1e-9. Compare lengths, the distance with
the radius, and with a small part of the extent.
"""

def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    delta = r * r * (dx * dx + dy * dy) - (dx * fy - dy * fx) ** 2
    if abs(delta) < 1e-9:
        return 1
    return 2 if delta > 0 else 0
