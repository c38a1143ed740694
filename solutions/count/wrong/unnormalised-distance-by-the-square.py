"""unnormalised-distance

The cross product is divided by |D|², not by |D|. It is the distance times |D|: divide by the root.
"""

def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / (dx * dx + dy * dy)
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
