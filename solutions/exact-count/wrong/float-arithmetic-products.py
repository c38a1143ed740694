"""float-arithmetic

The differences are exact, but they are made floats before they are multiplied, and k² and r²·a are rounded.
Compare r²·a with k² in ints.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    dx, dy, radius = float(dx), float(dy), float(r)
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    reach = radius * radius * (dx * dx + dy * dy)
    if k * k == reach:
        return 1
    return 2 if k * k < reach else 0
