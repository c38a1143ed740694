"""float-coordinates

The coordinates seen from the centre are made floats, and from 2**53 on neighbouring integers are the same
one. Leave them ints.
"""

from fractions import Fraction


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy, dx, dy, r = (Fraction(float(v)) for v in (A[0] - cx, A[1] - cy, dx, dy, r))
    k = dx * fy - dy * fx
    reach = r * r * (dx * dx + dy * dy)
    if k * k == reach:
        return 1
    return 2 if k * k < reach else 0
