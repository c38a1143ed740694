"""mixed-units

The discriminant is a fourth power of a length, the threshold is 1e-10 times a length: far too wide for
small figures, far too narrow for large ones. Compare lengths with lengths.
"""

def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    delta = r * r * (dx * dx + dy * dy) - (dx * fy - dy * fx) ** 2
    if abs(delta) <= 1e-10 * e:
        return 1
    return 2 if delta > 0 else 0
