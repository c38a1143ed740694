"""float-coordinates

The points seen from the centre go through floats and become ints again: from 2⁵³ on they are other
points. Leave them ints.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    ax, ay, bx, by, r = (int(float(v)) for v in (A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy, r))
    k = ax * by - ay * bx
    reach = r * r * ((bx - ax) ** 2 + (by - ay) ** 2)
    if k * k == reach:
        return 1
    return 2 if k * k < reach else 0
