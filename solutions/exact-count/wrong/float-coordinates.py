"""float-coordinates

The arithmetic is exact, but the numbers were made floats before it began: from 2**53 on,
neighbouring integers become the same float. Leave them ints.
"""

from fractions import Fraction


def exact_count(cx, cy, r, A, B):
    cx, cy, r, ax, ay, bx, by = (Fraction(float(v)) for v in (cx, cy, r, A[0], A[1], B[0], B[1]))
    dx, dy = bx - ax, by - ay
    if dx == 0 and dy == 0:
        return None
    k = dx * (ay - cy) - dy * (ax - cx)
    delta = r**2 * (dx**2 + dy**2) - k**2
    return 0 if delta < 0 else 1 if delta == 0 else 2
