"""loose-epsilon

k² and r²·a within a millionth of each other pass for equal. Here there is no tolerance at all: compare with
==, in ints.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    reach = r * r * (dx * dx + dy * dy)
    if abs(k * k - reach) * 10**6 <= reach:
        return 1
    return 2 if k * k < reach else 0
