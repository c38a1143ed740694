"""mixed-units

d² and r² are areas, but the threshold they are compared with is a length, 1e-10 of the extent: too
wide for small figures, too narrow for large ones. Compare lengths with lengths, or multiply the
threshold by the extent once more.
"""


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    extent = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d_squared = (dx * fy - dy * fx) ** 2 / (dx * dx + dy * dy)
    difference = d_squared - r * r
    if abs(difference) <= 1e-10 * extent:
        return 1
    return 2 if difference < 0 else 0
