"""float-coordinates

The numbers are read with float() and made ints again: from 2**53 on they are other ints. Read them as ints.
"""

def exact_count(cx, cy, r, A, B):
    cx, cy, r = int(float(cx)), int(float(cy)), int(float(r))
    A = int(float(A[0])), int(float(A[1]))
    B = int(float(B[0])), int(float(B[1]))
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    reach = r * r * (dx * dx + dy * dy)
    if k * k == reach:
        return 1
    return 2 if k * k < reach else 0
