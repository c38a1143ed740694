"""swapped-coordinates

The cross product of a and b is taken as ax·bx − ay·by. It is ax·by − ay·bx.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    ax, ay, bx, by = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    k = ax * bx - ay * by
    reach = r * r * (dx * dx + dy * dy)
    if k * k == reach:
        return 1
    return 2 if k * k < reach else 0
