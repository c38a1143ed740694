"""float-arithmetic

The distance is a quotient of floats and is compared with ==. A double has 53 bits: tangents and
near misses fall together, and beyond 1e308 there is no double at all. Compare r²·a with k² in ints.
"""

import math


def exact_count(cx, cy, r, A, B):
    if A == B:
        return None
    dx, dy = B[0] - A[0], B[1] - A[1]
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    d = abs(k) / math.sqrt(dx * dx + dy * dy)
    if d == r:
        return 1
    return 2 if d < r else 0
