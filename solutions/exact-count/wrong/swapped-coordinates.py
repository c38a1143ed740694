"""swapped-coordinates

x and y are mixed up in the product, which is neither the cross product nor the dot product. The
cross product is dx·fy - dy·fx.
"""


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    fx, fy = A[0] - cx, A[1] - cy
    if dx == 0 == dy:
        return None
    k = dx * fx - dy * fy
    delta = r * r * (dx * dx + dy * dy) - k * k
    if delta == 0:
        return 1
    return 2 if delta > 0 else 0
