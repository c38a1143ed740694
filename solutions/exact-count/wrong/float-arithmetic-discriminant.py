"""float-arithmetic

b² − a·c in doubles. The two terms are large and nearly equal, and what is left of their difference is
rounding. Compute in ints, where r²·a − k² also stays small.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    a = float(dx * dx + dy * dy)
    b = float(fx * dx + fy * dy)
    c = float(fx * fx + fy * fy - r * r)
    delta = b * b - a * c
    if delta == 0:
        return 1
    return 2 if delta > 0 else 0
