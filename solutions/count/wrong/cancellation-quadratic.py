"""cancellation

The textbook discriminant b² − 4ac, in doubles: when A is far away it is the small difference of two huge
numbers, and no threshold repairs that. Write it as r²·a − k² with the cross product k.
"""

def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    a = float(dx) ** 2 + float(dy) ** 2
    b = 2 * (float(fx) * dx + float(fy) * dy)
    c = float(fx) ** 2 + float(fy) ** 2 - r * r
    near = 1e-10 * e * 8 * r * a
    if abs(b * b - 4 * a * c) <= near:
        return 1
    return 2 if b * b > 4 * a * c else 0
