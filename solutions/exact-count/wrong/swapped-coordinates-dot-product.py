"""swapped-coordinates

The dot product of B − A and A − C stands where the cross product belongs. The cross product is dx·fy −
dy·fx.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[0] - cx) + dy * (A[1] - cy)
    reach = r * r * (dx * dx + dy * dy)
    if k * k == reach:
        return 1
    return 2 if k * k < reach else 0
