"""overflow-64

The products are held in 64-bit integers that stop at their greatest value, and from there on all are equal.
Python's ints have no greatest value; elsewhere use a type wide enough for the fourth power of a coordinate.
"""

def saturated(n):
    return max(-(2**63), min(2**63 - 1, n))


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = saturated(dx * (A[1] - cy) - dy * (A[0] - cx))
    left, reach = saturated(k * k), saturated(r * r * (dx * dx + dy * dy))
    if left == reach:
        return 1
    return 2 if left < reach else 0
